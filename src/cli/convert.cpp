// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a mesh in any format that the window writes.
#include "cli/common_options.h"
#include "cli/mesh_step_options.h"
#include "cli/mesh_writing.h"
#include "cli/opened_scene.h"
#include "cli/verbs.h"

namespace hitscope::cli {

namespace {

constexpr double kLeastScale = 1.0e-30;  // what is smaller may be read no more
constexpr double kMostScale = 1.0e9;

/// By UpAxis.
QStringList axisWords() {
    return {QStringLiteral("y"), QStringLiteral("z")};
}

QList<UsageOption> coordinateOptions() {
    return {valueOption("scale", "FACTOR",
                        QStringLiteral("Multiply all lengths by this first: 0.001 makes metres of "
                                       "millimetres.")),
            wordOption("up", "AXIS", axisWords(), QStringLiteral("Axis that points up in MESH."),
                       QStringLiteral("y")),
            wordOption("write-up", "AXIS", axisWords(),
                       QStringLiteral("Axis that points up in FILE. Where it is another one than that of "
                                      "--up, the mesh is turned about the x axis."),
                       QStringLiteral("y"))};
}

CoordinateChange givenCoordinates(Invocation& given) {
    CoordinateChange change;
    change.scale = given.numberIfSet("scale", kLeastScale, kMostScale).value_or(1.0);
    change.from = static_cast<UpAxis>(given.word("up"));
    change.to = static_cast<UpAxis>(given.word("write-up"));
    return change;
}

Outcome convert(Invocation& given, const CoordinateChange& coordinates, const std::vector<MeshStep>& steps,
                const ExportOptions& options) {
    OpenedScene scene;
    if (Outcome opened = scene.open({.path = given.file(0), .isMeshAlone = true, .coordinates = coordinates});
        !opened) {
        return opened;
    }
    if (Status changed = changeAll(scene.session(), steps); !changed) {
        return changed;
    }
    return writeTargets(given, scene.session(), {scene.session().targets().front().get()}, options,
                        given.file(1));
}

int runConvert(Invocation& given) {
    if (namesSession(given.file(0))) {
        given.complain(QStringLiteral("convert takes a mesh; export writes what is in a session."));
    }
    const CoordinateChange coordinates = givenCoordinates(given);
    const std::vector<MeshStep> steps = givenMeshSteps(given);
    const ExportOptions options = givenWriting(given, given.file(1));
    return given.error().isEmpty() ? finish(convert(given, coordinates, steps, options)) : kWrongUsage;
}

}  // namespace

Verb convertVerb() {
    return {
        {.name = QStringLiteral("convert"),
         .files = QStringLiteral("MESH FILE"),
         .about = QStringLiteral("write a mesh in another format"),
         .description = QStringLiteral("Reads a mesh and writes it in another format. FILE may be - for the "
                                       "standard output. Keeps the order of vertices if the format has one. "
                                       "Can change the unit and the axis that points up, and simplify, "
                                       "refine and smooth the mesh, as the Mesh menu does."),
         .options = coordinateOptions() + meshStepOptions() + writingOptions() + reportOptions(),
         .examples = {{QStringLiteral("Convert OBJ to GLB."),
                       QStringLiteral("hitscope-cli convert bunny.obj bunny.glb")},
                      {QStringLiteral("Convert a part in millimetres whose z axis points up to the metres "
                                      "and the y axis of glTF."),
                       QStringLiteral("hitscope-cli convert --scale 0.001 --up z part.stl part.glb")},
                      {QStringLiteral("Write a mesh with a tenth of the triangles."),
                       QStringLiteral("hitscope-cli convert --simplify 10 bunny.obj light.ply")}},
         .leastFiles = 2,
         .mostFiles = 2,
         .outputFile = 1},
        runConvert};
}

}  // namespace hitscope::cli
