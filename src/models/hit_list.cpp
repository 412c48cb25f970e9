// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/hit_list.h"
#include "analysis/beside.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>

namespace hitscope {

namespace {

constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();

}  // namespace

HitList::HitList(Session& session, HitHistoryModel& model, QObject* parent)
    : QAbstractProxyModel(parent), m_session(session), m_model(model) {
    m_delay.setSingleShot(true);
    m_delay.setInterval(kDelay);
    connect(&m_delay, &QTimer::timeout, this, &HitList::listAgain);
    followModel();
}

HitList::~HitList() = default;

void HitList::followModel() {
    QAbstractProxyModel::setSourceModel(&m_model);
    connect(&m_model, &QAbstractItemModel::rowsAboutToBeInserted, this,
            [this](const QModelIndex&, int first, int last) {
                if (!m_isListed) {
                    beginInsertRows({}, first, last);
                }
            });
    connect(&m_model, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int first, int last) { appended(first, last); });
    connect(&m_model, &QAbstractItemModel::dataChanged, this, &HitList::changed);
    connect(&m_model, &QAbstractItemModel::layoutAboutToBeChanged, this, &HitList::beginRearrange);
    connect(&m_model, &QAbstractItemModel::layoutChanged, this, &HitList::endRearrange);
    connect(&m_model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
    connect(&m_model, &QAbstractItemModel::modelReset, this, [this] {
        listAtOnce();
        endResetModel();
    });
}

bool HitList::isInOrder() const {
    return m_column == HitHistoryModel::NumberColumn && m_order == Qt::AscendingOrder;
}

void HitList::setFilter(const HitFilter& filter) {
    if (filter != m_filter) {
        m_filter = filter;
        list();
    }
}

void HitList::sort(int column, Qt::SortOrder order) {
    const int by =
        column < 0 || column >= HitHistoryModel::ColumnCount ? HitHistoryModel::NumberColumn : column;
    if (by != m_column || order != m_order) {
        m_column = by;
        m_order = order;
        list();
    }
}

QModelIndex HitList::mapToSource(const QModelIndex& index) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const int row =
        m_isListed ? static_cast<int>(m_rows[static_cast<std::size_t>(index.row())]) : index.row();
    return m_model.index(row, index.column());
}

QModelIndex HitList::mapFromSource(const QModelIndex& index) const {
    if (!index.isValid()) {
        return {};
    }
    if (!m_isListed) {
        return createIndex(index.row(), index.column());
    }
    const auto row = static_cast<std::size_t>(index.row());
    const bool isHere = row < m_places.size() && m_places[row] != kNowhere;
    return isHere ? createIndex(static_cast<int>(m_places[row]), index.column()) : QModelIndex();
}

QModelIndex HitList::index(int row, int column, const QModelIndex& parent) const {
    const bool exists = !parent.isValid() && row >= 0 && row < rowCount() && column >= 0 &&
                        column < HitHistoryModel::ColumnCount;
    return exists ? createIndex(row, column) : QModelIndex();
}

int HitList::rowCount(const QModelIndex& parent) const {
    if (parent.isValid()) {
        return 0;
    }
    return m_isListed ? static_cast<int>(m_rows.size()) : m_model.rowCount();
}

int HitList::columnCount(const QModelIndex& parent) const {
    return m_model.columnCount(parent);
}

QVariant HitList::headerData(int section, Qt::Orientation orientation, int role) const {
    return m_model.headerData(section, orientation, role);
}

/// Rows that stand in another order cannot be dragged to a place in the history.
Qt::ItemFlags HitList::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = m_model.flags(mapToSource(index));
    return isInOrder() ? flags : flags & ~(Qt::ItemIsDragEnabled | Qt::ItemIsDropEnabled);
}

/// Below the last row here is right behind it, whatever follows in the history.
bool HitList::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                           const QModelIndex& parent) {
    if (!isInOrder() || parent.isValid()) {
        return false;
    }
    int place = row;
    if (m_isListed && !m_rows.empty()) {
        const bool isBelow = row < 0 || static_cast<std::size_t>(row) >= m_rows.size();
        place = static_cast<int>(isBelow ? m_rows.back() + 1 : m_rows[static_cast<std::size_t>(row)]);
    }
    return m_model.dropMimeData(data, action, place, column, {});
}

void HitList::appended(int first, int last) {
    if (!m_isListed) {
        endInsertRows();
        if (m_isSorting && !m_delay.isActive()) {
            m_delay.start();  // what is being sorted goes without them
        }
        return;
    }
    m_places.resize(static_cast<std::size_t>(last) + 1, kNowhere);
    if (!isInOrder()) {
        if (!m_delay.isActive()) {
            m_delay.start();
        }
        return;
    }
    const std::vector<std::uint32_t> more = acceptedHits(
        m_session, m_filter, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last) + 1);
    if (more.empty()) {
        return;
    }
    const std::size_t before = m_rows.size();
    beginInsertRows({}, static_cast<int>(before), static_cast<int>(before + more.size()) - 1);
    for (const std::uint32_t row : more) {
        m_places[row] = static_cast<std::uint32_t>(m_rows.size());
        m_rows.push_back(row);
    }
    endInsertRows();
    Q_EMIT listed();
}

void HitList::changed(const QModelIndex& topLeft, const QModelIndex& bottomRight, const QList<int>& roles) {
    if (!m_isListed) {
        Q_EMIT dataChanged(createIndex(topLeft.row(), topLeft.column()),
                           createIndex(bottomRight.row(), bottomRight.column()), roles);
        if (!m_isSorting) {
            return;
        }
    } else if (!m_rows.empty()) {
        const bool isOne = topLeft.row() == bottomRight.row();
        const QModelIndex first = isOne ? mapFromSource(topLeft) : createIndex(0, topLeft.column());
        const int last = isOne ? first.row() : rowCount() - 1;
        if (first.isValid()) {
            Q_EMIT dataChanged(first, createIndex(last, bottomRight.column()), roles);
        }
    }
    const bool isFiltered = !m_filter.isAll() && isFilteredBy(topLeft.column(), bottomRight.column());
    const bool isSorted = m_column >= topLeft.column() && m_column <= bottomRight.column() && !isInOrder();
    if ((isSorted || isFiltered) && !m_delay.isActive()) {
        m_delay.start();
    }
}

void HitList::beginRearrange() {
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);  // as in HitHistoryModel::rearrange()
    m_keptHere = persistentIndexList();
    m_keptThere.clear();
    for (const QModelIndex& kept : m_keptHere) {
        m_keptThere.emplace_back(mapToSource(kept));
    }
}

void HitList::endRearrange() {
    listAtOnce();
    QModelIndexList now;
    now.reserve(m_keptHere.size());
    for (const QPersistentModelIndex& kept : m_keptThere) {
        now.append(mapFromSource(kept));
    }
    changePersistentIndexList(m_keptHere, now);
    m_keptHere.clear();
    m_keptThere.clear();
    Q_EMIT layoutChanged({}, VerticalSortHint);
    Q_EMIT listed();
}

std::vector<HitList::Key> HitList::keysOf(const std::vector<std::uint32_t>& rows) const {
    // Once for all hits: finding one takes a look at each.
    std::unordered_map<TargetId, const Target*> targets;
    std::vector<std::pair<QString, TargetId>> byName;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        targets[target->id] = target.get();
        byName.emplace_back(target->name, target->id);
    }
    std::sort(byName.begin(), byName.end());
    std::map<TargetId, double> ranks;
    for (std::size_t i = 0; i < byName.size(); ++i) {
        ranks[byName[i].second] = static_cast<double>(i);
    }
    std::vector<Key> keys;
    keys.reserve(rows.size());
    for (const std::uint32_t row : rows) {
        Key& key = keys.emplace_back();
        key.row = row;
        const Hit& hit = m_session.hits().history().hits()[row];
        if (m_column == HitHistoryModel::TargetColumn) {
            key.parts[0] = ranks[hit.target];
        } else if (m_column == HitHistoryModel::WorldPointColumn) {
            const auto target = targets.find(hit.target);
            const glm::vec3 point =
                target != targets.end() ? target->second->transform.toWorld(hit.point) : glm::vec3(0.0f);
            std::copy_n(&point.x, 3, key.parts);
        } else {
            m_model.sortParts(row, m_column, key.parts);
        }
    }
    return keys;
}

/// Equal ones stay in the history's order.
void HitList::sortKeys(std::vector<Key>& keys, Qt::SortOrder order) {
    std::sort(keys.begin(), keys.end(), [order](const Key& a, const Key& b) {
        for (std::size_t i = 0; i < std::size(a.parts); ++i) {
            if (a.parts[i] != b.parts[i]) {
                return order == Qt::AscendingOrder ? a.parts[i] < b.parts[i] : a.parts[i] > b.parts[i];
            }
        }
        return a.row < b.row;
    });
}

/// Finds out what is to be shown, and shows it at once or, if there is much to sort, when that is done.
void HitList::list() {
    m_delay.stop();
    ++m_sortNumber;
    m_isSorting = false;
    const auto all = static_cast<std::uint32_t>(m_model.rowCount());
    if (isPlain()) {
        show({});
        return;
    }
    std::vector<std::uint32_t> rows = acceptedHits(m_session, m_filter, 0, all);
    if (isInOrder() || rows.size() <= kMostAtOnce) {
        if (!isInOrder()) {
            std::vector<Key> keys = keysOf(rows);
            sortKeys(keys, m_order);
            std::transform(keys.begin(), keys.end(), rows.begin(), [](const Key& key) { return key.row; });
        }
        show(std::move(rows));
        return;
    }
    m_isSorting = true;
    auto keys = std::make_shared<std::vector<Key>>(keysOf(rows));
    workBeside(
        this, [keys, order = m_order] { sortKeys(*keys, order); },
        [keys, number = m_sortNumber](HitList& self, bool) { self.takeSorted(*keys, number); });
}

/// What is being sorted is shown first, however fast values change.
void HitList::listAgain() {
    if (m_isSorting) {
        m_delay.start();
    } else {
        list();
    }
}

void HitList::takeSorted(const std::vector<Key>& keys, std::uint64_t number) {
    if (number != m_sortNumber) {
        return;
    }
    std::vector<std::uint32_t> sorted(keys.size());
    std::transform(keys.begin(), keys.end(), sorted.begin(), [](const Key& key) { return key.row; });
    m_isSorting = false;
    show(std::move(sorted));
}

/// Within a change of the model, which cannot wait.
void HitList::listAtOnce() {
    m_delay.stop();
    ++m_sortNumber;
    m_isSorting = false;
    if (isPlain()) {
        place({});
        return;
    }
    std::vector<std::uint32_t> rows =
        acceptedHits(m_session, m_filter, 0, static_cast<std::uint32_t>(m_model.rowCount()));
    if (!isInOrder()) {
        std::vector<Key> keys = keysOf(rows);
        sortKeys(keys, m_order);
        std::transform(keys.begin(), keys.end(), rows.begin(), [](const Key& key) { return key.row; });
    }
    place(std::move(rows));
}

void HitList::show(std::vector<std::uint32_t> rows) {
    if (m_isListed && !isPlain() && rows == m_rows) {
        return;
    }
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);  // as in HitHistoryModel::rearrange()
    const QModelIndexList before = persistentIndexList();
    std::vector<QModelIndex> there;
    there.reserve(static_cast<std::size_t>(before.size()));
    for (const QModelIndex& kept : before) {
        there.push_back(mapToSource(kept));
    }
    place(std::move(rows));
    QModelIndexList now;
    now.reserve(before.size());
    for (const QModelIndex& kept : there) {
        now.append(mapFromSource(kept));
    }
    changePersistentIndexList(before, now);
    Q_EMIT layoutChanged({}, VerticalSortHint);
    Q_EMIT listed();
}

void HitList::place(std::vector<std::uint32_t> rows) {
    m_isListed = !isPlain();
    m_rows = m_isListed ? std::move(rows) : std::vector<std::uint32_t>();
    m_places.assign(m_isListed ? static_cast<std::size_t>(m_model.rowCount()) : 0, kNowhere);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_places[m_rows[i]] = static_cast<std::uint32_t>(i);
    }
}

}  // namespace hitscope
