// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/freed_memory.h"

#include <algorithm>
#include <utility>

#include "analysis/beside.h"
#include "session/session.h"

namespace hitscope {

FreedMemory::FreedMemory(Session& session, std::function<void()> giveBack, QObject* parent)
    : QObject(parent), m_session(session), m_giveBack(std::move(giveBack)), m_large(largeMeshes()) {
    m_soon.setSingleShot(true);
    m_later.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &FreedMemory::giveBack);
    connect(&m_later, &QTimer::timeout, this, &FreedMemory::giveBackInTheEnd);
    connect(&session.tasks(), &TaskList::changed, this, [this] {
        if (m_isNew && m_session.tasks().size() == 0) {
            m_later.start(kSoon);
        }
    });
    connect(&session, &Session::sceneReplaced, this, &FreedMemory::follow);
    connect(&session.targets(), &SessionTargets::added, this, &FreedMemory::follow);
    connect(&session.targets(), &SessionTargets::removed, this, &FreedMemory::follow);
}

void FreedMemory::follow() {
    const std::set<const MeshData*> before = std::exchange(m_large, largeMeshes());
    if (!std::includes(m_large.begin(), m_large.end(), before.begin(), before.end())) {
        m_soon.start(kSoon);
        m_later.start(kLater);
    }
    if (!std::includes(before.begin(), before.end(), m_large.begin(), m_large.end())) {
        m_isNew = true;
        m_later.start(kLater);
    }
}

/// Of a mesh that has come once the long tasks are done: each that ends starts the timer anew.
void FreedMemory::giveBackInTheEnd() {
    if (m_isNew && m_session.tasks().size() > 0) {
        return;
    }
    m_isNew = false;
    giveBack();
}

void FreedMemory::giveBack() {
    workBeside(this, m_giveBack, [](FreedMemory& /*self*/, bool /*done*/) {});
}

std::set<const MeshData*> FreedMemory::largeMeshes() const {
    std::set<const MeshData*> meshes;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const MeshData& mesh = target->deformed.original();
        if (mesh.vertexCount() >= kLarge) {
            meshes.insert(&mesh);
        }
    }
    return meshes;
}

}  // namespace hitscope
