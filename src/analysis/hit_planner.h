// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/copied_targets.h"
#include "analysis/job_beside.h"
#include "deform/scattered_hits.h"
#include "session/session.h"

namespace hitscope {

class PlannedCopy;
struct PlanJob;

/// Hits that a person is about to make many of, and ghosts of what they would leave. Works in the background,
/// on copies of the targets that are carried on by what moves, and again when they change.
class HitPlanner : public QObject {
    Q_OBJECT
public:
    /// `session` outlives it.
    explicit HitPlanner(Session& session, QObject* parent = nullptr);
    ~HitPlanner() override;

    /// Hits that are known already: only their ghosts are to be worked out.
    void plan(std::vector<Hit> hits);
    /// Hits scattered over a target, over its selected vertices where `selectedOnly` says so. Each is like
    /// one that would be made now, of the constants in force.
    void plan(TargetId target, const ScatterPlan& scatter, bool selectedOnly);
    void clear();  ///< nothing is planned

    struct Plan {
        std::vector<Hit> hits;  ///< each has passed checkedHit()
        double area = 0.0;      ///< square metres that hits are scattered over
        QString why;            ///< there are none, in words; else empty
        /// Three corners a triangle, metres, world.
        std::shared_ptr<const std::vector<glm::vec3>> ghosts;
        bool areDents = true;  ///< else the ghosts are marks (DentGhosts)
    };
    /// Null: none, or it is being worked out.
    [[nodiscard]] const Plan* current() const { return m_plan ? &*m_plan : nullptr; }
    /// The hit that is made of the constants in force on a target now, but for where and which way.
    [[nodiscard]] static Hit modelOn(const Session& session, const Target& target);

Q_SIGNALS:
    void planned();  ///< current() is another

private:
    void request();
    void gather();
    [[nodiscard]] std::vector<TargetId> targets() const;
    void take(PlanJob& job, bool done);
    void refuse(const QString& why);

    struct Wish {
        std::vector<Hit> hits;
        std::optional<ScatterPlan> scatter;  ///< else `hits`
        TargetId target;
        bool selectedOnly = false;
    };
    Session& m_session;
    std::optional<Wish> m_wish;
    std::optional<Plan> m_plan;
    CopiedTargets<PlannedCopy> m_copies;
    JobBeside<PlanJob> m_job;
    QTimer m_timer;
};

}  // namespace hitscope
