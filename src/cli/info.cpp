// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFileInfo>
#include <QTextStream>
#include <memory>
#include <utility>

#include "analysis/measured_target.h"
#include "cli/common_options.h"
#include "cli/opened_scene.h"
#include "cli/outputs.h"
#include "cli/progress_line.h"
#include "cli/verbs.h"
#include "gl/context.h"
#include "io/import.h"
#include "models/statistics_report.h"
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
    table.row(QStringLiteral("volume"),
              measurement.topology.isSolid()
                  ? QString::number(measures.volume(), 'g', 6)
                  : statisticsText(statisticsRow("volume"), measurement, StatisticsSide::Original));
}

/// The rest of what the mesh statistics show.
void printShape(Table& table, const MeshMeasurement& measurement) {
    for (const char* const key : {"edge_length_mean", "edge_length_min", "edge_length_max", "face_area_min",
                                  "face_area_max", "aspect_min", "aspect_max"}) {
        const StatisticsRow& row = statisticsRow(key);
        const bool isEdge = row.section == StatisticsRow::Section::Edges;
        const QString name = isEdge                             ? QStringLiteral("edge length, %1")
                             : std::string_view(row.unit) == "" ? QStringLiteral("face, %1")
                                                                : QStringLiteral("face area, %1");
        table.row(name.arg(QString::fromLatin1(row.name).toLower()),
                  statisticsText(row, measurement, StatisticsSide::Original));
    }
}

/// All rows by their keys; of an undented mesh the original alone.
void addStatistics(JsonReport& report, const MeshMeasurement& measurement, bool isDented) {
    for (const StatisticsSide side : {StatisticsSide::Original, StatisticsSide::Deformed}) {
        if (side == StatisticsSide::Deformed && !isDented) {
            continue;
        }
        report.beginObject(side == StatisticsSide::Original ? "original" : "deformed");
        for (const StatisticsRow& row : statisticsRows()) {
            const bool isSaid =
                row.sides == StatisticsRow::Sides::Both ||
                (row.sides == StatisticsRow::Sides::Deformed) == (side == StatisticsSide::Deformed);
            if (!isSaid) {
                continue;
            }
            const std::optional<double> value = statisticsValue(row, measurement, side);
            if (row.kind == StatisticsRow::Kind::YesNo && value) {
                report.truth(row.key, *value != 0.0);
            } else {
                report.number(row.key, value);
            }
        }
        report.endObject();
    }
}

Outcome describeMesh(const QString& path, JsonReport& report, QTextStream& out) {
    Result<ImportedMesh> imported = importMesh(path);
    if (!imported) {
        return imported.error();
    }
    const auto shared = std::make_shared<const MeshData>(std::move(imported.value().mesh));
    const MeshData& mesh = *shared;
    if (Status free = checkReferences(QFileInfo(path).completeBaseName(), path, mesh); !free) {
        return free;
    }
    out << path << "\n";
    Table table(out);
    MeshMeasurement measurement = measure(shared);
    measurement.original = measurement.original.inFile(mesh.placement);
    printTopology(table, measurement);
    printGeometry(table, measurement);
    printShape(table, measurement);
    table.row(QStringLiteral("texture coordinates"), mesh.texcoords.size());
    table.row(QStringLiteral("normals"), mesh.normals.size());
    table.rowUnlessZero(QStringLiteral("groups"), mesh.groups.size());
    table.rowUnlessZero(QStringLiteral("materials"), mesh.materials.size());
    table.rowUnlessZero(QStringLiteral("textures"), mesh.images.size());
    report.beginObject().text("file", path).beginArray("targets").beginObject();
    report.text("name", QFileInfo(path).completeBaseName());
    report.count("texture_coordinates", mesh.texcoords.size()).count("normals", mesh.normals.size());
    report.count("groups", mesh.groups.size()).count("materials", mesh.materials.size());
    report.count("textures", mesh.images.size());
    addStatistics(report, measurement, false);
    report.endObject().endArray().beginArray("notes");
    for (const QString& said : imported.value().notes) {
        out << "  note: " << said << "\n";
        report.text({}, said);
    }
    report.endArray().endObject();
    return Done{};
}

/// The file's vertices that hits moved, where they are.
std::vector<MovedVertex> movedOf(const Target& target) {
    std::vector<MovedVertex> moved;
    for (const std::uint32_t vertex : target.deformed.onceChanged()) {
        moved.push_back({vertex, target.deformed.positions()[vertex]});
    }
    return moved;
}

Outcome describeSession(const QString& path, JsonReport& report, QTextStream& out) {
    OpenedScene scene;
    if (Outcome opened = scene.open({.path = path, .hasPipelineOption = false}); !opened) {
        return opened;
    }
    const Session& session = scene.session();
    out << path << ": " << counted(session.hits().history().size(), "hit", "hits") << "\n";
    report.beginObject().text("file", path).count("hits", session.hits().history().size());
    report.beginArray("targets");
    for (const std::unique_ptr<Target>& target : session.targets()) {
        MeasuredTarget measured(target->id, target->deformed.sharedOriginal());
        measured.follow(movedOf(*target), {});
        MeshMeasurement measurement;
        measured.addTo(measurement, target->transform, true);
        conclude(measurement);
        out << "\n" << statisticsAsText(target->name, measurement);
        report.beginObject().text("name", target->name);
        report.count("hits", session.hits().history().hitsOn(target->id).size());
        addStatistics(report, measurement, true);
        report.endObject();
    }
    report.endArray().endObject();
    return Done{};
}

Outcome describeFile(const QString& path, JsonReport& report, QTextStream& out) {
    const WaitingLine waiting(QStringLiteral("Measuring"));
    return namesSession(path) ? describeSession(path, report, out) : describeMesh(path, report, out);
}

Outcome describeFiles(Invocation& given) {
    JsonReport report("info");
    QString text;
    report.beginArray("files");
    Outcome first = Done{};  // of the files that cannot be read, which keep nobody from the others
    std::vector<std::pair<QString, QString>> failed;  // those files, and why
    for (const QString& path : given.files()) {
        QString described;
        QTextStream out(&described);
        const Outcome outcome = describeFile(path, report, out);
        out.flush();
        if (areOutputsRefused()) {
            return outcome;
        }
        if (outcome) {
            text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + described;
            continue;
        }
        failed.emplace_back(path, QString::fromStdString(outcome.error().message()));
        if (first) {
            first = outcome;
        } else {
            finish(outcome);
        }
    }
    report.endArray().beginArray("failed");
    for (const auto& [path, why] : failed) {
        report.beginObject().text("file", path).text("error", why).endObject();
    }
    report.endArray();
    if (first || given.files().size() > 1) {
        if (Status said = giveReport(given, report, text); !said) {
            return said;
        }
    }
    return first;
}

Outcome describeRenderer(Invocation& given) {
    const Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return cannotDraw(context.error());
    }
    const Result<Exactness> exactness = measureExactness();
    if (!exactness) {
        return cannotDraw(exactness.error());
    }
    RendererVerdict verdict;
    PipelineOptions options;
    options.deformDefines = definesOf(exactness.value());
    for (const PipelineTraits& traits : allPipelines()) {
        verdict.pipelines[traits.kind] = tryPipeline(traits.kind, options);
    }
    verdict.picking = tryPicking();
    JsonReport report("info");
    report.beginObject("renderer").text("name", QString::fromStdString(gl::rendererInfo().renderer));
    report.text("opengl",
                QStringLiteral("%1.%2").arg(gl::rendererInfo().major).arg(gl::rendererInfo().minor));
    report.beginArray("pipelines");
    for (const PipelineTraits& traits : allPipelines()) {
        report.beginObject().text("pipeline", QString::fromUtf8(traits.key));
        report.truth("exact", verdict.pipelines[traits.kind].isExact());
        report.text("verdict", QString::fromStdString(describe(verdict, traits.kind))).endObject();
    }
    report.endArray().endObject();
    return giveReport(given, report,
                      QString::fromStdString(toText(graphicsReport(exactness.value(), verdict))));
}

int runInfo(Invocation& given) {
    if (given.isSet("renderer") != given.files().isEmpty()) {
        given.complain(QStringLiteral("info takes mesh files or sessions, or --renderer alone."));
        return kWrongUsage;
    }
    return finish(given.isSet("renderer") ? describeRenderer(given) : describeFiles(given));
}

}  // namespace

Verb infoVerb() {
    return {{.name = QStringLiteral("info"),
             .files = QStringLiteral("[MESH|SESSION...]"),
             .about = QStringLiteral("measure meshes and sessions, or describe the graphics driver"),
             .description = QStringLiteral(
                 "Prints the mesh statistics that the window shows: for a mesh file as it is; for each "
                 "target of a session the original, the deformed mesh and the change. With --renderer, "
                 "prints the graphics driver, the number of hits that its uniform arrays hold, and whether "
                 "each pipeline is bit-exact on it."),
             .options =
                 QList<UsageOption>{flagOption(
                     "renderer",
                     QStringLiteral(
                         "Describe the graphics driver and test whether pipelines are bit-exact on it."))} +
                 reportOptions(),
             .examples = {{QStringLiteral("Measure two mesh files."),
                           QStringLiteral("hitscope-cli info bunny.obj part.ply")},
                          {QStringLiteral("Print the changes that the hits made, as JSON."),
                           QStringLiteral("hitscope-cli info --json dents.hitscope")},
                          {QStringLiteral("Describe the graphics driver."),
                           QStringLiteral("hitscope-cli info --renderer")}},
             .mostFiles = -1},
            runInfo};
}

}  // namespace hitscope::cli
