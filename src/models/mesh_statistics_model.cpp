// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/mesh_statistics_model.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>
#include <algorithm>
#include <new>
#include <utility>

#include "models/focus_target.h"
#include "models/quantity_text.h"

namespace hitscope {

namespace {

constexpr qint64 kMeasureInterval = 200;  // milliseconds

/// One a row, in the order of MeshStatisticsModel::Row.
constexpr const char* kRowNames[MeshStatisticsModel::RowCount] = {
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Displacement"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Changed vertices"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Largest (m)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Mean (m)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "RMS (m)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Shape"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Bounding box x (m)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Bounding box y (m)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Bounding box z (m)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Surface area (m²)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Volume (m³)"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Topology"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Vertices"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Edges"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Faces"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Triangles"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Quads"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Larger polygons"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Boundary edges"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Components"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Euler characteristic"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Watertight"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Unused vertices"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Degenerate faces"),
    QT_TRANSLATE_NOOP("hitscope::MeshStatisticsModel", "Non-manifold faces"),
};

/// Until the numbers are there.
QString notKnown() {
    return QStringLiteral("…");
}

}  // namespace

/// What another thread makes; carries its own copy of all it reads.
struct MeshStatisticsModel::Measurement {
    TargetId target;
    std::shared_ptr<const MeshData> mesh;
    std::vector<glm::vec3> positions;  ///< the deformed ones; empty: nothing is deformed
    std::optional<TopologyStatistics> topology;
    std::optional<GeometryStatistics> original;
    std::optional<GeometryStatistics> deformed;

    void make() {
        if (!topology) {
            topology = computeTopology(*mesh);
        }
        if (!original) {
            original = computeGeometry(*mesh, mesh->positions, *topology);
        }
        deformed = positions.empty() ? original : computeGeometry(*mesh, positions, *topology);
    }
};

MeshStatisticsModel::MeshStatisticsModel(const Session& session, std::size_t immediateFaces, QObject* parent)
    : QAbstractTableModel(parent), m_session(session), m_immediateFaces(immediateFaces) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &MeshStatisticsModel::measure);
    connect(&session, &Session::sceneReplaced, this, &MeshStatisticsModel::startOver);
    connect(&session, &Session::targetSelected, this, &MeshStatisticsModel::follow);
    connect(&session, &Session::targetAdded, this, &MeshStatisticsModel::follow);
    connect(&session, &Session::targetRemoved, this, &MeshStatisticsModel::follow);
    connect(&session, &Session::hitsAppended, this, &MeshStatisticsModel::follow);
    connect(&session, &Session::historyReset, this, &MeshStatisticsModel::follow);
    connect(&session, &Session::meshChanged, this, [this](TargetId target) {
        if (target == m_target) {
            schedule();
        }
    });
    follow();
}

void MeshStatisticsModel::startOver() {
    m_target = {};
    follow();
}

void MeshStatisticsModel::follow() {
    const Target* target = focusTarget(m_session);
    const TargetId id = target != nullptr ? target->id : TargetId{};
    if (id == m_target && id) {
        return;
    }
    beginResetModel();
    m_target = id;
    m_values = {};
    endResetModel();
    Q_EMIT shownTargetChanged();
    if (id) {
        schedule();
    }
}

void MeshStatisticsModel::schedule() {
    // Never measured right here: the session reports changed meshes in the middle of drawing a frame.
    if (!m_timer.isActive()) {
        const qint64 since = m_sinceMeasured.isValid() ? m_sinceMeasured.elapsed() : kMeasureInterval;
        m_timer.start(static_cast<int>(std::max<qint64>(0, kMeasureInterval - since)));
    }
}

void MeshStatisticsModel::measure() {
    const Target* target = m_session.target(m_target);
    if (target == nullptr) {
        return;
    }
    m_sinceMeasured.start();
    const DeformedMesh& mesh = target->deformed;
    m_values.displacement = mesh.statistics();
    if (mesh.original().faceCount() > m_immediateFaces) {
        measureElsewhere(*target);
    } else {
        m_values.topology = target->topology();
        m_values.original = target->originalGeometry();
        m_values.deformed = m_values.displacement.changedVertices == 0
                                ? m_values.original
                                : computeGeometry(mesh.original(), mesh.positions(), *m_values.topology);
    }
    announceValues();
}

void MeshStatisticsModel::measureElsewhere(const Target& target) {
    if (m_measuringElsewhere) {
        schedule();
        return;
    }
    Measurement work;
    work.target = target.id;
    work.mesh = target.deformed.sharedOriginal();
    work.topology = m_values.topology;
    work.original = m_values.original;
    if (m_values.displacement.changedVertices > 0) {
        const std::span<const glm::vec3> positions = target.deformed.positions();
        work.positions.assign(positions.begin(), positions.end());
    }
    m_measuringElsewhere = true;
    QThreadPool::globalInstance()->start([self = QPointer(this), work = std::move(work)]() mutable {
        try {
            work.make();
        } catch (const std::bad_alloc&) {
            work.topology.reset();  // the values stay unknown; everything else goes on
        }
        QMetaObject::invokeMethod(QCoreApplication::instance(), [self, done = std::move(work)] {
            if (self) {
                self->take(done);
            }
        });
    });
}

void MeshStatisticsModel::take(const Measurement& measurement) {
    m_measuringElsewhere = false;
    if (measurement.target == m_target && measurement.topology) {
        m_values.topology = measurement.topology;
        m_values.original = measurement.original;
        m_values.deformed = measurement.deformed;
        announceValues();
    }
}

void MeshStatisticsModel::announceValues() {
    Q_EMIT dataChanged(index(0, OriginalColumn), index(RowCount - 1, DeformedColumn));
}

int MeshStatisticsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_target ? 0 : RowCount;
}

int MeshStatisticsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant MeshStatisticsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case PropertyColumn:
            return tr("Property");
        case OriginalColumn:
            return tr("Original");
        case DeformedColumn:
            return tr("Deformed");
        default:
            return {};
    }
}

QVariant MeshStatisticsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const int row = index.row();
    switch (role) {
        case Qt::DisplayRole:
            return cellText(row, index.column());
        case Qt::TextAlignmentRole:
            return index.column() == PropertyColumn ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                                    : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case HeadingRole:
            return row == TopologyHeading || row == ShapeHeading || row == DisplacementHeading;
        case SharedRole:
            return row > TopologyHeading;
        default:
            return {};
    }
}

QString MeshStatisticsModel::cellText(int row, int column) const {
    if (column == PropertyColumn) {
        return tr(kRowNames[row]);
    }
    if (row > TopologyHeading) {
        return column == OriginalColumn ? topologyText(row) : QString();
    }
    if (row > ShapeHeading && row < TopologyHeading) {
        return shapeText(row, column == OriginalColumn ? m_values.original : m_values.deformed);
    }
    if (row > DisplacementHeading && row < ShapeHeading) {
        return column == DeformedColumn ? displacementText(row) : QString();
    }
    return {};
}

QString MeshStatisticsModel::topologyText(int row) const {
    if (!m_values.topology) {
        return notKnown();
    }
    const TopologyStatistics& topology = *m_values.topology;
    switch (row) {
        case VerticesRow:
            return countText(topology.vertices);
        case EdgesRow:
            return countText(topology.edges);
        case FacesRow:
            return countText(topology.faces);
        case TrianglesRow:
            return countText(topology.triangles);
        case QuadsRow:
            return countText(topology.quads);
        case LargerPolygonsRow:
            return countText(topology.largerPolygons);
        case BoundaryEdgesRow:
            return countText(topology.boundaryEdges);
        case ComponentsRow:
            return countText(topology.components);
        case EulerRow:
            return topology.eulerCharacteristic ? QString::number(*topology.eulerCharacteristic)
                                                : tr("not defined");
        case WatertightRow:
            return topology.watertight ? tr("yes") : tr("no");
        case UnreferencedRow:
            return countText(topology.unreferencedVertices);
        case DegenerateRow:
            return countText(topology.degenerateFaces);
        case NonManifoldRow:
            return countText(topology.nonManifoldFaces);
        default:
            return {};
    }
}

QString MeshStatisticsModel::shapeText(int row, const std::optional<GeometryStatistics>& geometry) const {
    if (!geometry) {
        return notKnown();
    }
    const glm::vec3 size = geometry->bounds.size();
    switch (row) {
        case SizeXRow:
            return quantityText(static_cast<double>(size.x));
        case SizeYRow:
            return quantityText(static_cast<double>(size.y));
        case SizeZRow:
            return quantityText(static_cast<double>(size.z));
        case SurfaceAreaRow:
            return quantityText(geometry->surfaceArea);
        case VolumeRow:
            return geometry->volume ? quantityText(*geometry->volume) : tr("not watertight");
        default:
            return {};
    }
}

QString MeshStatisticsModel::displacementText(int row) const {
    const DisplacementStatistics& moved = m_values.displacement;
    switch (row) {
        case ChangedVerticesRow: {
            const Target* target = m_session.target(m_target);
            const std::size_t all = target != nullptr ? target->deformed.original().vertexCount() : 0;
            const double share =
                all == 0 ? 0.0
                         : 100.0 * static_cast<double>(moved.changedVertices) / static_cast<double>(all);
            return tr("%1 (%2 %)").arg(countText(moved.changedVertices), QString::number(share, 'f', 1));
        }
        case LargestDisplacementRow:
            return quantityText(moved.maximum);
        case MeanDisplacementRow:
            return quantityText(moved.mean);
        case RmsDisplacementRow:
            return quantityText(moved.rms);
        default:
            return {};
    }
}

}  // namespace hitscope
