// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/mesh_measuring.h"

#include <algorithm>
#include <utility>

#include "analysis/beside.h"
#include "session/task_list.h"

namespace hitscope {

namespace {

constexpr qint64 kInterval = 200;            // milliseconds
constexpr qint64 kLongestInterval = 5'000;   // milliseconds
constexpr std::size_t kMostAtOnce = 40'000;  // vertices carried over in one turn of the event loop
constexpr int kWorthShowing = 600;           // milliseconds

}  // namespace

/// What the other thread works on; it touches nothing else.
struct MeshMeasuring::Job {
    struct Part {
        std::shared_ptr<MeasuredTarget> target;
        std::vector<MovedVertex> moved;
        RigidTransform transform;
    };
    std::vector<Part> parts;
    bool alone = true;
    float stretchLimit = 2.0f;
    HistoryCopy::Update update;
    std::shared_ptr<HistoryCopy> history;
    std::stop_source source;
    std::shared_ptr<const MeshMeasurement> made;  ///< null: it was stopped, or there was no memory

    void run() {
        const std::stop_token stop = source.get_token();
        history->apply(update);
        auto measurement = std::make_shared<MeshMeasurement>();
        for (Part& part : parts) {
            part.target->follow(part.moved, stop);
            if (stop.stop_requested()) {
                return;
            }
            part.target->findHarms(stretchLimit, history->hits(), stop);
            part.target->addTo(*measurement, part.transform, alone);
        }
        conclude(*measurement);
        made = std::move(measurement);
    }
};

MeshMeasuring::MeshMeasuring(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_interval(kInterval) {
    m_timer.setSingleShot(true);
    m_longJob.setSingleShot(true);
    m_longJob.setInterval(kWorthShowing);
    connect(&m_timer, &QTimer::timeout, this, &MeshMeasuring::gather);
    connect(&m_longJob, &QTimer::timeout, this, [this] {
        m_progress = std::make_unique<TaskProgress>(m_session.tasks(), tr("Measuring the mesh"));
    });
    connect(&session, &Session::sceneReplaced, this, &MeshMeasuring::startOver);
    connect(&session, &Session::targetRemoved, this, &MeshMeasuring::forget);
    connect(&session, &Session::verticesMoved, this,
            [this](TargetId id, const std::vector<std::uint32_t>& vertices) {
                const Target* target = m_session.target(id);
                if (m_active && target != nullptr && m_measured.contains(id)) {
                    m_moved.note(*target, vertices);
                    if (std::find(m_targets.begin(), m_targets.end(), id) != m_targets.end()) {
                        schedule();
                    }
                }
            });
    connect(&session, &Session::targetChanged, this, [this] {
        if (!m_alone) {
            schedule();  // it may stand elsewhere
        }
    });
}

MeshMeasuring::~MeshMeasuring() {
    stop();
}

void MeshMeasuring::stop() {
    if (m_job) {
        m_job->source.request_stop();
        m_job.reset();
        m_history.startOver();
    }
    m_gathered.clear();
    m_longJob.stop();
    m_progress.reset();
}

void MeshMeasuring::forget(TargetId target) {
    // The target's copy may be in use: the job that has it is given up with it.
    if (m_measured.contains(target)) {
        startOver();
    }
}

void MeshMeasuring::startOver() {
    stop();
    m_measured.clear();
    m_moved.clear();
    m_measurement.reset();
    schedule();
}

void MeshMeasuring::setTargets(std::vector<TargetId> targets, bool alone) {
    if (targets == m_targets && alone == m_alone) {
        return;
    }
    m_targets = std::move(targets);
    m_alone = alone;
    m_measurement.reset();
    schedule();
}

void MeshMeasuring::setActive(bool active) {
    if (active == m_active) {
        return;
    }
    m_active = active;
    if (active) {
        schedule();
    } else {
        m_timer.stop();
        stop();
        m_measured.clear();
        m_moved.clear();
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
    if (m_active && !m_job && !m_timer.isActive()) {
        const qint64 since = m_sinceStart.isValid() ? m_sinceStart.elapsed() : m_interval;
        m_timer.start(static_cast<int>(std::clamp<qint64>(m_interval - since, 0, kLongestInterval)));
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
    if (m_job) {
        return;
    }
    std::size_t room = kMostAtOnce;
    bool isAll = true;
    for (const TargetId id : m_targets) {
        const Target* target = m_session.target(id);
        if (target == nullptr) {
            continue;
        }
        std::shared_ptr<MeasuredTarget>& measured = m_measured[id];
        if (!measured) {
            measured = std::make_shared<MeasuredTarget>(id, target->deformed.sharedOriginal());
            m_moved.note(*target, target->deformed.everChanged());
        }
        isAll = m_moved.take(id, target->deformed.positions(), room, m_gathered[id]) && isAll;
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
        if (const Target* target = m_session.target(id)) {
            job->parts.push_back({m_measured.at(id), std::exchange(m_gathered[id], {}), target->transform});
        }
    }
    job->update = m_history.update(m_session.history(), m_session.appliedHits());
    job->history = m_history.copy();
    m_job = job;
    m_sinceStart.start();
    m_longJob.start();
    workBeside(
        this, [job] { job->run(); }, [job](MeshMeasuring& self, bool done) { self.take(*job, done); });
}

void MeshMeasuring::take(const Job& job, bool done) {
    if (m_job.get() != &job) {
        return;  // given up
    }
    m_job.reset();
    m_longJob.stop();
    m_progress.reset();
    m_interval = std::max(kInterval, 4 * m_sinceStart.elapsed());
    announceState();
    if (!done) {
        m_measured.clear();  // the numbers stay unknown; everything else goes on
        m_history.startOver();
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
