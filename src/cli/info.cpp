// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTextStream>

#include "cli/commands.h"
#include "gl/context.h"
#include "io/import.h"
#include "mesh/topology.h"
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

QString vectorText(const glm::vec3& v) {
    return QStringLiteral("%1  %2  %3")
        .arg(static_cast<double>(v.x), 0, 'g', 6)
        .arg(static_cast<double>(v.y), 0, 'g', 6)
        .arg(static_cast<double>(v.z), 0, 'g', 6);
}

void printTopology(Table& table, const TopologyStatistics& topology) {
    table.row(QStringLiteral("vertices"), topology.vertices);
    table.rowUnlessZero(QStringLiteral("  used by no face"), topology.unreferencedVertices);
    table.row(QStringLiteral("edges"), topology.edges);
    table.rowUnlessZero(QStringLiteral("  on a boundary"), topology.boundaryEdges);
    table.row(QStringLiteral("faces"), topology.faces);
    table.rowUnlessZero(QStringLiteral("  triangles"), topology.triangles);
    table.rowUnlessZero(QStringLiteral("  quads"), topology.quads);
    table.rowUnlessZero(QStringLiteral("  larger polygons"), topology.largerPolygons);
    table.rowUnlessZero(QStringLiteral("  degenerate"), topology.degenerateFaces);
    table.rowUnlessZero(QStringLiteral("  non-manifold"), topology.nonManifoldFaces);
    table.row(QStringLiteral("connected components"), topology.components);
    table.row(QStringLiteral("Euler characteristic"),
              topology.eulerCharacteristic ? QString::number(*topology.eulerCharacteristic)
                                           : QStringLiteral("undefined: some faces cannot be connected"));
    table.row(QStringLiteral("watertight"),
              topology.watertight ? QStringLiteral("yes") : QStringLiteral("no"));
}

void printGeometry(Table& table, const GeometryStatistics& geometry) {
    table.row(QStringLiteral("smallest coordinates"), vectorText(geometry.bounds.min));
    table.row(QStringLiteral("largest coordinates"), vectorText(geometry.bounds.max));
    table.row(QStringLiteral("size"), vectorText(geometry.bounds.size()));
    table.row(QStringLiteral("surface area"), QString::number(geometry.surfaceArea, 'g', 6));
    if (geometry.volume) {
        table.row(QStringLiteral("volume"), QString::number(*geometry.volume, 'g', 6));
    }
}

}  // namespace

Status runInfo(const QString& meshPath) {
    Result<ImportedMesh> imported = importMesh(meshPath);
    if (!imported) {
        return imported.error();
    }
    const MeshData& mesh = imported.value().mesh;
    QTextStream out(stdout);
    out << meshPath << "\n";
    Table table(out);
    const TopologyStatistics topology = computeTopology(mesh);
    printTopology(table, topology);
    printGeometry(table, computeGeometry(mesh, mesh.positions, topology));
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
