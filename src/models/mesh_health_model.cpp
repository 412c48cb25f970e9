// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/mesh_health_model.h"

#include <algorithm>
#include <cmath>

#include "models/plain_text.h"
#include "models/quantity_text.h"
#include "session/shown_number.h"

namespace hitscope {

MeshHealthModel::MeshHealthModel(const Session& session, const MeshMeasuring& measuring, QObject* parent)
    : QAbstractTableModel(parent), m_session(session), m_measuring(measuring) {
    connect(&measuring, &MeshMeasuring::measured, this, &MeshHealthModel::follow);
    connect(&session, &Session::sceneReplaced, this, &MeshHealthModel::follow);
    connect(&session.targets(), &SessionTargets::removed, this, &MeshHealthModel::follow);
    follow();
}

void MeshHealthModel::follow() {
    const std::shared_ptr<const MeshMeasurement>& measurement = m_measuring.measurement();
    std::vector<HarmRow> rows = measurement ? measurement->harms : std::vector<HarmRow>{};
    m_found = measurement ? measurement->harmsFound : 0;
    const auto old = static_cast<std::ptrdiff_t>(m_rows.size());
    if (rows != m_rows && rows.size() > m_rows.size() &&
        std::equal(m_rows.begin(), m_rows.end(), rows.begin(), rows.begin() + old)) {
        beginInsertRows({}, static_cast<int>(m_rows.size()), static_cast<int>(rows.size()) - 1);
        m_rows = std::move(rows);
        endInsertRows();
    } else if (rows != m_rows) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }
    Q_EMIT foundChanged();
}

int MeshHealthModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int MeshHealthModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant MeshHealthModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case FaceColumn:
            return tr("Face");
        case HarmColumn:
            return tr("What happened");
        case StretchColumn:
            return tr("Stretch");
        case HitColumn:
            return tr("By hit");
        default:
            return {};
    }
}

QVariant MeshHealthModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const HarmRow& row = harmAt(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return text(row, index.column());
        case Qt::ToolTipRole:
            return asPlainText(toolTip(row));
        case Qt::TextAlignmentRole:
            return index.column() == HarmColumn ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                                : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

QString MeshHealthModel::text(const HarmRow& row, int column) const {
    switch (column) {
        case FaceColumn:
            return countText(std::size_t{row.harm.face} + 1);
        case HarmColumn:
            return row.harm.kind == FaceHarm::Kind::Flipped       ? tr("flipped")
                   : row.harm.kind == FaceHarm::Kind::Degenerated ? tr("degenerated")
                                                                  : tr("stretched");
        case StretchColumn:
            return std::isfinite(row.harm.stretch) ? QStringLiteral("%1 ×").arg(shownNumber(
                                                         static_cast<double>(row.harm.stretch), 'f', 2))
                                                   : QStringLiteral("∞");
        case HitColumn:
            return row.hit ? countText(*row.hit + 1) : QStringLiteral("–");
        default:
            return {};
    }
}

QString MeshHealthModel::toolTip(const HarmRow& row) const {
    const Target* target = m_session.targets().find(row.target);
    const QString face =
        tr("Face %1 of %2, counted from 1 as in the file")
            .arg(countText(std::size_t{row.harm.face} + 1), target != nullptr ? target->name : QString());
    switch (row.harm.kind) {
        case FaceHarm::Kind::Flipped:
            return tr("%1: its orientation is reversed.").arg(face);
        case FaceHarm::Kind::Degenerated:
            return tr("%1: it has no area, or next to none for its length.").arg(face);
        case FaceHarm::Kind::Stretched:
            return tr("%1: one of its edges is %2 times as long as in the original.")
                .arg(face, shownNumber(static_cast<double>(row.harm.stretch), 'f', 2));
    }
    return face;
}

}  // namespace hitscope
