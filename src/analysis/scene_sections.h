// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "analysis/copied_targets.h"
#include "analysis/job_beside.h"
#include "analysis/scene_section.h"

namespace hitscope {

class DeformedMesh;

/// Cuts a session's targets on another thread, and again when the plane or the targets change: one cut at a
/// time, then the newest that was asked for meanwhile. Only vertices that moved are carried over, a bounded
/// number at a time. While there is no plane it keeps no copies and does nothing.
class SceneSections : public QObject {
    Q_OBJECT
public:
    /// Of the session's targets as it has read them back. `session` outlives this.
    explicit SceneSections(Session& session, QObject* parent = nullptr);
    /// A target as somebody else has it, with the same render mesh; null: it is as it was.
    using Shapes = std::function<const DeformedMesh*(const Target& target)>;
    /// Of those shapes; what moves is to be told by note().
    SceneSections(Session& session, Shapes shapes, QObject* parent = nullptr);
    ~SceneSections() override;

    /// These file vertices of the target have moved.
    void note(TargetId id, const std::vector<std::uint32_t>& vertices);
    void setCut(const CuttingPlane& cut, float exaggeration);
    /// The latest; null: there is no plane, or its first section has not come yet.
    [[nodiscard]] const std::shared_ptr<const SceneSection>& section() const { return m_section; }
    /// Whether a newer one is on its way.
    [[nodiscard]] bool isBusy() const { return m_job.isRunning() || m_due; }

Q_SIGNALS:
    void changed();  ///< section() is another

private:
    struct Job;
    struct Place {
        RigidTransform transform;  ///< when it was last asked for
        bool visible = true;
    };

    void forget();
    void followPlaces();
    void request();
    void gather();
    void start();
    void take(Job& job, bool done);

    Session& m_session;
    Shapes m_shapes;
    CuttingPlane m_cut;
    float m_exaggeration = 1.0f;
    CopiedTargets<SectionedTarget> m_copies;
    std::map<TargetId, Place> m_places;  ///< of those
    JobBeside<Job> m_job;
    bool m_due = false;  ///< since the job that runs was started
    QTimer m_timer;
    std::shared_ptr<const SceneSection> m_section;
};

}  // namespace hitscope
