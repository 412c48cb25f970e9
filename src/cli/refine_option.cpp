// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/refine_option.h"

#include <utility>
#include <vector>

#include "session/mesh_steps/mesh_edit.h"

namespace hitscope::cli {

namespace {

constexpr double kMostLength = 1.0e9;  // metres

}  // namespace

UsageOption refineOption() {
    return valueOption(
        "refine", "METRES",
        QStringLiteral("Refine the meshes before they are shot at, so that no edge is longer."));
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

Status refineAll(Session& session, float edgeLength) {
    std::vector<TargetId> targets;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        targets.push_back(target->id);
    }
    for (const TargetId id : targets) {
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
