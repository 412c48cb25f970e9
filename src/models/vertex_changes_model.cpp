// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_changes_model.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "models/focus_target.h"
#include "session/vertex_selection.h"

namespace hitscope {

namespace {

constexpr int kPause = 40;              // milliseconds between two rounds while hits stream in
constexpr std::size_t kSlice = 20'000;  // vertices told of at once: about two milliseconds

float turnedOf(const DeformedMesh& mesh, std::uint32_t vertex) {
    return static_cast<float>(vertexFacts(mesh, vertex).turned);
}

}  // namespace

/// Saving may go on while rows are worked out, or for a target that is not shown any more.
struct VertexChangesModel::SharedOrder {
    explicit SharedOrder(std::shared_ptr<const MeshData> original) : order(std::move(original)) {}
    std::mutex mutex;
    VertexChangeOrder order;
};

struct VertexChangesModel::Job {
    std::shared_ptr<SharedOrder> shared;
    std::vector<VertexState> moved;
    VertexQuery query;
    bool wantsRows = false;
    std::vector<std::uint32_t> rows;

    void run(const std::stop_token& /*stop*/) {
        const std::lock_guard lock(shared->mutex);
        shared->order.take(moved);
        if (wantsRows) {
            rows = shared->order.rows(query);
        }
    }
};

VertexChangesModel::VertexChangesModel(Session& session, HitEffects& effects, QObject* parent)
    : QAbstractTableModel(parent), m_session(session), m_effects(effects) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &VertexChangesModel::work);
    connect(&session, &Session::sceneReplaced, this, &VertexChangesModel::startOver);
    connect(&session.targets(), &SessionTargets::removed, this, &VertexChangesModel::followTarget);
    connect(&session.targets(), &SessionTargets::added, this, &VertexChangesModel::followTarget);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &VertexChangesModel::followTarget);
    connect(&session.hits(), &SessionHits::appended, this, &VertexChangesModel::followTarget);
    connect(&session.hits(), &SessionHits::reset, this, &VertexChangesModel::followTarget);
    connect(&session.readBack(), &ReadBack::verticesMoved, this, &VertexChangesModel::noteMoved);
    connect(&session.hits(), &SessionHits::selectedChanged, this, &VertexChangesModel::askForHitVertices);
    connect(&effects, &HitEffects::countsChanged, this, &VertexChangesModel::followCounts);
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

VertexChangesModel::~VertexChangesModel() = default;

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
    m_job.cancel();
    m_pending.clear();
    m_order.reset();
    m_rowsPending = focus != nullptr;
    if (focus != nullptr) {
        m_order = std::make_shared<SharedOrder>(focus->deformed.sharedOriginal());
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

void VertexChangesModel::followCounts(TargetId id, const std::vector<std::uint32_t>& vertices) {
    const Target* shown = target();
    if (id != m_target || shown == nullptr) {
        return;
    }
    const auto concerned = vertices.empty() ? shown->deformed.onceChanged() : std::span(vertices);
    m_pending.insert(m_pending.end(), concerned.begin(), concerned.end());
    m_rowsPending = true;
    schedule();
    askForHitVertices();
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
    if (const auto hit = m_session.hits().selected()) {
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
    return !m_job.isRunning() && !m_rowsPending && m_pending.empty();
}

void VertexChangesModel::schedule() {
    if (m_order && !m_job.isRunning() && !m_timer.isActive()) {
        m_timer.start(m_job.pause(kPause));
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
        moved.push_back(
            {vertex, shown->deformed.positions()[vertex], turnedOf(shown->deformed, vertex), hitsOf(vertex)});
    }
    m_pending.resize(m_pending.size() - count);
    return moved;
}

void VertexChangesModel::work() {
    if (!m_order || m_job.isRunning() || isUpToDate()) {
        return;
    }
    auto job = std::make_shared<Job>();
    job->shared = m_order;
    job->moved = nextMoved();
    job->query = m_query;
    job->wantsRows = m_pending.empty();
    if (job->wantsRows) {
        m_rowsPending = false;
    }
    m_job.start(*this, job, &VertexChangesModel::take);
}

void VertexChangesModel::take(Job& job, bool done) {
    if (!done) {
        m_order.reset();  // there is no memory for rows; everything else goes on
        m_pending.clear();
        m_rowsPending = false;
        adopt({});
        return;
    }
    if (job.wantsRows) {
        adopt(std::move(job.rows));
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
    auto status = std::make_shared<Status>(
        Error{"There is not enough memory for the table.", path.toStdString(), "Show fewer vertices."});
    workBeside(
        this,
        [order = m_order, rows = m_rows, path, status]() mutable {
            std::unique_lock lock(order->mutex);
            const VertexChangesTable table = order->order.table(std::move(rows));
            lock.unlock();
            *status = hitscope::saveCsv(table, path);
        },
        [path, status](VertexChangesModel& self, bool /*done*/) {
            Q_EMIT self.saved(path, *status ? std::nullopt : std::optional(status->error()));
        });
}

}  // namespace hitscope
