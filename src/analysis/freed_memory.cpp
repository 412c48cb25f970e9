// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/freed_memory.h"

#include <algorithm>
#include <utility>

#include "analysis/beside.h"
#include "session/session.h"

namespace hitscope {

FreedMemory::FreedMemory(Session& session, std::function<void()> giveBack, QObject* parent)
    : QObject(parent), m_session(session), m_giveBack(std::move(giveBack)), m_large(largeMeshes()) {
    for (const auto& [timer, wait] : {std::pair(&m_soon, kSoon), std::pair(&m_later, kLater)}) {
        timer->setSingleShot(true);
        timer->setInterval(wait);
        connect(timer, &QTimer::timeout, this,
                [this] { workBeside(this, m_giveBack, [](FreedMemory& /*self*/, bool /*done*/) {}); });
    }
    connect(&session, &Session::sceneReplaced, this, &FreedMemory::follow);
    connect(&session.targets(), &SessionTargets::added, this, &FreedMemory::follow);
    connect(&session.targets(), &SessionTargets::removed, this, &FreedMemory::follow);
}

void FreedMemory::follow() {
    const std::set<const MeshData*> before = std::exchange(m_large, largeMeshes());
    if (!std::includes(m_large.begin(), m_large.end(), before.begin(), before.end())) {
        m_soon.start();
        m_later.start();
    }
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
