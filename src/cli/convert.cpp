// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a mesh in any format that the window writes.
#include "cli/common_options.h"
#include "cli/mesh_step_options.h"
#include "cli/mesh_writing.h"
#include "cli/opened_scene.h"
#include "cli/verbs.h"

namespace hitscope::cli {

namespace {

Outcome convert(Invocation& given, const std::vector<MeshStep>& steps, const ExportOptions& options) {
    OpenedScene scene;
    if (Outcome opened = scene.open({.path = given.file(0), .isMeshAlone = true}); !opened) {
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
    const std::vector<MeshStep> steps = givenMeshSteps(given);
    const ExportOptions options = givenWriting(given, given.file(1));
    return given.error().isEmpty() ? finish(convert(given, steps, options)) : kWrongUsage;
}

}  // namespace

Verb convertVerb() {
    return {
        {.name = QStringLiteral("convert"),
         .files = QStringLiteral("MESH FILE"),
         .about = QStringLiteral("write a mesh in another format"),
         .description = QStringLiteral("Reads a mesh and writes it in another format. FILE may be - for the "
                                       "standard output. Keeps the order of vertices if the format has one. "
                                       "Can simplify, refine and smooth the mesh, as the Mesh menu does."),
         .options = meshStepOptions() + writingOptions() + reportOptions(),
         .examples = {{QStringLiteral("Convert OBJ to GLB."),
                       QStringLiteral("hitscope-cli convert bunny.obj bunny.glb")},
                      {QStringLiteral("Write a mesh with a tenth of the triangles."),
                       QStringLiteral("hitscope-cli convert --simplify 10 bunny.obj light.ply")}},
         .leastFiles = 2,
         .mostFiles = 2,
         .outputFile = 1},
        runConvert};
}

}  // namespace hitscope::cli
