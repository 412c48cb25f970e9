// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/scene_model.h"

#include <algorithm>

#include "models/dragged_file.h"
#include "models/plain_text.h"
#include "models/quantity_text.h"

namespace hitscope {

SceneModel::SceneModel(Session& session, QObject* parent) : QAbstractTableModel(parent), m_session(session) {
    connect(&session, &Session::sceneReplaced, this, &SceneModel::reset);
    connect(&session.targets(), &SessionTargets::added, this, &SceneModel::add);
    connect(&session.targets(), &SessionTargets::removed, this, &SceneModel::remove);
    connect(&session.targets(), &SessionTargets::changed, this, &SceneModel::refresh);
    connect(&session.hits(), &SessionHits::appended, this, &SceneModel::countNewHits);
    connect(&session.hits(), &SessionHits::rearranged, this, &SceneModel::recountHits);
    connect(&session.hits(), &SessionHits::changed, this, &SceneModel::followHits);
    reset();
}

void SceneModel::reset() {
    beginResetModel();
    m_rows.clear();
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        m_rows.push_back(target->id);
    }
    m_hits.clear();
    m_counted = 0;
    endResetModel();
    countNewHits();
}

void SceneModel::add(TargetId target) {
    const SessionTargets& targets = m_session.targets();
    const auto at = std::find_if(targets.begin(), targets.end(),
                                 [target](const auto& candidate) { return candidate->id == target; });
    const auto row = std::min(static_cast<int>(at - targets.begin()), rowCount());
    beginInsertRows({}, row, row);
    m_rows.insert(m_rows.begin() + row, target);
    endInsertRows();
}

void SceneModel::remove(TargetId target) {
    if (const int row = rowOf(target); row >= 0) {
        beginRemoveRows({}, row, row);
        m_rows.erase(m_rows.begin() + row);
        endRemoveRows();
    }
}

void SceneModel::refresh(TargetId target) {
    if (const int row = rowOf(target); row >= 0) {
        Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    }
}

/// Costs the hits that are new, not those made before.
void SceneModel::countNewHits() {
    const std::span<const Hit> hits = m_session.hits().history().hits();
    TargetId target;
    std::size_t* count = nullptr;  // of that one: neighbours are often on the same
    for (; m_counted < hits.size(); ++m_counted) {
        if (count == nullptr || hits[m_counted].target != target) {
            target = hits[m_counted].target;
            count = &m_hits[target];
        }
        ++*count;
    }
    if (!m_rows.empty()) {
        Q_EMIT dataChanged(index(0, HitsColumn), index(rowCount() - 1, HitsColumn));
    }
}

/// Hits on a mesh that took another's place are on a target that has none yet.
void SceneModel::followHits(int first, int last) {
    const std::span<const Hit> hits = m_session.hits().history().hits();
    const auto isNew = [this](const Hit& hit) { return hitsOn(hit.target) == 0; };
    if (std::any_of(hits.begin() + first, hits.begin() + last + 1, isNew)) {
        recountHits();
    }
}

void SceneModel::recountHits() {
    m_hits.clear();
    m_counted = 0;
    countNewHits();
}

TargetId SceneModel::targetAt(int row) const {
    return row >= 0 && row < rowCount() ? m_rows[static_cast<std::size_t>(row)] : TargetId{};
}

int SceneModel::rowOf(TargetId target) const {
    const auto found = std::find(m_rows.begin(), m_rows.end(), target);
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

int SceneModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int SceneModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

std::size_t SceneModel::hitsOn(TargetId target) const {
    const auto found = m_hits.find(target);
    return found == m_hits.end() ? 0 : found->second;
}

QString SceneModel::text(const Target& target, int column) const {
    switch (column) {
        case NameColumn:
            return target.name;
        case VerticesColumn:
            return countText(target.deformed.original().vertexCount());
        case HitsColumn:
            return countText(hitsOn(target.id));
        default:
            return {};
    }
}

QString SceneModel::toolTip(const Target& target, int column) const {
    if (column == VisibleColumn) {
        return target.visible ? tr("Visible: click to hide it") : tr("Hidden: click to show it");
    }
    if (const QString reason = m_session.simulation().whyNotHittable(target.id);
        column == NameColumn && !reason.isEmpty()) {
        return tr("Cannot be hit. %1").arg(reason);
    }
    return column == NameColumn && !target.sourcePath.isEmpty() ? target.sourcePath : QString();
}

QVariant SceneModel::data(const QModelIndex& index, int role) const {
    const Target* target = m_session.targets().find(targetAt(index.row()));
    if (!index.isValid() || target == nullptr) {
        return {};
    }
    const int column = index.column();
    switch (role) {
        case Qt::DisplayRole:
            return text(*target, column);
        case Qt::EditRole:
            return column == NameColumn ? QVariant(target->name) : QVariant();
        case Qt::CheckStateRole:
            return column == VisibleColumn ? QVariant(target->visible ? Qt::Checked : Qt::Unchecked)
                                           : QVariant();
        case Qt::TextAlignmentRole:
            return column == NameColumn ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                        : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return asPlainText(toolTip(*target, column));
        case WhyNotHittableRole:
            return m_session.simulation().whyNotHittable(target->id);
        case VisibleRole:
            return target->visible;
        case RawValueRole:
            return column == VerticesColumn
                       ? QVariant(static_cast<qulonglong>(target->deformed.original().vertexCount()))
                   : column == HitsColumn ? QVariant(static_cast<qulonglong>(hitsOn(target->id)))
                                          : QVariant();
        default:
            return {};
    }
}

QVariant SceneModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    const QString titles[ColumnCount] = {QString(), tr("Target"), tr("Vertices"), tr("Hits")};
    const QString explanations[ColumnCount] = {tr("Whether it is drawn and can be hit"),
                                               tr("Name of the target"), tr("Vertices of its mesh"),
                                               tr("Hits on it, disabled ones too")};
    switch (role) {
        case Qt::DisplayRole:
            return titles[section];
        case Qt::ToolTipRole:
            return explanations[section];
        case Qt::TextAlignmentRole:
            return section == NameColumn ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                         : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

/// The first of the rows: a file holds one.
QMimeData* SceneModel::mimeData(const QModelIndexList& indexes) const {
    const TargetId id = indexes.isEmpty() ? TargetId() : targetAt(indexes.front().row());
    const Target* target = m_session.targets().find(id);
    if (target == nullptr || !m_writeTarget) {
        return nullptr;
    }
    QString name = target->name;
    name.replace(u'/', u'_');
    return new DraggedFile(name + QStringLiteral("_deformed.obj"),
                           [write = m_writeTarget, id](const QString& path) { return write(id, path); });
}

Qt::ItemFlags SceneModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
    if (index.column() == NameColumn) {
        flags |= Qt::ItemIsEditable;
    } else if (index.column() == VisibleColumn) {
        flags |= Qt::ItemIsUserCheckable;
    }
    flags.setFlag(Qt::ItemIsDragEnabled, static_cast<bool>(m_writeTarget));
    return index.isValid() ? flags : Qt::NoItemFlags;
}

bool SceneModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const TargetId target = targetAt(index.row());
    if (!target || !index.isValid()) {
        return false;
    }
    if (index.column() == NameColumn && role == Qt::EditRole) {
        return m_session.targets().rename(target, value.toString()).ok();
    }
    if (index.column() == VisibleColumn && role == Qt::CheckStateRole) {
        m_session.targets().setVisible({&target, 1}, value.toInt() == Qt::Checked);
        return true;
    }
    return false;
}

}  // namespace hitscope
