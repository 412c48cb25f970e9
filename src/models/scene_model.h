// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <unordered_map>
#include <vector>

#include "session/session.h"

namespace hitscope {

/// The session's targets, one a row, in the session's order. Names can be edited and targets shown and
/// hidden; both go through the session and can be undone there.
class SceneModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column : int {
        VisibleColumn,  ///< Qt::CheckStateRole: checked when it is visible; no text
        NameColumn,
        VerticesColumn,
        HitsColumn,  ///< disabled ones included
        ColumnCount
    };
    enum Role : int {
        /// The number behind the text: qulonglong for VerticesColumn and HitsColumn.
        RawValueRole = Qt::UserRole,
        VisibleRole,  ///< bool, for every column
        /// QString, for every column: why shots pass the target; empty: they do not.
        WhyNotHittableRole,
    };

    /// `session` outlives the model.
    explicit SceneModel(Session& session, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// A name (refused when empty) or a check state; all else is refused.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

    /// Writes a target to a file, for rows that are dragged to other programs; false: it could not.
    using WriteTarget = std::function<bool(TargetId target, const QString& path)>;
    void setWriteTarget(WriteTarget write) { m_writeTarget = std::move(write); }
    [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;

    [[nodiscard]] TargetId targetAt(int row) const;  ///< none: no such row
    [[nodiscard]] int rowOf(TargetId target) const;  ///< -1: no such target

private:
    void reset();
    void add(TargetId target);
    void remove(TargetId target);
    void refresh(TargetId target);
    void countNewHits();
    void recountHits();
    void followHits(int first, int last);
    [[nodiscard]] QString text(const Target& target, int column) const;
    [[nodiscard]] QString toolTip(const Target& target, int column) const;
    [[nodiscard]] std::size_t hitsOn(TargetId target) const;

    Session& m_session;
    /// What the views were told; the session's targets change before it says so.
    std::vector<TargetId> m_rows;
    std::unordered_map<TargetId, std::size_t> m_hits;
    WriteTarget m_writeTarget;
    std::size_t m_counted = 0;  ///< hits of the history that are in m_hits
};

}  // namespace hitscope
