// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/attribution_model.h"

#include <glm/geometric.hpp>
#include <utility>

#include "models/quantity_text.h"
#include "models/vertex_facts.h"

namespace hitscope {

namespace {

constexpr int kSummaryDelay = 120;  // milliseconds: frames until the read-back has followed

QVariant listOf(const glm::vec3& vector) {
    return QVariantList{static_cast<double>(vector.x), static_cast<double>(vector.y),
                        static_cast<double>(vector.z)};
}

}  // namespace

AttributionModel::AttributionModel(Session& session, QObject* parent)
    : QAbstractTableModel(parent), m_session(session) {
    m_summaryTimer.setSingleShot(true);
    m_summaryTimer.setInterval(kSummaryDelay);
    m_restartTimer.setSingleShot(true);
    m_restartTimer.setInterval(0);
    connect(&m_summaryTimer, &QTimer::timeout, this, &AttributionModel::summaryChanged);
    connect(&m_restartTimer, &QTimer::timeout, this, &AttributionModel::startOver);
    connect(&session.selection(), &VertexSelection::pickedChanged, this, &AttributionModel::startOver);
    connect(&session.hits(), &SessionHits::appended, this, &AttributionModel::followHits);
    const auto restart = [this] {
        if (m_vertex) {
            m_restartTimer.start();
        }
    };
    connect(&session.hits(), &SessionHits::changed, this, restart);
    connect(&session.hits(), &SessionHits::rearranged, this, restart);
    connect(&session.hits(), &SessionHits::reset, this, restart);
    connect(&session.hits(), &SessionHits::shownChanged, this, restart);
    connect(&session.readBack(), &ReadBack::capacityChanged, this, [this, restart] {
        if (m_session.readBack().capacity().dropped != m_dropped) {
            m_dropped = m_session.readBack().capacity().dropped;
            restart();
        }
    });
    connect(&session.readBack(), &ReadBack::meshChanged, this, [this](TargetId target) {
        if (m_vertex && m_vertex->target == target) {
            m_summaryTimer.start();
        }
    });
}

void AttributionModel::startOver() {
    beginResetModel();
    m_vertex = m_session.selection().picked();
    m_taken = 0;
    m_attribution = {};
    if (m_vertex) {
        const DeformedMesh& mesh = m_session.targets().find(m_vertex->target)->deformed;
        const std::uint32_t drawn = mesh.render().renderVerticesOf(m_vertex->vertex).front();
        m_attribution = Attribution(mesh.render().vertices[drawn]);
        takeHits(m_attribution);
    }
    endResetModel();
    Q_EMIT summaryChanged();
    m_summaryTimer.start();
}

/// Those of the history that it has not gone through.
void AttributionModel::takeHits(Attribution& attribution) {
    const std::span<const Hit> hits = m_session.hits().shown();
    for (; m_taken < hits.size(); ++m_taken) {
        const Hit& hit = hits[m_taken];
        if (hit.target == m_vertex->target && m_session.hits().isApplied(m_taken)) {
            attribution.add(m_taken, hit);
        }
    }
}

void AttributionModel::followHits() {
    if (!m_vertex || m_restartTimer.isActive()) {
        return;
    }
    Attribution further(m_attribution.vertex());
    takeHits(further);
    if (!further.contributions().empty()) {
        const int before = rowCount();
        beginInsertRows({}, before, before + static_cast<int>(further.contributions().size()) - 1);
        m_attribution.append(further);
        endInsertRows();
    }
    m_summaryTimer.start();
}

bool AttributionModel::isBuffers() const {
    const Target* target = m_vertex ? m_session.targets().find(m_vertex->target) : nullptr;
    return target != nullptr && target->deformed.positions()[m_vertex->vertex] == position();
}

QString AttributionModel::summary() const {
    const Target* target = m_vertex ? m_session.targets().find(m_vertex->target) : nullptr;
    if (target == nullptr) {
        return {};
    }
    if (contributions().empty() && isBuffers()) {
        return tr("No hit has moved this vertex.");
    }
    const glm::vec3 sum = position() - target->deformed.original().positions[m_vertex->vertex];
    const QString moved =
        tr("Sum: %1 m (%2).").arg(quantityText(static_cast<double>(glm::length(sum))), vectorText(sum));
    if (isBuffers()) {
        return moved + u' ' + tr("The buffer holds the same: bit-exact.");
    }
    if (!m_session.readBack().isUpToDate()) {
        return moved + u' ' + tr("The buffer has not been read back yet.");
    }
    const glm::vec3 off = target->deformed.positions()[m_vertex->vertex] - position();
    return moved + u' ' +
           tr("The buffer is %1 m off it.").arg(quantityText(static_cast<double>(glm::length(off))));
}

int AttributionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(contributions().size());
}

int AttributionModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString AttributionModel::text(const VertexContribution& row, int column) const {
    switch (column) {
        case HitColumn:
            return countText(row.hit + 1);
        case DistanceColumn:
            return quantityText(static_cast<double>(row.contribution.distance));
        case MagnitudeColumn:
            return quantityText(static_cast<double>(row.contribution.magnitude));
        case CapColumn:
            return row.contribution.isCapped ? tr("capped") : QString();
        case DisplacementColumn:
            return vectorText(row.contribution.displacement);
        case PositionColumn:
            return vectorText(row.position);
        default:
            return {};
    }
}

QVariant AttributionModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const VertexContribution& row = contributions()[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return text(row, index.column());
        case Qt::TextAlignmentRole:
            return QVariant((index.column() == CapColumn ? Qt::AlignHCenter : Qt::AlignRight) |
                            Qt::AlignVCenter);
        case HitRole:
            return static_cast<qulonglong>(row.hit);
        case RawValueRole:
            switch (index.column()) {
                case DistanceColumn:
                    return static_cast<double>(row.contribution.distance);
                case MagnitudeColumn:
                    return static_cast<double>(row.contribution.magnitude);
                case CapColumn:
                    return row.contribution.isCapped;
                case DisplacementColumn:
                    return listOf(row.contribution.displacement);
                case PositionColumn:
                    return listOf(row.position);
                default:
                    return static_cast<qulonglong>(row.hit + 1);
            }
        default:
            return {};
    }
}

QVariant AttributionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    const QString titles[ColumnCount] = {tr("Hit"), tr("Distance (m)"),     tr("Magnitude (m)"),
                                         tr("Cap"), tr("Displacement (m)"), tr("Position after (m)")};
    const QString explanations[ColumnCount] = {
        tr("The hit's number in the hit history"),
        tr("r: from the hit's point to where the vertex was just before"),
        tr("m: how far the hit moved it. In the paper's form, power / r, at most max magnitude (equation 4)"),
        tr("Whether max magnitude applied"),
        tr("This hit's own part: direction times magnitude"),
        tr("Where the vertex was after this hit")};
    switch (role) {
        case Qt::DisplayRole:
            return titles[section];
        case Qt::ToolTipRole:
            return explanations[section];
        case Qt::TextAlignmentRole:
            return QVariant((section == CapColumn ? Qt::AlignHCenter : Qt::AlignRight) | Qt::AlignVCenter);
        default:
            return {};
    }
}

}  // namespace hitscope
