// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_step_options.h"

#include <string_view>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "document/mesh_step_fields.h"
#include "mesh/mesh_objects.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/mesh_steps/separate_objects.h"
#include "session/stand_targets.h"

namespace hitscope::cli {

namespace {

constexpr double kMostLength = 1.0e9;  // metres

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

QList<UsageOption> meshStepOptions() {
    return {flagOption("separate",
                       QStringLiteral("Before shooting, split each mesh into one target for each object.")),
            valueOption("refine", "METRES",
                        QStringLiteral("Before shooting, refine the meshes until no edge is longer.")),
            wordOption("refine-by", "METHOD", refineWords(),
                       QStringLiteral("How --refine adds vertices: midpoint and longest-edge keep the shape, "
                                      "butterfly rounds it."),
                       refineWords().front())};
}

std::optional<RefineOptions> givenRefinement(Invocation& given) {
    const std::optional<double> length = given.numberIfSet("refine", 0.0, kMostLength);
    if (!length) {
        if (given.isSet("refine-by")) {
            given.complain(QStringLiteral("--refine-by needs --refine."));
        }
        return std::nullopt;
    }
    if (!(static_cast<float>(*length) > 0.0f)) {
        given.complain(QStringLiteral("--refine takes a length in metres, more than 0."));
    }
    const auto method = static_cast<RefineMethod>(given.word("refine-by"));
    return RefineOptions{.method = method,
                         .edgeLength = static_cast<float>(*length),
                         .keepQuads = method == RefineMethod::Midpoint,
                         .region = {}};
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

Status refineAll(Session& session, const RefineOptions& options) {
    for (const TargetId id : idsOf(session)) {
        const Target& target = *session.targets().find(id);
        const MeshEdit edit = meshEdit(session, id, options);
        Result<EditedMesh> made = edited(*target.shape.mesh, edit);
        if (!made) {
            return made.error();
        }
        if (Status taken = takeEdited(session, stateWith(target, std::move(made).value()), edit); !taken) {
            return taken;
        }
    }
    return Done{};
}

}  // namespace hitscope::cli
