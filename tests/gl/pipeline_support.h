// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"
#include "mesh/render_mesh.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/target_buffers.h"

namespace hitscope::test {

/// A mesh with its buffers, as a scene has it.
struct TestTarget {
    TestTarget(std::uint32_t number, RenderMesh renderMesh)
        : id{number}, mesh(std::move(renderMesh)), buffers(std::make_unique<TargetBuffers>(mesh)) {}
    TargetId id;
    RenderMesh mesh;
    std::unique_ptr<TargetBuffers> buffers;
};
using TestScene = std::vector<TestTarget>;

/// The paper's meshes by name, "High-poly sphere" ..., as targets 1, 2, ...
[[nodiscard]] TestScene makeScene(const QStringList& meshes);
/// Only vertices and clusters: `count` points in a cube of half extent `extent`, unit normals.
[[nodiscard]] RenderMesh pointCloud(std::uint32_t seed, std::uint32_t count, float extent);

/// A pipeline with the scene's targets; null, and a warning, where it cannot be made.
[[nodiscard]] std::unique_ptr<DeformationPipeline> pipelineOn(PipelineKind kind, TestScene& scene);

/// Hits near the surfaces of random targets of the scene, from all sides, with `constants` different
/// constants.
[[nodiscard]] std::vector<Hit> randomHits(const TestScene& scene, std::uint32_t seed, std::size_t count,
                                          std::size_t constants = 1);
[[nodiscard]] DeformationConstants testConstants(std::size_t index);

/// What a receiver of readBack() has: every target's vertices, at first the original ones.
class Mirror {
public:
    explicit Mirror(const TestScene& scene);
    /// Takes what the pipeline reads back; returns the number of vertices delivered.
    std::size_t readBack(DeformationPipeline& pipeline);
    /// Takes what has arrived and asks for more, without waiting.
    void poll(DeformationPipeline& pipeline);
    [[nodiscard]] std::span<const DynamicVertex> vertices(TargetId target) const {
        return m_vertices.at(target);
    }

private:
    void take(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices);

    std::map<TargetId, std::vector<DynamicVertex>> m_vertices;
};

/// Where two arrays of vertices first differ in a bit, and how many vertices do; empty: nowhere.
[[nodiscard]] QString difference(std::span<const DynamicVertex> actual,
                                 std::span<const DynamicVertex> expected);
/// Of every target of the mirror from the reference deformation after `hits`; empty: none.
[[nodiscard]] QString differenceFromReference(const Mirror& mirror, const TestScene& scene,
                                              std::span<const Hit> hits);

}  // namespace hitscope::test
