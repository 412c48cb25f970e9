// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/discard_guard.h"

#include <QEventLoop>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <bit>
#include <utility>

#include "app/session_files.h"
#include "session/shown_number.h"
#include "session/work_on_targets.h"

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
    if (!hit.form.isPaper()) {
        mix(state, static_cast<std::uint64_t>(hit.form.profile));
        mix(state, static_cast<std::uint64_t>(hit.form.direction));
        mix(state, hit.form.radius);
        for (const float ordinate : hit.form.curve) {
            mix(state, ordinate);
        }
    }
}

void callIfAny(const std::function<void()>& what) {
    if (what) {
        what();
    }
}

}  // namespace

DiscardGuard::DiscardGuard(Session& session, SessionFiles& files, QWidget& window, BeginSave beginSave)
    : QObject(&window),
      m_session(session),
      m_files(files),
      m_window(window),
      m_beginSave(std::move(beginSave)) {
    connect(&session, &Session::sceneReplaced, this, [this] {
        m_exported.clear();
        m_writing.clear();  // targets of the scene before
        m_keptHits.reset();
        m_writingHits.reset();
    });
    files.setAsk([this](std::function<void()> then, std::function<void()> instead) {
        ask(std::move(then), std::move(instead));
    });
    connect(&files, &SessionFiles::saved, this, [this] { takeSaved(true); });
    connect(&files, &SessionFiles::notSaved, this, [this] { takeSaved(false); });
    connect(&files, &SessionFiles::saveEnded, this, [this] { takeSaved(false); });  // the others
}

bool DiscardGuard::isAtRisk() const {
    return m_files.isModified() && (!m_files.path().isEmpty() || hitsAtRisk() > 0 || areTargetsAtRisk());
}

void DiscardGuard::letGo() {
    m_keptHits = stateOfAll();
    m_files.letGo();
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
    if (m_session.hits().history().size() == 0 || m_keptHits == stateOfAll()) {
        return targets;
    }
    for (const auto& [target, state] : states(m_session.hits().history().hits())) {
        const auto exported = m_exported.find(target);
        if (exported == m_exported.end() || exported->second.hits != state) {
            targets.push_back(target);
        }
    }
    return targets;
}

std::size_t DiscardGuard::hitsAtRisk() const {
    const std::vector<TargetId> targets = targetsAtRisk();
    const std::span<const Hit> hits = m_session.hits().history().hits();
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [&targets](const Hit& hit) {
        return std::binary_search(targets.begin(), targets.end(), hit.target);  // in the order of a map
    }));
}

bool DiscardGuard::areTargetsAtRisk() const {
    const SessionTargets& targets = m_session.targets();
    const std::uint64_t work = workOnTargets(m_session.steps());
    return (work != 0 || m_files.isRecovered()) &&
           !std::all_of(targets.begin(), targets.end(), [this, work](const std::unique_ptr<Target>& target) {
               const auto exported = m_exported.find(target->id);
               return exported != m_exported.end() && exported->second.work == work;
           });
}

QMessageBox* DiscardGuard::makeBox() {
    const std::size_t hits = hitsAtRisk();
    const QString what = !m_files.path().isEmpty()
                             ? tr("Changes of %1 are not saved.").arg(QFileInfo(m_files.path()).fileName())
                         : hits > 0
                             ? tr("%Ln {hit|hits} on this scene {is|are} not saved.", nullptr, trCount(hits))
                             : tr("Changes of this scene's targets are not saved.");
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Save Session"), what, QMessageBox::NoButton, &m_window);
    box->setObjectName(QStringLiteral("discardHits"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(tr("Save the session to keep its targets, hits and settings."));
    box->addButton(m_files.path().isEmpty() ? tr("&Save…") : tr("&Save"), QMessageBox::AcceptRole);
    box->addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    box->setDefaultButton(box->addButton(QMessageBox::Cancel));
    m_box = box;
    return box;
}

void DiscardGuard::ask(std::function<void()> then, std::function<void()> instead) {
    if (!isAtRisk()) {
        then();
        return;
    }
    if (m_box != nullptr) {  // one question at a time
        m_box->raise();
        m_box->activateWindow();
        callIfAny(instead);
        return;
    }
    QMessageBox* box = makeBox();
    connect(box, &QDialog::finished, this, [this, box, act = std::move(then), other = std::move(instead)] {
        m_box.clear();
        take(*box, act, other);
    });
    box->open();
}

void DiscardGuard::take(QMessageBox& box, const std::function<void()>& then,
                        const std::function<void()>& instead) {
    const QAbstractButton* const clicked = box.clickedButton();
    const QMessageBox::ButtonRole role =
        clicked != nullptr ? box.buttonRole(box.clickedButton()) : QMessageBox::RejectRole;
    if (role == QMessageBox::DestructiveRole) {
        then();
    } else if (role == QMessageBox::AcceptRole) {
        m_then = then;
        m_instead = instead;
        // Where to save may be asked by a dialog with an event loop of its own. The box may be deleted in it,
        // so the box's own code must have ended by then.
        QMetaObject::invokeMethod(this, &DiscardGuard::beginSave, Qt::QueuedConnection);
    } else {
        callIfAny(instead);
    }
}

void DiscardGuard::beginSave() {
    if (m_then && !m_beginSave()) {
        m_then = {};
        callIfAny(std::exchange(m_instead, {}));
        Q_EMIT saveEnded();
    }
}

void DiscardGuard::takeSaved(bool isSaved) {
    const std::function<void()> then = std::exchange(m_then, {});
    const std::function<void()> instead = std::exchange(m_instead, {});
    if (!then) {
        return;
    }
    if (isSaved) {
        ask(then, instead);  // again, if there have been more changes meanwhile
    } else {
        callIfAny(instead);
    }
    Q_EMIT saveEnded();
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
        const auto goOn = [&loop, &goesOn] {
            goesOn = true;
            loop.quit();
        };
        take(*box, goOn, {});
        if (!m_then) {
            loop.quit();
        }
    });
    // A save that fails, or is given up, ends the waiting as well.
    connect(this, &DiscardGuard::saveEnded, &loop, &QEventLoop::quit);
    box->open();
    loop.exec();
    m_then = {};
    m_instead = {};
    return goesOn;
}

/// Costs all hits and steps once, however many targets there are.
void DiscardGuard::exportBegins(const std::vector<const Target*>& targets, const QString& path) {
    const std::map<TargetId, State> shown = states(m_session.hits().shown());
    const std::uint64_t work = workOnTargets(m_session.steps());
    Writing& writing = m_writing.emplace_back(Writing{path, {}});
    for (const Target* target : targets) {
        const auto state = shown.find(target->id);
        writing.targets[target->id] = {state != shown.end() ? state->second : kStart, work, path};
    }
}

void DiscardGuard::exportEnds(const QString& path, bool isWritten) {
    const auto writing = std::find_if(m_writing.begin(), m_writing.end(),
                                      [&path](const Writing& one) { return one.path == path; });
    if (writing == m_writing.end()) {
        return;
    }
    if (isWritten) {
        // What it held before is gone.
        std::erase_if(m_exported, [&path](const auto& one) { return one.second.path == path; });
        for (const auto& [target, state] : writing->targets) {
            m_exported[target] = state;
        }
    }
    m_writing.erase(writing);
}

}  // namespace hitscope
