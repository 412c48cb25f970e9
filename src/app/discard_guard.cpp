// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/discard_guard.h"

#include <QEventLoop>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <bit>
#include <utility>

#include "models/quantity_text.h"

namespace hitscope {

namespace {

constexpr std::uint64_t kStart = 0xcbf29ce484222325u;  // FNV-1a

void mix(std::uint64_t& state, std::uint64_t value) {
    state = (state ^ value) * 0x100000001b3u;
}

void mix(std::uint64_t& state, float value) {
    mix(state, std::uint64_t{std::bit_cast<std::uint32_t>(value)});
}

void mix(std::uint64_t& state, const Hit& hit) {
    for (int i = 0; i < 3; ++i) {
        mix(state, hit.point[i]);
        mix(state, hit.direction[i]);
    }
    mix(state, hit.constants.maxDistance);
    mix(state, hit.constants.power);
    mix(state, hit.constants.maxMagnitude);
    mix(state, std::uint64_t{hit.enabled});
}

}  // namespace

DiscardGuard::DiscardGuard(Session& session, QWidget& window, BeginExport beginExport)
    : QObject(&window), m_session(session), m_window(window), m_beginExport(std::move(beginExport)) {
    connect(&session, &Session::sceneReplaced, this, [this] {
        m_exported.clear();
        m_writing.clear();  // targets of the scene before
        m_letGo.reset();
        m_writingHits.reset();
    });
}

std::map<TargetId, DiscardGuard::State> DiscardGuard::states(std::span<const Hit> hits) const {
    std::map<TargetId, State> states;
    for (const Hit& hit : hits) {
        mix(states.try_emplace(hit.target, kStart).first->second, hit);
    }
    return states;
}

DiscardGuard::State DiscardGuard::stateOfAll() const {
    State state = kStart;
    for (const Hit& hit : m_session.hits().history().hits()) {
        mix(state, hit);
    }
    return state;
}

std::vector<TargetId> DiscardGuard::targetsAtRisk() const {
    std::vector<TargetId> targets;
    if (m_session.hits().history().size() == 0 || m_letGo == stateOfAll()) {
        return targets;
    }
    for (const auto& [target, state] : states(m_session.hits().history().hits())) {
        const auto exported = m_exported.find(target);
        if (exported == m_exported.end() || exported->second != state) {
            targets.push_back(target);
        }
    }
    return targets;
}

std::size_t DiscardGuard::hitsAtRisk() const {
    const std::vector<TargetId> targets = targetsAtRisk();
    const std::span<const Hit> hits = m_session.hits().history().hits();
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [&targets](const Hit& hit) {
        return std::find(targets.begin(), targets.end(), hit.target) != targets.end();
    }));
}

QMessageBox* DiscardGuard::makeBox() {
    const std::size_t hits = hitsAtRisk();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Discard hits"),
                                hits == 1 ? tr("1 hit on this scene will be lost.")
                                          : tr("%1 hits on this scene will be lost.").arg(countText(hits)),
                                QMessageBox::NoButton, &m_window);
    box->setObjectName(QStringLiteral("discardHits"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(tr("Export the deformed mesh to keep what they did."));
    box->addButton(tr("&Export…"), QMessageBox::AcceptRole);
    box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    box->setDefaultButton(box->addButton(QMessageBox::Cancel));
    m_box = box;
    return box;
}

void DiscardGuard::ask(std::function<void()> then) {
    if (!isAtRisk()) {
        then();
        return;
    }
    if (m_box != nullptr) {  // one question at a time
        m_box->raise();
        m_box->activateWindow();
        return;
    }
    QMessageBox* box = makeBox();
    connect(box, &QDialog::finished, this, [this, box, act = std::move(then)] {
        m_box.clear();
        take(*box, act);
    });
    box->open();
}

void DiscardGuard::take(QMessageBox& box, const std::function<void()>& then) {
    const QAbstractButton* const clicked = box.clickedButton();
    const QMessageBox::ButtonRole role =
        clicked != nullptr ? box.buttonRole(box.clickedButton()) : QMessageBox::RejectRole;
    if (role == QMessageBox::DestructiveRole) {
        then();
    } else if (role == QMessageBox::AcceptRole) {
        exportAnd(then);
    }
}

void DiscardGuard::exportAnd(const std::function<void()>& then) {
    m_session.hits().show(std::nullopt);  // all of them
    const QStringList paths = m_beginExport(targetsAtRisk());
    m_awaited = std::set<QString>(paths.begin(), paths.end());
    m_then = then;
}

bool DiscardGuard::askAndWait() {
    if (!isAtRisk()) {
        return true;
    }
    if (m_box != nullptr) {  // something else waits for the same answer
        return false;
    }
    bool goesOn = false;
    QEventLoop loop;
    QMessageBox* box = makeBox();
    connect(box, &QDialog::finished, &loop, [this, box, &loop, &goesOn] {
        m_box.clear();
        take(*box, [&loop, &goesOn] {
            goesOn = true;
            loop.quit();
        });
        if (m_awaited.empty()) {
            loop.quit();
        }
    });
    // An export that fails, or is given up, ends the waiting as well.
    connect(this, &DiscardGuard::exportsEnded, &loop, &QEventLoop::quit);
    box->open();
    loop.exec();
    m_then = {};
    return goesOn;
}

void DiscardGuard::exportBegins(const Target& target, const QString& path) {
    const std::map<TargetId, State> shown = states(m_session.hits().shown());
    const auto state = shown.find(target.id);
    m_writing[path] = {target.id, state != shown.end() ? state->second : kStart};
}

void DiscardGuard::exportEnds(const QString& path, bool isWritten) {
    const auto writing = m_writing.find(path);
    if (writing != m_writing.end()) {
        if (isWritten) {
            m_exported[writing->second.target] = writing->second.state;
        }
        m_writing.erase(writing);
    }
    if (m_awaited.erase(path) == 0) {
        return;
    }
    if (!isWritten) {
        m_awaited.clear();
        m_then = {};
    }
    if (m_awaited.empty()) {
        if (const std::function<void()> then = std::exchange(m_then, {})) {
            ask(then);  // again, if there have been more hits meanwhile
        }
        Q_EMIT exportsEnded();
    }
}

}  // namespace hitscope
