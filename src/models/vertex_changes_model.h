// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QTimer>
#include <memory>
#include <span>
#include <vector>

#include "analysis/hit_effects.h"
#include "analysis/job_beside.h"
#include "models/vertex_change_order.h"
#include "models/vertex_changes_csv.h"
#include "models/vertex_facts.h"
#include "session/session.h"

namespace hitscope {

/// The changed vertices of the target in focus (focusTarget()), a row each, as they are on the screen.
///
/// What a row shows is read from the target when it is shown. Which vertices there are and in what order is
/// worked out on another thread, told of what moved, so that the window's thread pays for that and no more,
/// with a million rows too; rows follow a moment after the hits.
class VertexChangesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column : int {
        NumberColumn,  ///< in the file, counted from 1
        OriginalColumn,
        CurrentColumn,
        DisplacementColumn,
        LengthColumn,
        TurnedColumn,
        HitsColumn,
        ColumnCount
    };
    enum Role : int {
        VertexRole = Qt::UserRole,  ///< uint: the file vertex, counted from 0
        SelectedRole,               ///< bool: in the session's vertex selection
        PickedRole,                 ///< bool
        /// The number behind the text: qulonglong for number and hits, double for length (m) and angle
        /// (radians), QVariantList of three doubles for vectors (m).
        RawValueRole
    };
    enum class Filter : std::uint8_t { AllChanged, Selected, MovedBySelectedHit };

    /// Both outlive the model.
    VertexChangesModel(Session& session, HitEffects& effects, QObject* parent = nullptr);
    ~VertexChangesModel() override;

    [[nodiscard]] const Target* target() const { return m_session.targets().find(m_target); }
    [[nodiscard]] std::uint32_t vertexAt(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    /// -1: it has no row. Costs time in proportion to the rows, about a millisecond for a million.
    [[nodiscard]] int rowOf(std::uint32_t vertex) const;
    /// Rows and what they show are as the target is; nothing is being worked out.
    [[nodiscard]] bool isUpToDate() const;

    [[nodiscard]] Filter filter() const { return m_filter; }
    void setFilter(Filter filter);
    [[nodiscard]] double leastDisplacement() const { return static_cast<double>(m_query.leastLength); }
    void setLeastDisplacement(double metres);

    /// These vertices as they are now, for csv().
    [[nodiscard]] VertexChangesTable table(std::vector<std::uint32_t> vertices) const;
    /// All rows, in their order; saved() follows.
    void saveCsv(const QString& path);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

Q_SIGNALS:
    void targetChanged();  ///< the rows are of another target, or of none
    void rowsFollowed();   ///< rows are new, gone or elsewhere
    /// Without an error it is there.
    void saved(const QString& path, const std::optional<hitscope::Error>& error);

private:
    struct Job;
    struct SharedOrder;
    void followTarget();
    void followCounts(TargetId target, const std::vector<std::uint32_t>& vertices);
    void startOver();
    void noteMoved(TargetId target, const std::vector<std::uint32_t>& vertices);
    void followSelection();
    void askForHitVertices();
    void showOnly(std::vector<std::uint32_t> vertices);
    void schedule();
    void work();
    void take(Job& job, bool done);
    void adopt(std::vector<std::uint32_t> rows);
    [[nodiscard]] std::vector<VertexState> nextMoved();
    [[nodiscard]] std::uint32_t hitsOf(std::uint32_t vertex) const;
    [[nodiscard]] QString text(std::uint32_t vertex, int column) const;
    [[nodiscard]] QVariant rawValue(std::uint32_t vertex, int column) const;

    Session& m_session;
    HitEffects& m_effects;
    TargetId m_target;
    std::vector<std::uint32_t> m_rows;  ///< file vertices
    VertexQuery m_query;
    Filter m_filter = Filter::AllChanged;

    std::shared_ptr<SharedOrder> m_order;  ///< null: no target
    std::vector<std::uint32_t> m_pending;  ///< file vertices to tell it of
    bool m_rowsPending = false;
    JobBeside<Job> m_job;
    QTimer m_timer;
};

}  // namespace hitscope
