// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractProxyModel>
#include <QTimer>
#include <cstdint>
#include <vector>

#include "models/hit_filter.h"
#include "models/hit_history_model.h"

namespace hitscope {

/// The hit history filtered and sorted by a column, as one sees it: the history's own order stays what it is.
/// Without a filter and in the history's order it costs nothing. What is sorted otherwise follows hits that
/// come and values that change a moment later (kDelay), and many of them are sorted on another thread.
class HitList : public QAbstractProxyModel {
    Q_OBJECT
public:
    /// Both outlive this.
    HitList(Session& session, HitHistoryModel& model, QObject* parent = nullptr);
    ~HitList() override;

    [[nodiscard]] const HitFilter& filter() const { return m_filter; }
    void setFilter(const HitFilter& filter);
    void sort(int column, Qt::SortOrder order) override;
    [[nodiscard]] int sortColumn() const { return m_column; }
    [[nodiscard]] Qt::SortOrder sortOrder() const { return m_order; }
    /// Rows stand as they are applied: they can be dragged to another place.
    [[nodiscard]] bool isInOrder() const;
    /// Nothing is being sorted, and nothing waits to be.
    [[nodiscard]] bool isSettled() const { return !m_isSorting && !m_delay.isActive(); }

    [[nodiscard]] QModelIndex mapToSource(const QModelIndex& index) const override;
    [[nodiscard]] QModelIndex mapFromSource(const QModelIndex& index) const override;
    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& /*child*/) const override { return {}; }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

    static constexpr int kDelay = 150;  ///< milliseconds
    /// More are sorted on another thread.
    static constexpr std::size_t kMostAtOnce = 5'000;

Q_SIGNALS:
    void listed();  ///< other rows, or in another order

private:
    /// What a row is sorted by: three numbers, compared in turn.
    struct Key {
        double parts[3] = {};
        std::uint32_t row = 0;
    };
    static void sortKeys(std::vector<Key>& keys, Qt::SortOrder order);
    [[nodiscard]] bool isPlain() const { return m_filter.isAll() && isInOrder(); }
    void followModel();
    void appended(int first, int last);
    void changed(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QList<int>& roles);
    void beginRearrange();
    void endRearrange();
    void list();
    void listAgain();
    void listAtOnce();
    void takeSorted(const std::vector<Key>& keys, std::uint64_t number);
    [[nodiscard]] std::vector<Key> keysOf(const std::vector<std::uint32_t>& rows) const;
    void show(std::vector<std::uint32_t> rows);
    void place(std::vector<std::uint32_t> rows);

    Session& m_session;
    HitHistoryModel& m_model;
    HitFilter m_filter;
    int m_column = HitHistoryModel::NumberColumn;
    Qt::SortOrder m_order = Qt::AscendingOrder;
    bool m_isListed = false;              ///< else the rows are the history's, and the two below are empty
    std::vector<std::uint32_t> m_rows;    ///< of the history, one a row here
    std::vector<std::uint32_t> m_places;  ///< of its rows here, one a row of the history
    QTimer m_delay;
    bool m_isSorting = false;
    std::uint64_t m_sortNumber = 0;  ///< of the last sorting begun; older results are of no use
    QModelIndexList m_keptHere;
    std::vector<QPersistentModelIndex> m_keptThere;
};

}  // namespace hitscope
