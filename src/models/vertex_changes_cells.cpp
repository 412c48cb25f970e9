// SPDX-License-Identifier: GPL-3.0-or-later
// What a view sees of the rows.
#include <glm/trigonometric.hpp>

#include "models/quantity_text.h"
#include "models/vertex_changes_model.h"
#include "session/shown_number.h"
#include "session/vertex_selection.h"

namespace hitscope {

namespace {

QVariant listOf(const glm::vec3& vector) {
    return QVariantList{static_cast<double>(vector.x), static_cast<double>(vector.y),
                        static_cast<double>(vector.z)};
}

}  // namespace

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
