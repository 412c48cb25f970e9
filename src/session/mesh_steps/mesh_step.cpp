// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mesh_steps/mesh_step.h"

#include <string>
#include <utility>

#include "deform/reference.h"
#include "mesh/mesh_objects.h"
#include "mesh/refine/moved_shape.h"
#include "mesh/render_mesh.h"

namespace hitscope {

namespace {

Result<MeshData> make(const MeshData& mesh, const RefineOptions& options, const MeshGoOn& goOn) {
    Result<RefinedMesh> refined = refine(mesh, options, goOn);
    return refined ? Result<MeshData>(std::move(refined.value().mesh)) : Result<MeshData>(refined.error());
}

Result<MeshData> make(const MeshData& mesh, const SimplifyOptions& options, const MeshGoOn& goOn) {
    return simplify(mesh, options, goOn);
}

Result<MeshData> make(const MeshData& mesh, const SmoothOptions& options, const MeshGoOn& goOn) {
    return smooth(mesh, options, goOn);
}

Result<MeshData> make(const MeshData& mesh, const MergedHits& applied, const MeshGoOn& /*goOn*/) {
    const RenderMesh render = buildRenderMesh(mesh);
    ReferenceDeformation deformation(render);
    deformation.apply(applied.hits);
    std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
    for (std::size_t v = 0; v < render.vertices.size(); ++v) {
        positions[render.fileVertices[v]] = deformation.vertices()[v].position;
    }
    return withShape(mesh, positions);
}

Result<MeshData> make(const MeshData& mesh, const OnlyObject& object, const MeshGoOn& /*goOn*/) {
    const MeshObjects objects(mesh);
    if (object.index >= objects.count()) {
        return Error{"The mesh has no object " + std::to_string(object.index) + " (counted from 0); it has " +
                         std::to_string(objects.count()) + ".",
                     "", "Open the file that the session was made with."};
    }
    return objects.only(object.index);
}

}  // namespace

Result<MeshData> withStep(const MeshData& mesh, const MeshStep& step, const MeshGoOn& goOn) {
    Result<MeshData> made = std::visit([&](const auto& what) { return make(mesh, what, goOn); }, step);
    if (made) {
        if (const Status valid = validate(made.value()); !valid) {
            return valid.error();
        }
    }
    return made;
}

Result<MeshData> withSteps(MeshData mesh, std::span<const std::shared_ptr<const MeshStep>> steps,
                           const MeshGoOn& goOn) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto share = [&](double done) {
            return !goOn || goOn((static_cast<double>(i) + done) / static_cast<double>(steps.size()));
        };
        Result<MeshData> made = withStep(mesh, *steps[i], share);
        if (!made) {
            return made.error();
        }
        mesh = std::move(made).value();
    }
    return mesh;
}

}  // namespace hitscope
