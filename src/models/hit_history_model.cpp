// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/hit_history_model.h"

#include <QDataStream>
#include <QIODevice>
#include <QMimeData>
#include <algorithm>

#include "models/quantity_text.h"

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
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Simulated time of the impact")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Target"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "The target that was struck")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Point (m)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Contact point in the target's local frame: x, y, z")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Direction"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Velocity direction of the projectile just before impact: unit vector, local frame")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Speed (m/s)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Speed of the projectile just before impact")},
    {QT_TRANSLATE_NOOP("hitscope::HitHistoryModel", "Impulse (N s)"),
     QT_TRANSLATE_NOOP("hitscope::HitHistoryModel",
                       "Impulse of the contact, as the physics engine applied it")},
};

QVariant rawValue(const Hit& hit, int row, int column) {
    const auto list = [](const glm::vec3& v) {
        return QVariantList{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
    };
    switch (column) {
        case HitHistoryModel::NumberColumn:
            return static_cast<qulonglong>(row) + 1;
        case HitHistoryModel::TimeColumn:
            return hit.time;
        case HitHistoryModel::TargetColumn:
            return static_cast<qulonglong>(hit.target.value);
        case HitHistoryModel::PointColumn:
            return list(hit.point);
        case HitHistoryModel::DirectionColumn:
            return list(hit.direction);
        case HitHistoryModel::SpeedColumn:
            return static_cast<double>(hit.speed);
        case HitHistoryModel::ImpulseColumn:
            return static_cast<double>(hit.impulse);
        default:
            return {};
    }
}

/// A field as RFC 4180 wants it.
QString csvField(QString text) {
    if (text.contains(u'"') || text.contains(u',') || text.contains(u'\n')) {
        text.replace(u'"', QStringLiteral("\"\""));
        return u'"' + text + u'"';
    }
    return text;
}

/// Nine digits bring the same float back.
QString exact(float value) {
    return QString::number(static_cast<double>(value), 'g', 9);
}

}  // namespace

HitHistoryModel::HitHistoryModel(Session& session, QObject* parent)
    : QAbstractTableModel(parent), m_session(session), m_rows(static_cast<int>(session.history().size())) {
    connect(&session, &Session::hitsAboutToBeAppended, this, &HitHistoryModel::beginAppend);
    connect(&session, &Session::hitsAppended, this, &HitHistoryModel::endAppend);
    connect(&session, &Session::hitsChanged, this, &HitHistoryModel::refresh);
    connect(&session, &Session::hitsRearranged, this, &HitHistoryModel::rearrange);
    connect(&session, &Session::sceneReplaced, this, &HitHistoryModel::reset);
    // Its name may have.
    connect(&session, &Session::targetChanged, this, [this] { refresh(0, m_rows - 1); });
    connect(&session, &Session::capacityChanged, this, [this] { refresh(0, m_rows - 1); });
}

int HitHistoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int HitHistoryModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant HitHistoryModel::data(const QModelIndex& index, int role) const {
    const std::span<const Hit> hits = m_session.history().hits();
    if (!index.isValid() || static_cast<std::size_t>(index.row()) >= hits.size()) {
        return {};
    }
    const auto row = static_cast<std::size_t>(index.row());
    const Hit& hit = hits[row];
    switch (role) {
        case Qt::DisplayRole:
            return text(hit, index.row(), index.column());
        case Qt::CheckStateRole:
            return index.column() == NumberColumn ? QVariant(hit.enabled ? Qt::Checked : Qt::Unchecked)
                                                  : QVariant();
        case Qt::TextAlignmentRole:
            return index.column() == TargetColumn ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                                  : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return toolTip(hit, row);
        case HitStateRole:
            return stateOf(row);
        case RawValueRole:
            return rawValue(hit, index.row(), index.column());
        default:
            return {};
    }
}

QString HitHistoryModel::text(const Hit& hit, int row, int column) const {
    switch (column) {
        case NumberColumn:
            return countText(static_cast<std::size_t>(row) + 1);
        case TimeColumn:
            return QString::number(hit.time, 'f', 2);
        case TargetColumn:
            return targetName(hit);
        case PointColumn:
            return vectorText(hit.point);
        case DirectionColumn:
            return vectorText(hit.direction);
        case SpeedColumn:
            return QString::number(static_cast<double>(hit.speed), 'f', 2);
        case ImpulseColumn:
            return QString::number(static_cast<double>(hit.impulse), 'f', 2);
        default:
            return {};
    }
}

HitHistoryModel::HitState HitHistoryModel::stateOf(std::size_t row) const {
    if (!m_session.history().hits()[row].enabled) {
        return Disabled;
    }
    return m_session.isDropped(row) ? Dropped : Applied;
}

QString HitHistoryModel::toolTip(const Hit& hit, std::size_t row) const {
    QString tip = tr("Max distance %1 m, power %2 m², max magnitude %3 m")
                      .arg(quantityText(static_cast<double>(hit.constants.maxDistance)),
                           quantityText(static_cast<double>(hit.constants.power)),
                           quantityText(static_cast<double>(hit.constants.maxMagnitude)));
    const HitState state = stateOf(row);
    if (state == Disabled) {
        tip.prepend(tr("Disabled: the mesh is as if this hit had not been made.") + u'\n');
    } else if (state == Dropped) {
        const CapacityReport& report = m_session.capacity();
        const std::string_view pipeline = pipelineTraits(m_session.pipeline()).name;
        const QString why = report.perTarget
                                ? tr("Dropped: the pipeline “%1” keeps the last %2 hits on each target.")
                                : tr("Dropped: the pipeline “%1” keeps the last %2 hits of the scene.");
        tip.prepend(why.arg(QString::fromUtf8(pipeline.data(), static_cast<qsizetype>(pipeline.size())),
                            countText(report.capacity.value_or(report.used))) +
                    u'\n');
    }
    return tip;
}

QString HitHistoryModel::targetName(const Hit& hit) const {
    const Target* target = m_session.target(hit.target);
    return target != nullptr ? target->name : QString();
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
    m_session.setHitsEnabled({&row, 1}, value.toInt() == Qt::Checked);
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
    auto* data = new QMimeData;
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
    m_session.moveHits(moved, static_cast<std::size_t>(row < 0 ? m_rows : row));  // -1: below the last
    return true;
}

QString HitHistoryModel::csv(std::span<const int> rows) const {
    QString text = QStringLiteral(
        "number,time_s,target,point_x_m,point_y_m,point_z_m,direction_x,direction_y,direction_z,"
        "speed_m_per_s,impulse_n_s,max_distance_m,power_m2,max_magnitude_m,enabled\n");
    const std::span<const Hit> hits = m_session.history().hits();
    const auto append = [&](std::size_t row) {
        if (row >= hits.size()) {
            return;
        }
        const Hit& hit = hits[row];
        const QStringList fields{QString::number(row + 1),
                                 QString::number(hit.time, 'g', 17),
                                 csvField(targetName(hit)),
                                 exact(hit.point.x),
                                 exact(hit.point.y),
                                 exact(hit.point.z),
                                 exact(hit.direction.x),
                                 exact(hit.direction.y),
                                 exact(hit.direction.z),
                                 exact(hit.speed),
                                 exact(hit.impulse),
                                 exact(hit.constants.maxDistance),
                                 exact(hit.constants.power),
                                 exact(hit.constants.maxMagnitude),
                                 QString::number(hit.enabled ? 1 : 0)};
        text += fields.join(u',') + u'\n';
    };
    if (rows.empty()) {
        for (std::size_t row = 0; row < hits.size(); ++row) {
            append(row);
        }
    }
    for (const int row : rows) {
        append(static_cast<std::size_t>(row));
    }
    return text;
}

void HitHistoryModel::beginAppend(int first, int last) {
    beginInsertRows({}, first, last);
    m_rowsAfterAppend = last + 1;
}

void HitHistoryModel::endAppend() {
    m_rows = m_rowsAfterAppend;
    endInsertRows();
}

void HitHistoryModel::refresh(int first, int last) {
    if (first <= last) {
        Q_EMIT dataChanged(index(first, 0), index(last, ColumnCount - 1));
    }
}

void HitHistoryModel::rearrange(const HitRows& rows) {
    Q_EMIT layoutAboutToBeChanged();
    m_rows = static_cast<int>(rows.size());
    const QModelIndexList before = persistentIndexList();
    QModelIndexList now;
    now.reserve(before.size());
    for (const QModelIndex& old : before) {
        const std::optional<std::size_t> row = rows.now(static_cast<std::size_t>(old.row()));
        now.append(row ? index(static_cast<int>(*row), old.column()) : QModelIndex());
    }
    changePersistentIndexList(before, now);
    Q_EMIT layoutChanged();
}

void HitHistoryModel::reset() {
    beginResetModel();
    m_rows = static_cast<int>(m_session.history().size());
    endResetModel();
}

}  // namespace hitscope
