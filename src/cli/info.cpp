// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTextStream>
#include <memory>
#include <utility>

#include "analysis/measured_target.h"
#include "cli/commands.h"
#include "gl/context.h"
#include "io/import.h"
#include "pipeline/graphics_report.h"
#include "pipeline/measure_exactness.h"
#include "pipeline/pipeline_trial.h"
#include "render/picking_trial.h"

namespace hitscope::cli {

namespace {

class Table {
public:
    explicit Table(QTextStream& out) : m_out(out) {}
    void row(const QString& name, const QString& value) {
        m_out << "  " << name.leftJustified(kNameWidth) << value << "\n";
    }
    void row(const QString& name, std::size_t count) { row(name, QString::number(count)); }
    void rowUnlessZero(const QString& name, std::size_t count) {
        if (count != 0) {
            row(name, count);
        }
    }

private:
    static constexpr int kNameWidth = 24;
    QTextStream& m_out;
};

QString vectorText(const glm::dvec3& v) {
    return QStringLiteral("%1  %2  %3").arg(v.x, 0, 'g', 6).arg(v.y, 0, 'g', 6).arg(v.z, 0, 'g', 6);
}

void printTopology(Table& table, const MeshMeasurement& measurement) {
    const SurfaceStatistics& surface = measurement.topology;
    table.row(QStringLiteral("vertices"), surface.vertices);
    table.rowUnlessZero(QStringLiteral("  used by no face"), surface.unreferencedVertices);
    table.rowUnlessZero(QStringLiteral("  at another's place"),
                        surface.vertices - surface.unreferencedVertices - surface.places);
    table.row(QStringLiteral("edges"), surface.edges);
    table.rowUnlessZero(QStringLiteral("  on a boundary"), surface.boundaryEdges);
    table.rowUnlessZero(QStringLiteral("  non-manifold"), surface.nonManifoldEdges);
    table.rowUnlessZero(QStringLiteral("  of opposite faces"), surface.opposedEdges);
    table.row(QStringLiteral("faces"), surface.faces);
    table.rowUnlessZero(QStringLiteral("  triangles"), surface.triangles);
    table.rowUnlessZero(QStringLiteral("  quads"), surface.quads);
    table.rowUnlessZero(QStringLiteral("  larger polygons"), surface.largerPolygons);
    table.rowUnlessZero(QStringLiteral("  degenerate"), measurement.original.degenerateFaces);
    table.rowUnlessZero(QStringLiteral("  collapsed"), surface.collapsedFaces);
    table.rowUnlessZero(QStringLiteral("  not half-edge"), measurement.refusedFaces);
    table.rowUnlessZero(QStringLiteral("non-manifold vertices"), surface.nonManifoldVertices);
    table.row(QStringLiteral("connected components"), surface.components);
    table.rowUnlessZero(QStringLiteral("holes"), surface.holes);
    table.row(QStringLiteral("Euler characteristic"), QString::number(surface.eulerCharacteristic));
    if (surface.genus) {
        table.row(QStringLiteral("genus"), QString::number(*surface.genus));
    }
    table.row(QStringLiteral("watertight"),
              surface.watertight ? QStringLiteral("yes") : QStringLiteral("no"));
}

void printGeometry(Table& table, const MeshMeasurement& measurement) {
    const SurfaceMeasures& measures = measurement.original;
    if (!measures.box.empty()) {
        table.row(QStringLiteral("smallest coordinates"), vectorText(measures.box.min));
        table.row(QStringLiteral("largest coordinates"), vectorText(measures.box.max));
    }
    table.row(QStringLiteral("size"), vectorText(measures.box.size()));
    table.row(QStringLiteral("surface area"), QString::number(measures.faceArea.sum, 'g', 6));
    if (measurement.topology.isSolid()) {
        table.row(QStringLiteral("volume"), QString::number(measures.volume(), 'g', 6));
    }
}

}  // namespace

Status runInfo(const QString& meshPath) {
    Result<ImportedMesh> imported = importMesh(meshPath);
    if (!imported) {
        return imported.error();
    }
    const auto shared = std::make_shared<const MeshData>(std::move(imported.value().mesh));
    const MeshData& mesh = *shared;
    QTextStream out(stdout);
    out << meshPath << "\n";
    Table table(out);
    const MeshMeasurement measurement = measure(shared);
    printTopology(table, measurement);
    printGeometry(table, measurement);
    table.row(QStringLiteral("texture coordinates"), mesh.texcoords.size());
    table.row(QStringLiteral("normals"), mesh.normals.size());
    table.rowUnlessZero(QStringLiteral("groups"), mesh.groups.size());
    table.rowUnlessZero(QStringLiteral("materials"), mesh.materials.size());
    table.rowUnlessZero(QStringLiteral("textures"), mesh.images.size());
    for (const QString& note : imported.value().notes) {
        out << "  note: " << note << "\n";
    }
    return Done{};
}

Status runRendererInfo() {
    const Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    const Result<Exactness> exactness = measureExactness();
    if (!exactness) {
        return exactness.error();
    }
    RendererVerdict verdict;
    PipelineOptions options;
    options.deformDefines = definesOf(exactness.value());
    for (const PipelineTraits& traits : allPipelines()) {
        verdict.pipelines[traits.kind] = tryPipeline(traits.kind, options);
    }
    verdict.picking = tryPicking();
    QTextStream(stdout) << QString::fromStdString(toText(graphicsReport(exactness.value(), verdict)));
    return Done{};
}

}  // namespace hitscope::cli
