// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <span>

#include "session/session.h"

namespace hitscope {

/// The session's hits, oldest first, one a row; follows the session live. Cells are made when they are asked
/// for, so the cost of a hit does not grow with the number of hits before it.
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
        ColumnCount
    };
    enum Role : int {
        /// The number behind the text: qulonglong for NumberColumn and TargetColumn (the target's id), double
        /// for
        /// times (s), speeds (m/s) and impulses (N s), QVariantList of three doubles for points (m) and
        /// directions.
        RawValueRole = Qt::UserRole,
    };

    /// `session` outlives the model.
    explicit HitHistoryModel(const Session& session, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;

    /// The given rows (all of them when empty) as comma-separated text with a header line, numbers in full
    /// precision with a point whatever the locale. Rows out of range are passed over.
    [[nodiscard]] QString csv(std::span<const int> rows = {}) const;

private:
    void beginAppend(int first, int last);
    void endAppend();
    void reset();
    [[nodiscard]] QString text(const Hit& hit, int row, int column) const;
    [[nodiscard]] QString targetName(const Hit& hit) const;

    const Session& m_session;
    /// What the views were told. The history changes before historyReset() arrives, and a view must not see
    /// that in between.
    int m_rows = 0;
    int m_rowsAfterAppend = 0;
};

}  // namespace hitscope
