// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/painted_row.h"

#include <glm/geometric.hpp>

#include "session/scene_presets.h"

namespace hitscope::bench {

namespace {

constexpr float kRoughness = 0.4f;

/// As the default material of what is drawn.
Material clay() {
    Material clay;
    clay.diffuse = {0.47f, 0.435f, 0.40f};
    clay.specular = glm::vec3(0.30f);
    clay.shininess = 40.0f;
    return clay;
}

PreparedMesh painted(const MeshData& mesh) {
    MeshData painted = mesh;
    painted.materials = {clay()};
    painted.faceMaterials.assign(mesh.faceCount(), 0);
    for (const glm::vec3& position : mesh.positions) {
        painted.colours.push_back(0.5f + 0.5f * glm::normalize(position));
    }
    return prepareMesh(std::move(painted));
}

}  // namespace

ScenePlan planPaintedRow(int row) {
    const PaperRow& preset = paperRows()[static_cast<std::size_t>(row)];
    ScenePlan plan{preset.label(), planPaperRow(preset), 0.0f};
    std::map<std::shared_ptr<const MeshData>, PreparedMesh> known;
    for (TargetPlan& target : plan.targets) {
        const auto [at, isNew] = known.try_emplace(target.shape.mesh);
        if (isNew) {
            at->second = painted(*target.shape.mesh);
        }
        target.shape = at->second;
    }
    return plan;
}

void MetalCoat::put(Session& session, bool on) {
    if (on == m_on) {
        return;
    }
    m_on = on;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const std::shared_ptr<const MeshData> now = target->deformed.sharedOriginal();
        std::shared_ptr<const MeshData>& other = m_others[now];
        if (!other) {
            MeshData metal = *now;
            metal.materials.front().metalRoughness = {1.0f, kRoughness, {}, -1};
            other = std::make_shared<const MeshData>(std::move(metal));
            m_others[other] = now;
        }
        const TargetId id = target->id;
        session.targets().setTexture(std::span(&id, 1), std::shared_ptr<const MeshData>(other), {});
    }
}

}  // namespace hitscope::bench
