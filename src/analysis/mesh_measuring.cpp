// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/mesh_measuring.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

constexpr qint64 kBetweenMeasurements = 200;  // milliseconds

}  // namespace

/// What the other thread works on; it touches nothing else.
struct MeshMeasuring::Job {
    struct Part {
        CopiedTargets<MeasuredTarget>::Part target;
        RigidTransform transform;
    };
    std::vector<Part> parts;
    bool alone = true;
    float stretchLimit = 2.0f;
    HistoryCopy::Update update;
    std::shared_ptr<HistoryCopy> history;
    std::shared_ptr<const MeshMeasurement> made;  ///< null: it was stopped, or there was no memory

    void run(const std::stop_token& stop) {
        history->apply(update);
        auto measurement = std::make_shared<MeshMeasurement>();
        for (Part& part : parts) {
            part.target.copy->follow(part.target.moved, stop);
            if (stop.stop_requested()) {
                return;
            }
            part.target.copy->findHarms(stretchLimit, history->hits(), stop);
            part.target.copy->addTo(*measurement, part.transform, alone);
        }
        conclude(*measurement);
        made = std::move(measurement);
    }
};

MeshMeasuring::MeshMeasuring(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_timer.setSingleShot(true);
    m_job.showIn(session.tasks(), tr("Measuring the mesh"));
    connect(&m_timer, &QTimer::timeout, this, &MeshMeasuring::gather);
    connect(&session, &Session::sceneReplaced, this, &MeshMeasuring::startOver);
    connect(&session.targets(), &SessionTargets::removed, this, &MeshMeasuring::forget);
    connect(&session.readBack(), &ReadBack::verticesMoved, this,
            [this](TargetId id, const std::vector<std::uint32_t>& vertices) {
                const Target* target = m_session.targets().find(id);
                if (m_active && target != nullptr && m_copies.note(*target, vertices) &&
                    std::find(m_targets.begin(), m_targets.end(), id) != m_targets.end()) {
                    schedule();
                }
            });
    // Edits that move no vertex change which hit harmed a face, and its number.
    connect(&session.hits(), &SessionHits::changed, this, &MeshMeasuring::schedule);
    connect(&session.hits(), &SessionHits::rearranged, this, &MeshMeasuring::schedule);
    connect(&session.hits(), &SessionHits::shownChanged, this, &MeshMeasuring::schedule);
    connect(&session.targets(), &SessionTargets::changed, this, [this] {
        if (!m_alone) {
            schedule();  // it may stand elsewhere
        }
    });
}

MeshMeasuring::~MeshMeasuring() = default;

/// The copies may be in use: a job that has them is given up with them.
void MeshMeasuring::stop() {
    m_timer.stop();
    m_job.cancel();
    m_history.startOver();
    m_copies.clear();
}

void MeshMeasuring::forget(TargetId target) {
    if (m_copies.contains(target)) {
        startOver();
    }
}

void MeshMeasuring::startOver() {
    stop();
    m_measurement.reset();
    schedule();
}

void MeshMeasuring::setTargets(std::vector<TargetId> targets, bool alone) {
    if (targets == m_targets && alone == m_alone) {
        return;
    }
    m_targets = std::move(targets);
    m_alone = alone;
    schedule();
    if (std::exchange(m_measurement, nullptr)) {
        Q_EMIT measured();  // nothing yet
    }
}

void MeshMeasuring::setActive(bool active) {
    if (active == m_active) {
        return;
    }
    m_active = active;
    if (active) {
        schedule();
    } else {
        stop();
    }
}

void MeshMeasuring::setStretchLimit(float limit) {
    if (limit != m_stretchLimit) {
        m_stretchLimit = limit;
        schedule();
    }
}

void MeshMeasuring::schedule() {
    m_changed = true;
    // Never measured right here: the session reports moved vertices in the middle of drawing a frame.
    if (m_active && !m_job.isRunning() && !m_timer.isActive()) {
        m_timer.start(m_job.pause(kBetweenMeasurements));
    }
    announceState();
}

void MeshMeasuring::announceState() {
    if (isUpToDate() != m_wasUpToDate) {
        m_wasUpToDate = isUpToDate();
        Q_EMIT upToDateChanged();
    }
}

/// Carries over what has moved, over several turns of the event loop if it is much; then starts.
void MeshMeasuring::gather() {
    if (m_job.isRunning()) {
        return;
    }
    auto room = m_copies.kATurn;
    bool isAll = true;
    for (const TargetId id : m_targets) {
        if (const Target* target = m_session.targets().find(id)) {
            isAll = m_copies.gather(*target, room, [&] {
                return std::make_shared<MeasuredTarget>(id, target->deformed.sharedOriginal());
            }) && isAll;
        }
    }
    if (isAll) {
        start();
    } else {
        m_timer.start(0);
    }
}

void MeshMeasuring::start() {
    m_changed = false;
    if (m_targets.empty()) {
        announceState();
        return;
    }
    auto job = std::make_shared<Job>();
    job->alone = m_alone;
    job->stretchLimit = m_stretchLimit;
    for (const TargetId id : m_targets) {
        if (const Target* target = m_session.targets().find(id)) {
            job->parts.push_back({m_copies.take(id), target->transform});
        }
    }
    job->update = m_history.update(m_session.hits().history(), m_session.hits().applied());
    job->history = m_history.copy();
    m_job.start(*this, job, &MeshMeasuring::take);
}

void MeshMeasuring::take(Job& job, bool done) {
    announceState();
    if (!done) {
        stop();  // the numbers stay unknown; everything else goes on
        m_measurement.reset();
        Q_EMIT measured();
        return;
    }
    // Others may have been asked for meanwhile.
    if (job.made->targets == m_targets && job.alone == m_alone) {
        m_measurement = job.made;
        Q_EMIT measured();
    }
    if (m_changed) {
        schedule();
    }
}

}  // namespace hitscope
