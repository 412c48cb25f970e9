// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/copied_targets.h"
#include "analysis/history_copy.h"
#include "analysis/job_beside.h"
#include "analysis/measured_target.h"
#include "session/session.h"

namespace hitscope {

/// Measures targets of a session on another thread, and again when they change: at most five times a second,
/// and never more than a quarter of the time. Only the vertices that moved are carried over, a bounded number
/// at a time, so that the window's thread is not held up however large the meshes are. What a scene that is
/// gone had going is stopped.
class MeshMeasuring : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this. Nothing is measured before setTargets().
    explicit MeshMeasuring(Session& session, QObject* parent = nullptr);
    ~MeshMeasuring() override;

    /// The targets to measure, together; empty: none. `alone`: one target, in its own frame.
    void setTargets(std::vector<TargetId> targets, bool alone);
    /// Whether anybody looks. Otherwise nothing is measured, and no copies are kept.
    void setActive(bool active);
    [[nodiscard]] float stretchLimit() const { return m_stretchLimit; }
    void setStretchLimit(float limit);  ///< > 1: length now over length before

    /// The latest; null until the first is there.
    [[nodiscard]] const std::shared_ptr<const MeshMeasurement>& measurement() const { return m_measurement; }
    /// Nothing has changed since that was measured. Otherwise another follows by itself.
    [[nodiscard]] bool isUpToDate() const { return !m_changed && !m_job.isRunning(); }

Q_SIGNALS:
    void measured();         ///< measurement() is another
    void upToDateChanged();  ///< isUpToDate(); before measured() where both are meant

private:
    struct Job;

    void forget(TargetId target);
    void startOver();
    void schedule();
    void announceState();
    void gather();
    void start();
    void take(Job& job, bool done);
    void stop();

    Session& m_session;
    std::vector<TargetId> m_targets;
    bool m_alone = true;
    bool m_active = true;
    float m_stretchLimit = 2.0f;
    HistoryFollower m_history;
    CopiedTargets<MeasuredTarget> m_copies;
    JobBeside<Job> m_job;
    std::shared_ptr<const MeshMeasurement> m_measurement;
    QTimer m_timer;
    bool m_changed = false;  ///< since the job that runs was started
    bool m_wasUpToDate = true;
};

}  // namespace hitscope
