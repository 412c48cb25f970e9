// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <span>
#include <unordered_map>

#include "analysis/hit_effects.h"

namespace hitscope {

/// The session's hits, oldest first, one a row; follows the session live. Cells are made when they are asked
/// for, so the cost of a hit does not grow with the number of hits before it.
///
/// Rows are checked when the hit is enabled, and can be dragged to another place; both go through the session
/// and can be undone there. Persistent indexes, so selections too, stay with their hits.
class HitHistoryModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column : int {
        NumberColumn,  ///< 1 for the oldest
        TimeColumn,
        TargetColumn,
        PointColumn,
        DirectionColumn,
        SpeedColumn,
        ImpulseColumn,
        AffectedColumn,
        GreatestColumn,
        CpuCostColumn,
        GpuCostColumn,
        PipelineColumn,
        MaxDistanceColumn,
        PowerColumn,
        MaxMagnitudeColumn,
        WorldPointColumn,
        NormalColumn,
        TriangleColumn,
        GroupColumn,
        ColumnCount
    };
    enum Role : int {
        /// The number behind the text: qulonglong for numbers, counts and TargetColumn (the target's id),
        /// double for times (s), lengths (m) and costs (ms), QVariantList of three doubles for points (m) and
        /// directions; nothing for what is not known, for PipelineColumn and GroupColumn.
        RawValueRole = Qt::UserRole,
        HitStateRole,  ///< HitState as int: whether the mesh on screen shows the hit
    };
    enum HitState : int {
        Applied,
        Disabled,
        Dropped,  ///< enabled, but the pipeline's capacity was reached
        Later,    ///< enabled, but the targets are shown as they were before it (SessionHits::show())
    };

    /// `session` and `effects` outlive the model; without `effects` what hits did is not known.
    explicit HitHistoryModel(Session& session, HitEffects* effects = nullptr, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Qt::CheckStateRole of the first column enables and disables; all else is refused.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    // Dragging: rows of this model, between its rows.
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    [[nodiscard]] QStringList mimeTypes() const override;
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

    /// The given rows (all of them when empty) as toCsv() writes them. Rows out of range are passed over.
    [[nodiscard]] QString csv(std::span<const std::size_t> rows = {}) const;
    /// What rows are sorted by in a column, but for TargetColumn: three numbers, compared in turn. What is
    /// not known comes first. row < rowCount().
    void sortParts(std::size_t row, int column, double (&parts)[3]) const;

private:
    void beginAppend(int first, int last);
    void endAppend();
    void refresh(int first, int last);
    void rearrange(const HitRows& rows);
    void reset();
    [[nodiscard]] HitState stateOf(std::size_t row) const;
    [[nodiscard]] QString toolTip(const Hit& hit, std::size_t row) const;
    [[nodiscard]] QString text(const Hit& hit, std::size_t row, int column) const;
    [[nodiscard]] QVariant rawValue(const Hit& hit, std::size_t row, int column) const;
    /// Of a column that holds one; nothing: not known.
    [[nodiscard]] std::optional<double> number(const Hit& hit, std::size_t row, int column) const;
    /// Of a column that holds one; nothing: not known.
    [[nodiscard]] std::optional<glm::vec3> vector(const Hit& hit, int column) const;
    void refreshColumns(int firstRow, int lastRow, int firstColumn, int lastColumn);
    void followTarget(TargetId id);
    [[nodiscard]] QString targetName(const Hit& hit) const;

    Session& m_session;
    HitEffects* m_effects;
    /// What the views were told. The history changes before the session says so, and a view must not see
    /// that in between.
    int m_rows = 0;
    int m_rowsAfterAppend = 0;
    std::unordered_map<TargetId, QString>
        m_names;  ///< of the targets that have changed, as the views know them
};

}  // namespace hitscope
