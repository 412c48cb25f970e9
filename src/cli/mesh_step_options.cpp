// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_step_options.h"

#include <utility>
#include <vector>

#include "mesh/mesh_objects.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/mesh_steps/separate_objects.h"

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

}  // namespace

QList<UsageOption> meshStepOptions() {
    return {flagOption("separate",
                       QStringLiteral("Before shooting, split each mesh into one target for each object.")),
            valueOption("refine", "METRES",
                        QStringLiteral("Before shooting, refine the meshes until no edge is longer."))};
}

std::optional<float> givenRefinement(Invocation& given) {
    const std::optional<double> length = given.numberIfSet("refine", 0.0, kMostLength);
    if (!length) {
        return std::nullopt;
    }
    if (!(static_cast<float>(*length) > 0.0f)) {
        given.complain(QStringLiteral("--refine takes a length in metres, more than 0."));
    }
    return static_cast<float>(*length);
}

Status separateAll(Session& session) {
    for (const TargetId id : idsOf(session)) {
        const Target& target = *session.targets().find(id);
        if (objectCount(*target.shape.mesh) < 2) {
            continue;
        }
        const Result<SeparatedObjects> objects = separated(target, meshEdit(session, id, {}).hits);
        if (!objects) {
            return objects.error();
        }
        if (Status taken = takeSeparated(session, objects.value()); !taken) {
            return taken;
        }
    }
    return Done{};
}

Status refineAll(Session& session, float edgeLength) {
    for (const TargetId id : idsOf(session)) {
        const Target& target = *session.targets().find(id);
        const MeshEdit edit = meshEdit(
            session, id,
            RefineOptions{
                .method = RefineMethod::Midpoint, .edgeLength = edgeLength, .keepQuads = true, .region = {}});
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
