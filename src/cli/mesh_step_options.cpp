// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_step_options.h"

#include <optional>
#include <string_view>
#include <utility>

#include "cli/command_line.h"
#include "cli/progress_line.h"
#include "document/mesh_step_fields.h"
#include "mesh/mesh_objects.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/mesh_steps/separate_objects.h"
#include "session/stand_targets.h"

namespace hitscope::cli {

namespace {

constexpr double kMostLength = 1.0e9;    // metres
constexpr double kMostPercent = 99.999;  // of what a mesh is simplified to

std::vector<TargetId> idsOf(const Session& session) {
    std::vector<TargetId> ids;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        ids.push_back(target->id);
    }
    return ids;
}

/// By RefineMethod.
QStringList refineWords() {
    QStringList words;
    for (const std::string_view word : document_words::kRefineMethods) {
        words += QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
    }
    return words;
}

}  // namespace

UsageOption upOption() {
    return wordOption("up", "AXIS", {QStringLiteral("y"), QStringLiteral("z")},
                      QStringLiteral("Axis that points up in the file. z turns the targets upright first, "
                                     "as Mesh > Turn Upright does; meshes are still written in the "
                                     "coordinates of their files."),
                      QStringLiteral("y"));
}

bool givenZUp(Invocation& given) {
    return given.word("up") == 1;
}

UsageOption separateOption() {
    return flagOption("separate",
                      QStringLiteral("Before shooting, split each mesh into one target for each object."));
}

QList<UsageOption> meshStepOptions() {
    return {
        valueOption("simplify", "PERCENT",
                    QStringLiteral("Simplify the mesh first, to about this percentage of its triangles.")),
        valueOption("refine", "METRES",
                    QStringLiteral("Refine the mesh first, until no edge is longer; after --simplify.")),
        wordOption("refine-by", "METHOD", refineWords(),
                   QStringLiteral("How --refine adds vertices: midpoint and longest-edge keep the shape, "
                                  "butterfly rounds it."),
                   refineWords().front()),
        valueOption("smooth", "PASSES",
                    QStringLiteral("Smooth the mesh first, 1 to %1 passes; after --simplify and --refine.")
                        .arg(SmoothOptions::kMostPasses))};
}

namespace {

std::optional<RefineOptions> givenRefinement(Invocation& given) {
    const std::optional<double> length =
        given.positiveIfSet("refine", kMostLength, QStringLiteral("a length in metres"));
    if (!length) {
        if (given.isSet("refine-by")) {
            given.complain(QStringLiteral("--refine-by needs --refine."));
        }
        return std::nullopt;
    }
    const auto method = static_cast<RefineMethod>(given.word("refine-by"));
    return RefineOptions{.method = method,
                         .edgeLength = static_cast<float>(*length),
                         .keepQuads = method == RefineMethod::Midpoint,
                         .region = {}};
}

std::optional<SimplifyOptions> givenSimplifying(Invocation& given) {
    const std::optional<double> percent =
        given.positiveIfSet("simplify", kMostPercent, QStringLiteral("a percentage"));
    if (!percent) {
        return std::nullopt;
    }
    return SimplifyOptions{.share = static_cast<float>(*percent / 100.0), .region = {}};
}

/// "Simplifying"
QString doing(const MeshStep& step) {
    return std::holds_alternative<SimplifyOptions>(step) ? QStringLiteral("Simplifying")
           : std::holds_alternative<RefineOptions>(step) ? QStringLiteral("Refining")
                                                         : QStringLiteral("Smoothing");
}

Status change(Session& session, TargetId id, const MeshStep& step) {
    const Target& target = *session.targets().find(id);
    const MeshEdit edit = meshEdit(session, id, step);
    ProgressLine progress(doing(step));
    Result<EditedMesh> made = edited(*target.shape.mesh, edit, [&progress](double share) {
        progress.show(static_cast<int>(100.0 * share));
        return true;
    });
    progress.hide();
    return made ? takeEdited(session, stateWith(target, std::move(made).value()), edit)
                : Status(made.error());
}

}  // namespace

std::vector<MeshStep> givenMeshSteps(Invocation& given) {
    std::vector<MeshStep> steps;
    if (const auto simplifying = givenSimplifying(given)) {
        steps.emplace_back(*simplifying);
    }
    if (const auto refinement = givenRefinement(given)) {
        steps.emplace_back(*refinement);
    }
    if (given.isSet("smooth")) {
        SmoothOptions smoothing;
        smoothing.passes = given.wholeNumber("smooth", 1, SmoothOptions::kMostPasses);
        steps.emplace_back(smoothing);
    }
    return steps;
}

Status turnAllUpright(Session& session) {
    return turnUpright(session, idsOf(session));
}

Status separateAll(Session& session) {
    bool isAny = false;
    for (const TargetId id : idsOf(session)) {
        const Target& target = *session.targets().find(id);
        if (objectCount(*target.shape.mesh) < 2) {
            continue;
        }
        isAny = true;
        const Result<SeparatedObjects> objects = separated(target, meshEdit(session, id, {}).hits);
        if (!objects) {
            return objects.error();
        }
        if (Status taken = takeSeparated(session, objects.value()); !taken) {
            return taken;
        }
    }
    if (!isAny) {
        note(QStringLiteral("Nothing was separated: no mesh has several objects (o in OBJ, nodes in glTF)."));
    }
    return Done{};
}

Status changeAll(Session& session, const std::vector<MeshStep>& steps) {
    for (const MeshStep& step : steps) {
        for (const TargetId id : idsOf(session)) {  // which a step gives new numbers
            if (Status changed = change(session, id, step); !changed) {
                return changed;
            }
        }
    }
    return Done{};
}

}  // namespace hitscope::cli
