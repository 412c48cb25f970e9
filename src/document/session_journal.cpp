// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session_journal.h"

#include <utility>

#include "session/session.h"
#include "session/vertex_selection.h"
#include "session/work_on_targets.h"

namespace hitscope {

SessionJournal::SessionJournal(Session& session, std::function<CapturedView()> view, const QString& folder,
                               QObject* parent)
    : QObject(parent), m_session(session), m_view(std::move(view)), m_writer(folder) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoon);
    connect(&m_soon, &QTimer::timeout, this, &SessionJournal::flush);
    connect(&m_writer, &JournalWriter::snapshotWanted, this, &SessionJournal::startOver);
    connect(&session, &Session::sceneReplaced, this, [this] {
        m_hadHits = false;  // of the scene before
        startOver();
    });

    const SessionHits& hits = session.hits();
    connect(&hits, &SessionHits::appended, this, &SessionJournal::followHits);
    connect(&hits, &SessionHits::changed, this, &SessionJournal::followHits);
    connect(&hits, &SessionHits::rearranged, this, &SessionJournal::followHits);
    connect(&hits, &SessionHits::reset, this, &SessionJournal::followHits);

    const auto noting = [this](Section section) { return [this, section] { note(section); }; };
    const SessionTargets& targets = session.targets();
    connect(&targets, &SessionTargets::added, this, [this] {
        note(Section::Targets);
        if (m_isBegun && !m_startsOver) {
            m_hasNewTargets = true;
            m_soon.start(0);  // once for all that come at a time
        }
    });
    connect(&targets, &SessionTargets::removed, this, noting(Section::Targets));
    connect(&targets, &SessionTargets::changed, this, &SessionJournal::noteTarget);
    const SessionSettings& settings = session.settings();
    connect(&settings, &SessionSettings::constantsChanged, this, noting(Section::Constants));
    connect(&settings, &SessionSettings::lightsChanged, this, noting(Section::Lights));
    connect(&settings, &SessionSettings::projectileChanged, this, noting(Section::Projectile));
    connect(&settings, &SessionSettings::flightModeChanged, this, noting(Section::Simulation));
    connect(&settings, &SessionSettings::pipelineChanged, this, noting(Section::Simulation));
    connect(&settings, &SessionSettings::coverTextureChanged, this, noting(Section::Scene));
    connect(&session.simulation(), &Simulation::timeChanged, this, noting(Section::Simulation));
    connect(&targets, &SessionTargets::selectedChanged, this, noting(Section::Selection));
    connect(&hits, &SessionHits::selectedChanged, this, noting(Section::Selection));
    connect(&hits, &SessionHits::shownChanged, this, noting(Section::Selection));
    connect(&session.selection(), &VertexSelection::selectionChanged, this, noting(Section::Selection));
    connect(&session.selection(), &VertexSelection::pickedChanged, this, noting(Section::Selection));
}

SessionJournal::~SessionJournal() {
    flush();
}

/// A session without hits and with the targets that it was opened with has cost nobody work yet; one that had
/// some is kept when they are taken out.
bool SessionJournal::isWorthIt() const {
    return m_isBegun || m_hadHits || m_session.hits().history().size() > 0 ||
           hasWorkOnTargets(m_session.steps());
}

void SessionJournal::note(Section section) {
    const bool isLooking =
        section == Section::Selection || section == Section::Cameras || section == Section::Display;
    if (!m_isBegun && !isLooking) {
        startOver();
    } else if (m_isBegun) {
        m_noted.insert(section);
        if (!m_soon.isActive()) {
            m_soon.start();
        }
    }
}

void SessionJournal::noteTarget(TargetId id) {
    if (!m_isBegun) {
        startOver();
        return;
    }
    m_changed.insert(id);
    if (!m_soon.isActive()) {
        m_soon.start();
    }
}

void SessionJournal::keep() {
    m_startsOver = true;
    flush();
}

void SessionJournal::viewChanged() {
    note(Section::Cameras);
    note(Section::Display);
}

/// Once the event loop has its turn: hits follow a new scene.
void SessionJournal::startOver() {
    if (isWorthIt()) {
        m_startsOver = true;
        m_soon.start(0);
    }
}

void SessionJournal::followHits() {
    if (!m_isBegun || m_startsOver) {
        startOver();
        return;
    }
    const HitHistory& history = m_session.hits().history();
    const auto edits = history.editsSince(m_revision);
    if (!edits) {
        startOver();
        return;
    }
    if (m_hasNewTargets) {
        flush();  // else hits on them would be on none
    }
    m_revision = history.revision();
    for (const HistoryEdit& edit : *edits) {
        m_writer.edit(edit.first, edit.before.size(), edit.after);
    }
}

void SessionJournal::flush() {
    m_soon.stop();
    m_soon.setInterval(kSoon);
    m_hasNewTargets = false;
    if (std::exchange(m_startsOver, false)) {
        m_noted.clear();
        m_changed.clear();
        m_isBegun = true;
        m_revision = m_session.hits().history().revision();
        // Fingerprints of the positions would not hold after the next hit, and take long on a large mesh.
        m_writer.begin(captureHits(m_session, m_view()));
        Q_EMIT begun();
    } else {
        writeNoted();
    }
}

void SessionJournal::writeNoted() {
    const std::set<Section> sections = std::exchange(m_noted, {});
    const std::set<TargetId> targets = std::exchange(m_changed, {});
    if (!sections.empty()) {
        m_writer.set({sections.begin(), sections.end()}, captureSettings(m_session, m_view()));
    }
    if (!targets.empty() && !sections.contains(Section::Targets)) {
        m_writer.setSome(captureTargets(m_session, targets));
    }
}

void SessionJournal::finish() {
    m_soon.stop();
    m_noted.clear();
    m_changed.clear();
    m_startsOver = false;
    m_hasNewTargets = false;
    m_isBegun = false;
    m_hadHits = m_session.hits().history().size() > 0;
    m_writer.finish();
}

}  // namespace hitscope
