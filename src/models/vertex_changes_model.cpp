// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_changes_model.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

#include "models/focus_target.h"
#include "models/quantity_text.h"
#include "session/shown_number.h"
#include "session/vertex_selection.h"

namespace hitscope {

namespace {

constexpr int kPause = 40;              // milliseconds between two rounds while hits stream in
constexpr std::size_t kSlice = 20'000;  // vertices told of at once: about two milliseconds

float turnedOf(const DeformedMesh& mesh, std::uint32_t vertex) {
    return static_cast<float>(vertexFacts(mesh, vertex).turned);
}

QVariant listOf(const glm::vec3& vector) {
    return QVariantList{static_cast<double>(vector.x), static_cast<double>(vector.y),
                        static_cast<double>(vector.z)};
}

}  // namespace

VertexChangesModel::VertexChangesModel(Session& session, HitEffects& effects, QObject* parent)
    : QAbstractTableModel(parent), m_session(session), m_effects(effects) {
    m_pool.setMaxThreadCount(1);
    m_timer.setSingleShot(true);
    m_timer.setInterval(kPause);
    connect(&m_timer, &QTimer::timeout, this, &VertexChangesModel::work);
    connect(&session, &Session::sceneReplaced, this, &VertexChangesModel::startOver);
    connect(&session, &Session::targetRemoved, this, &VertexChangesModel::followTarget);
    connect(&session, &Session::targetAdded, this, &VertexChangesModel::followTarget);
    connect(&session, &Session::targetSelected, this, &VertexChangesModel::followTarget);
    connect(&session, &Session::hitsAppended, this, &VertexChangesModel::followTarget);
    connect(&session, &Session::historyReset, this, &VertexChangesModel::followTarget);
    connect(&session, &Session::verticesMoved, this, &VertexChangesModel::noteMoved);
    connect(&session, &Session::hitSelected, this, &VertexChangesModel::askForHitVertices);
    connect(&effects, &HitEffects::countsChanged, this, [this](TargetId target) {
        if (target == m_target) {
            m_countsPending = true;
            m_rowsPending = true;
            schedule();
            askForHitVertices();
        }
    });
    connect(&effects, &HitEffects::verticesFound, this,
            [this](TargetId target, const std::vector<std::uint32_t>& vertices) {
                if (m_filter == Filter::MovedBySelectedHit && target == m_target) {
                    showOnly(vertices);
                }
            });
    const VertexSelection& selection = session.selection();
    connect(&selection, &VertexSelection::selectionChanged, this, &VertexChangesModel::followSelection);
    connect(&selection, &VertexSelection::pickedChanged, this, &VertexChangesModel::followSelection);
    startOver();
}

VertexChangesModel::~VertexChangesModel() {
    m_pool.waitForDone();
}

// What is shown

void VertexChangesModel::followTarget() {
    const Target* focus = focusTarget(m_session);
    if ((focus != nullptr ? focus->id : TargetId{}) != m_target) {
        startOver();
    }
}

void VertexChangesModel::startOver() {
    const Target* focus = focusTarget(m_session);
    beginResetModel();
    m_rows.clear();
    m_target = focus != nullptr ? focus->id : TargetId{};
    ++m_generation;
    m_pending.clear();
    m_order.reset();
    m_countsPending = m_rowsPending = focus != nullptr;
    if (focus != nullptr) {
        m_order = std::make_shared<VertexChangeOrder>(focus->deformed.sharedOriginal());
        const auto changed = focus->deformed.onceChanged();
        m_pending.assign(changed.begin(), changed.end());
    }
    endResetModel();
    Q_EMIT targetChanged();
    if (m_filter == Filter::Selected) {
        followSelection();
    } else if (m_filter == Filter::MovedBySelectedHit) {
        showOnly({});
        askForHitVertices();
    }
    schedule();
}

void VertexChangesModel::noteMoved(TargetId target, const std::vector<std::uint32_t>& vertices) {
    if (target == m_target) {
        m_pending.insert(m_pending.end(), vertices.begin(), vertices.end());
        schedule();
    }
}

void VertexChangesModel::setFilter(Filter filter) {
    if (filter == m_filter) {
        return;
    }
    m_filter = filter;
    if (filter == Filter::AllChanged) {
        m_query.only.reset();
        m_rowsPending = true;
        schedule();
    } else if (filter == Filter::Selected) {
        followSelection();
    } else {
        showOnly({});
        askForHitVertices();
    }
}

void VertexChangesModel::setLeastDisplacement(double metres) {
    m_query.leastLength = static_cast<float>(metres);
    m_rowsPending = true;
    schedule();
}

void VertexChangesModel::sort(int column, Qt::SortOrder order) {
    m_query.key = static_cast<VertexQuery::Key>(std::clamp(column, 0, ColumnCount - 1));
    m_query.descending = order == Qt::DescendingOrder;
    m_rowsPending = true;
    schedule();
}

void VertexChangesModel::followSelection() {
    if (m_filter == Filter::Selected) {
        const auto selected = m_session.selection().vertices(m_target);
        showOnly({selected.begin(), selected.end()});
    }
    if (!m_rows.empty()) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {SelectedRole, PickedRole});
    }
}

void VertexChangesModel::askForHitVertices() {
    if (m_filter != Filter::MovedBySelectedHit) {
        return;
    }
    if (const auto hit = m_session.selectedHit()) {
        m_effects.findVertices(*hit);
    } else {
        showOnly({});
    }
}

void VertexChangesModel::showOnly(std::vector<std::uint32_t> vertices) {
    m_query.only = std::make_shared<const std::vector<std::uint32_t>>(std::move(vertices));
    m_rowsPending = true;
    schedule();
}

// Working it out

bool VertexChangesModel::isUpToDate() const {
    return !m_working && !m_rowsPending && m_pending.empty();
}

void VertexChangesModel::schedule() {
    if (m_order && !m_working && !m_timer.isActive()) {
        m_timer.start();
    }
}

/// The next slice, so that a million of them do not hold up the window.
std::vector<VertexState> VertexChangesModel::nextMoved() {
    std::vector<VertexState> moved;
    const Target* shown = target();
    if (shown == nullptr) {
        m_pending.clear();
        return moved;
    }
    const std::size_t count = std::min(m_pending.size(), kSlice);
    moved.reserve(count);
    for (std::size_t i = m_pending.size() - count; i < m_pending.size(); ++i) {
        const std::uint32_t vertex = m_pending[i];
        moved.push_back({vertex, shown->deformed.positions()[vertex], turnedOf(shown->deformed, vertex)});
    }
    m_pending.resize(m_pending.size() - count);
    return moved;
}

void VertexChangesModel::work() {
    if (!m_order || m_working || isUpToDate()) {
        return;
    }
    m_working = true;
    std::vector<VertexState> moved = nextMoved();
    const bool wantsRows = m_pending.empty();
    std::optional<std::vector<std::uint32_t>> counts;
    if (std::exchange(m_countsPending, false)) {
        const auto known = m_effects.counts(m_target);
        counts.emplace(known.begin(), known.end());
    }
    if (wantsRows) {
        m_rowsPending = false;
    }
    m_pool.start([this, order = m_order, generation = m_generation, query = m_query, wantsRows,
                  moved = std::move(moved), counts = std::move(counts)] {
        order->take(moved);
        if (counts) {
            order->takeCounts(*counts);
        }
        std::vector<std::uint32_t> rows;
        if (wantsRows) {
            rows = order->rows(query);
        }
        QMetaObject::invokeMethod(
            this,
            [this, generation, wantsRows, made = std::move(rows)]() mutable {
                finish(generation, wantsRows, std::move(made));
            },
            Qt::QueuedConnection);
    });
}

void VertexChangesModel::finish(std::uint64_t generation, bool hasRows, std::vector<std::uint32_t> rows) {
    m_working = false;
    if (generation == m_generation && hasRows) {
        adopt(std::move(rows));
    }
    if (!m_pending.empty()) {
        work();  // the next slice at once
    } else if (m_rowsPending) {
        schedule();
    }
}

/// Rows come and go at the end, then take their new places: what views do about that does not depend on how
/// many have moved.
void VertexChangesModel::adopt(std::vector<std::uint32_t> rows) {
    const int before = rowCount();
    const int after = static_cast<int>(rows.size());
    if (rows == m_rows) {
        if (after > 0) {
            Q_EMIT dataChanged(index(0, 0), index(after - 1, ColumnCount - 1));
        }
        return;
    }
    if (after > before) {
        beginInsertRows({}, before, after - 1);
        m_rows.insert(m_rows.end(), rows.begin() + before, rows.end());
        endInsertRows();
    } else if (after < before) {
        beginRemoveRows({}, after, before - 1);
        m_rows.resize(rows.size());
        endRemoveRows();
    }
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
    const QModelIndexList kept = persistentIndexList();
    std::vector<std::uint32_t> vertices;
    for (const QModelIndex& index : kept) {
        vertices.push_back(vertexAt(index.row()));
    }
    m_rows = std::move(rows);
    QModelIndexList moved;
    for (qsizetype i = 0; i < kept.size(); ++i) {
        const int row = rowOf(vertices[static_cast<std::size_t>(i)]);
        moved.append(row >= 0 ? index(row, kept[i].column()) : QModelIndex());
    }
    changePersistentIndexList(kept, moved);
    Q_EMIT layoutChanged({}, VerticalSortHint);
    Q_EMIT rowsFollowed();
}

int VertexChangesModel::rowOf(std::uint32_t vertex) const {
    const auto found = std::find(m_rows.begin(), m_rows.end(), vertex);
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

VertexChangesTable VertexChangesModel::table(std::vector<std::uint32_t> vertices) const {
    VertexChangesTable table;
    if (const Target* shown = target()) {
        table.original = shown->deformed.sharedOriginal();
        table.rows = std::move(vertices);
        for (const std::uint32_t vertex : table.rows) {
            table.values.push_back(
                {shown->deformed.positions()[vertex], turnedOf(shown->deformed, vertex), hitsOf(vertex)});
        }
    }
    return table;
}

void VertexChangesModel::saveCsv(const QString& path) {
    if (!m_order) {
        return;
    }
    m_pool.start([this, order = m_order, rows = m_rows, path] {
        const Status status = hitscope::saveCsv(order->table(rows), path);
        QMetaObject::invokeMethod(
            this,
            [this, path, status] {
                Q_EMIT saved(path, status ? std::nullopt : std::optional(status.error()));
            },
            Qt::QueuedConnection);
    });
}

// What a view sees

int VertexChangesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int VertexChangesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

std::uint32_t VertexChangesModel::hitsOf(std::uint32_t vertex) const {
    const auto counts = m_effects.counts(m_target);
    return vertex < counts.size() ? counts[vertex] : 0;
}

QString VertexChangesModel::text(std::uint32_t vertex, int column) const {
    const VertexFacts facts = vertexFacts(target()->deformed, vertex);
    switch (column) {
        case NumberColumn:
            return vertexNumberText(vertex);
        case OriginalColumn:
            return vectorText(facts.original);
        case CurrentColumn:
            return vectorText(facts.current);
        case DisplacementColumn:
            return vectorText(facts.displacement);
        case LengthColumn:
            return quantityText(facts.length);
        case TurnedColumn:
            return shownNumber(glm::degrees(facts.turned), 'f', 1);
        case HitsColumn:
            return countText(hitsOf(vertex));
        default:
            return {};
    }
}

QVariant VertexChangesModel::rawValue(std::uint32_t vertex, int column) const {
    const VertexFacts facts = vertexFacts(target()->deformed, vertex);
    switch (column) {
        case NumberColumn:
            return qulonglong{vertex} + 1;
        case OriginalColumn:
            return listOf(facts.original);
        case CurrentColumn:
            return listOf(facts.current);
        case DisplacementColumn:
            return listOf(facts.displacement);
        case LengthColumn:
            return facts.length;
        case TurnedColumn:
            return facts.turned;
        case HitsColumn:
            return static_cast<qulonglong>(hitsOf(vertex));
        default:
            return {};
    }
}

QVariant VertexChangesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount() || target() == nullptr) {
        return {};
    }
    const std::uint32_t vertex = vertexAt(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return text(vertex, index.column());
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case VertexRole:
            return vertex;
        case SelectedRole:
            return m_session.selection().isSelected({m_target, vertex});
        case PickedRole:
            return m_session.selection().picked() == VertexRef{m_target, vertex};
        case RawValueRole:
            return rawValue(vertex, index.column());
        default:
            return {};
    }
}

QVariant VertexChangesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    const QString titles[ColumnCount] = {
        tr("Vertex"),           tr("Original (m)"), tr("Current (m)"), tr("Displacement x, y, z (m)"),
        tr("Displacement (m)"), tr("Normal (°)"),   tr("Hits")};
    const QString explanations[ColumnCount] = {
        tr("The vertex's number in the file, counted from 1"),
        tr("Where it was: x, y, z in the target's own frame"),
        tr("Where the active pipeline has it"),
        tr("Displacement: current less original"),
        tr("Length of the displacement"),
        tr("By how much its normal has turned, as the pipeline holds it (the paper's equation 2)"),
        tr("How many hits moved it")};
    switch (role) {
        case Qt::DisplayRole:
            return titles[section];
        case Qt::ToolTipRole:
            return explanations[section];
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

}  // namespace hitscope
