// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/copied_targets.h"
#include "analysis/history_copy.h"
#include "analysis/job_beside.h"
#include "mesh/dent.h"
#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope {

class DentCopy;
struct DentJob;

/// Measures one dent: the one around the vertex picked or the hit selected last. Works in the background, on
/// a copy of the target that is carried on by what moves, and again whenever the target changes.
class DentMeasurement : public QObject {
    Q_OBJECT
public:
    /// `session` outlives it.
    explicit DentMeasurement(Session& session, QObject* parent = nullptr);
    ~DentMeasurement() override;

    using Profile = std::vector<std::vector<ProfilePoint>>;  ///< lines
    struct Report {
        std::optional<DentMeasures> dent;  ///< nothing: there is none, and `why`
        QString why;
        QString target;
        /// Rows of the history, ascending: the hits that made this dent, where there are several.
        std::vector<std::size_t> mergedHits;
        QString merged;  ///< names them (the selected hit only the others), as shown; empty: there is one
        /// Of those, the ones whose part of the merged dent this is; empty: it is all of it.
        std::vector<std::size_t> partHits;
        Profile before;  ///< of the wall that is dented, near the dent
        Profile after;
    };
    [[nodiscard]] const Report& report() const { return m_report; }
    /// Between the two vertices picked last, metres, world; nothing before two have been picked.
    struct Distance {
        VertexRef from;
        VertexRef to;
        double before = 0.0;
        double after = 0.0;
    };
    [[nodiscard]] std::optional<Distance> distance() const;

    /// Whether of dents that overlap only the part that the hit moved most is measured (dentOwners()), or, of
    /// a picked vertex, the part that it is in; by default it is. Else the merged dent as a whole.
    void setTellsApart(bool on);
    [[nodiscard]] bool tellsApart() const { return m_tellsApart; }

    /// Of the profile: radians about the dent's axis.
    [[nodiscard]] double angle() const { return m_angle; }
    void setAngle(double angle);
    /// Not active, it measures nothing: for when nobody looks.
    void setActive(bool active);
    [[nodiscard]] bool isBusy() const { return m_job.isRunning() || m_timer.isActive(); }

    /// A line a figure: name, value, unit. A line names the hits of a merged dent.
    [[nodiscard]] QString text() const;
    /// Lines of the profile: "state,line,along_m,height_m". Before them, where the dent is merged, a line
    /// that begins with # and names the hits.
    [[nodiscard]] QByteArray profileCsv() const;

Q_SIGNALS:
    void reportChanged();
    void distanceChanged();

private:
    enum class Source : std::uint8_t { None, Vertex, Hit };
    void followPick();
    void followHit();
    void followMesh(TargetId target);
    void followPlace(TargetId target);
    void forget();
    [[nodiscard]] std::optional<TargetId> target() const;
    [[nodiscard]] QString whyNotMeasured() const;
    void request();
    [[nodiscard]] static QString numbersOf(const std::vector<std::size_t>& rows);
    void refuse(const QString& why);
    void gather();
    void start(const Target& target);
    void take(DentJob& job, bool done);
    void dropCopies();

    Session& m_session;
    Source m_source = Source::None;
    std::array<std::optional<VertexRef>, 2> m_picked;  ///< the latest last
    double m_angle = 0.0;
    bool m_isActive = true;
    bool m_tellsApart = true;
    bool m_isDue = false;   ///< since the job that runs was started
    bool m_isVoid = false;  ///< what is being measured is not wanted any more
    Report m_report;
    HistoryFollower m_history;
    CopiedTargets<DentCopy> m_copies;  ///< one at most
    JobBeside<DentJob> m_job;
    QTimer m_timer;
};

}  // namespace hitscope
