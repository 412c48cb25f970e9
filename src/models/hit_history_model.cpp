// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/hit_history_model.h"

#include <QDataStream>
#include <QIODevice>
#include <QMimeData>
#include <QPointer>
#include <algorithm>

#include "analysis/hit_files.h"
#include "io/staged_files.h"
#include "models/dragged_file.h"
#include "session/frame_costs.h"

namespace hitscope {

namespace {

constexpr auto kRowsType = "application/x-hitscope-hit-rows";

struct Header {
    const char* title;
    const char* explanation;
};
/// One a column, in the order of HitHistoryModel::Column.
constexpr Header kHeaders[HitHistoryModel::ColumnCount] = {
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "#"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Order of the hits, oldest first")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Time (s)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Simulated time of the hit")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Target"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "The target that was struck")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Point (m)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Contact point in the target's local frame: x, y, z")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Direction"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Velocity direction of the projectile just before the hit: unit vector, local frame")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Speed (m/s)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Speed of the projectile just before the hit")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Impulse (N s)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Impulse of the contact, as the physics engine applied it")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Affected"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Vertices that the hit moved")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Greatest (m)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "The longest way that the hit moved a vertex")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "CPU (ms)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Processor time that applying the hit took: its share of those applied with it")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "GPU (ms)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Graphics time that applying the hit took: its share of those applied with it")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Pipeline"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "The pipeline that was active when the hit was made")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Max distance (m)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "The hit's constant: vertices within it are moved")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Power (m²)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "The hit's constant: in the paper's form, a vertex moves by power / distance")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Max magnitude (m)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "The hit's constant: no vertex moves farther")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "World point (m)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "The contact point in the world, where the target stands now: x, y, z")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Surface normal"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Of the surface where it was struck: unit vector, local frame")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Triangle"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "The triangle that was struck, counted from 0")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Group"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Hits that were made together: mirrored, scattered, by one stroke of the brush, or "
                       "grouped by hand")},
};

/// Texts, which stand at the left.
bool isName(int column) {
    return column == HitHistoryModel::TargetColumn || column == HitHistoryModel::PipelineColumn ||
           column == HitHistoryModel::GroupColumn;
}

}  // namespace

HitHistoryModel::HitHistoryModel(Session& session, HitEffects* effects, QObject* parent)
    : QAbstractTableModel(parent),
      m_session(session),
      m_effects(effects),
      m_rows(static_cast<int>(session.hits().history().size())) {
    connect(&session.hits(), &SessionHits::aboutToBeAppended, this, &HitHistoryModel::beginAppend);
    connect(&session.hits(), &SessionHits::appended, this, &HitHistoryModel::endAppend);
    connect(&session.hits(), &SessionHits::changed, this, &HitHistoryModel::refresh);
    connect(&session.hits(), &SessionHits::rearranged, this, &HitHistoryModel::rearrange);
    connect(&session, &Session::sceneReplaced, this, &HitHistoryModel::reset);
    connect(&session.targets(), &SessionTargets::changed, this, &HitHistoryModel::followTarget);
    connect(&session.readBack(), &ReadBack::capacityChanged, this, [this] { refresh(0, m_rows - 1); });
    connect(&session.hits(), &SessionHits::shownChanged, this, [this] { refresh(0, m_rows - 1); });
    connect(&session.frameCosts(), &FrameCosts::hitCostsChanged, this,
            [this](int first, int last) { refreshColumns(first, last, CpuCostColumn, GpuCostColumn); });
    if (effects != nullptr) {
        connect(effects, &HitEffects::effectsChanged, this,
                [this](int first, int last) { refreshColumns(first, last, AffectedColumn, GreatestColumn); });
    }
}

int HitHistoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int HitHistoryModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant HitHistoryModel::data(const QModelIndex& index, int role) const {
    const std::span<const Hit> hits = m_session.hits().history().hits();
    if (!index.isValid() || static_cast<std::size_t>(index.row()) >= hits.size()) {
        return {};
    }
    const auto row = static_cast<std::size_t>(index.row());
    const Hit& hit = hits[row];
    switch (role) {
        case Qt::DisplayRole:
            return text(hit, row, index.column());
        case Qt::CheckStateRole:
            return index.column() == NumberColumn ? QVariant(hit.enabled ? Qt::Checked : Qt::Unchecked)
                                                  : QVariant();
        case Qt::TextAlignmentRole:
            return QVariant((isName(index.column()) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return toolTip(hit, row);
        case HitStateRole:
            return stateOf(row);
        case RawValueRole:
            return rawValue(hit, row, index.column());
        default:
            return {};
    }
}

HitHistoryModel::HitState HitHistoryModel::stateOf(std::size_t row) const {
    if (!m_session.hits().history().hits()[row].enabled) {
        return Disabled;
    }
    if (row >= m_session.hits().shown().size()) {
        return Later;
    }
    return m_session.readBack().isDropped(row) ? Dropped : Applied;
}

QVariant HitHistoryModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (section < 0 || section >= ColumnCount) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
            return tr(kHeaders[section].title);
        case Qt::ToolTipRole:
            return tr(kHeaders[section].explanation);
        default:
            return {};
    }
}

Qt::ItemFlags HitHistoryModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::ItemIsDropEnabled;  // between the rows; the rows themselves take nothing
    }
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemIsDragEnabled;
    return index.column() == NumberColumn ? flags | Qt::ItemIsUserCheckable : flags;
}

bool HitHistoryModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.column() != NumberColumn || role != Qt::CheckStateRole) {
        return false;
    }
    const auto row = static_cast<std::size_t>(index.row());
    m_session.hits().setEnabled({&row, 1}, value.toInt() == Qt::Checked);
    return true;
}

QStringList HitHistoryModel::mimeTypes() const {
    return {QString::fromLatin1(kRowsType)};
}

QMimeData* HitHistoryModel::mimeData(const QModelIndexList& indexes) const {
    QList<qint32> rows;
    rows.reserve(indexes.size());
    for (const QModelIndex& index : indexes) {
        rows.append(index.row());
    }
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out << rows;
    // Dropped on another program it is a table: as text, or as a file.
    const auto text = [model = QPointer<const HitHistoryModel>(this), rows] {
        const std::vector<std::size_t> hits(rows.begin(), rows.end());
        return model.isNull() ? QString() : model->csv(hits);
    };
    const auto write = [text](const QString& path) {
        const QByteArray utf8 = text().toUtf8();
        return writeWhole(path, std::string_view(utf8.constData(), static_cast<std::size_t>(utf8.size())))
            .ok();
    };
    auto* data = new DraggedFile(QStringLiteral("hits.csv"), write, text);
    data->setData(QString::fromLatin1(kRowsType), bytes);
    return data;
}

/// The view then asks to have the rows removed where they came from, which removeRows() refuses: they have
/// been moved already.
bool HitHistoryModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                   const QModelIndex& parent) {
    if (!canDropMimeData(data, action, row, column, parent) || parent.isValid()) {
        return false;
    }
    QList<qint32> rows;
    QDataStream in(data->data(QString::fromLatin1(kRowsType)));
    in >> rows;
    std::vector<std::size_t> moved;
    for (const qint32 from : rows) {
        if (from >= 0) {
            moved.push_back(static_cast<std::size_t>(from));
        }
    }
    m_session.hits().move(moved, static_cast<std::size_t>(row < 0 ? m_rows : row));  // -1: below the last
    return true;
}

QString HitHistoryModel::csv(std::span<const std::size_t> rows) const {
    const HitRecords table =
        rows.empty() ? recordsOf(m_session, m_effects) : recordsOf(m_session, m_effects, rows);
    return QString::fromStdString(toCsv(table));
}

void HitHistoryModel::beginAppend(int first, int last) {
    beginInsertRows({}, first, last);
    m_rowsAfterAppend = last + 1;
}

void HitHistoryModel::endAppend() {
    m_rows = m_rowsAfterAppend;
    endInsertRows();
}

/// It was moved, or has another name.
void HitHistoryModel::followTarget(TargetId id) {
    const Target* target = m_session.targets().find(id);
    QString& known = m_names[id];
    if (target == nullptr || target->name != known) {
        known = target != nullptr ? target->name : QString();
        refreshColumns(0, m_rows - 1, TargetColumn, TargetColumn);
    }
    refreshColumns(0, m_rows - 1, WorldPointColumn, WorldPointColumn);
}

void HitHistoryModel::refresh(int first, int last) {
    refreshColumns(first, last, 0, ColumnCount - 1);
}

/// Rows that the views have not been told of are passed over.
void HitHistoryModel::refreshColumns(int firstRow, int lastRow, int firstColumn, int lastColumn) {
    const int last = std::min(lastRow, m_rows - 1);
    if (firstRow <= last) {
        Q_EMIT dataChanged(index(firstRow, firstColumn), index(last, lastColumn));
    }
}

void HitHistoryModel::rearrange(const HitRows& rows) {
    // The hint spares a selection one index a cell, which would take it minutes to put together again.
    Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
    m_rows = static_cast<int>(rows.size());
    const QModelIndexList before = persistentIndexList();
    QModelIndexList now;
    now.reserve(before.size());
    for (const QModelIndex& old : before) {
        const std::optional<std::size_t> row = rows.now(static_cast<std::size_t>(old.row()));
        now.append(row ? index(static_cast<int>(*row), old.column()) : QModelIndex());
    }
    changePersistentIndexList(before, now);
    Q_EMIT layoutChanged({}, VerticalSortHint);
}

void HitHistoryModel::reset() {
    beginResetModel();
    m_rows = static_cast<int>(m_session.hits().history().size());
    endResetModel();
}

}  // namespace hitscope
