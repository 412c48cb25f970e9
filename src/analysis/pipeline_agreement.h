// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "analysis/copied_targets.h"
#include "analysis/history_copy.h"
#include "analysis/job_beside.h"
#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope {

/// How far what the active pipeline made is from the reference, over all targets. Of every vertex that faces
/// use, by its place.
struct AgreementReport {
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    std::size_t vertices = 0;        ///< compared
    std::size_t different = 0;       ///< of them, those not equal to the last bit
    double largest = 0.0;            ///< metres
    double rootMeanSquare = 0.0;     ///< metres, over all that were compared
    std::optional<VertexRef> worst;  ///< where it is largest; nothing while all are equal
    std::size_t hits = 0;            ///< applied by the reference: as the pipeline (SessionHits::isApplied())
    std::size_t dropped = 0;         ///< that the pipeline no longer applies, so neither does the reference
    std::size_t later = 0;           ///< that come after those that are shown
};

/// Compares the session's read-back with the reference deformation (ReferenceDeformation), on another thread
/// and on copies, once or again and again. The copies are carried on by what changed.
class PipelineAgreement : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit PipelineAgreement(Session& session, QObject* parent = nullptr);
    ~PipelineAgreement() override;

    /// `sync` is called before vertices are taken: it brings the read-back to the session's state, and says
    /// whether it could. Without one, the read-back is taken as it is.
    void setSync(std::function<bool()> sync) { m_sync = std::move(sync); }
    void compare();
    [[nodiscard]] bool isContinuous() const { return m_continuous; }
    void setContinuous(bool on);  ///< after every change, at most twice a second
    [[nodiscard]] bool isComparing() const { return m_job.isRunning() || m_timer.isActive(); }
    /// Of the last comparison; nothing before the first, and with a new scene.
    [[nodiscard]] const std::optional<AgreementReport>& report() const { return m_report; }
    /// The report is of an earlier state of the session.
    [[nodiscard]] bool isOutOfDate() const { return m_report && m_isReportOld; }

Q_SIGNALS:
    void reported();  ///< report(), isComparing() or isOutOfDate() is another

private:
    class Copy;
    struct Job;

    void startOver();
    void noteChange();
    void gather();
    void start();
    void take(Job& job, bool done);
    void stop();

    Session& m_session;
    std::function<bool()> m_sync;
    bool m_continuous = false;
    HistoryFollower m_history;
    CopiedTargets<Copy> m_copies;
    JobBeside<Job> m_job;
    std::optional<AgreementReport> m_report;
    QTimer m_timer;
    bool m_isGathering = false;  ///< some of the vertices were taken, in this state of the session
    bool m_hasChanged = false;   ///< since the last comparison was started
    bool m_isReportOld = false;  ///< the session has changed since what was reported
};

}  // namespace hitscope
