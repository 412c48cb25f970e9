// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "core/ids.h"
#include "deform/hit.h"
#include "mesh/render_mesh.h"

namespace hitscope::bench {

/// Something to hit. The mesh outlives whoever holds this.
struct HitTarget {
    TargetId id;
    const RenderMesh* mesh = nullptr;
};

/// Hits all over the original surfaces of targets, of each in turn: every piece of a surface is as likely as
/// any other of its size, directions lie within 30 degrees of straight in. The same targets, constants and
/// seed give the same hits on every machine.
class RandomHits {
public:
    /// `targets`: at least one, each with triangles.
    RandomHits(const std::vector<HitTarget>& targets, const DeformationConstants& constants,
               std::uint32_t seed);
    [[nodiscard]] Hit next();
    [[nodiscard]] std::vector<Hit> next(std::size_t count);

private:
    struct Surface {
        HitTarget target;
        float largestArea = 0.0f;  ///< of a triangle, times two
    };
    [[nodiscard]] float unit();
    [[nodiscard]] std::size_t pickTriangle(const Surface& surface);

    std::vector<Surface> m_surfaces;
    DeformationConstants m_constants;
    std::mt19937 m_random;
    std::size_t m_turn = 0;
};

/// Constants with which a hit reaches about `affected` vertices of a sphere of `radius` metres with
/// `vertices` vertices: the paper's hit (its 0.5 m reach about 80 of its sphere's 7,938) made smaller in all
/// directions.
[[nodiscard]] DeformationConstants constantsReaching(double affected, double vertices, double radius);

/// How many vertices the hits move, one after the other, each from where those before left it; the mean over
/// the hits. All are on this mesh; what no hit can reach costs nothing but its copy.
[[nodiscard]] double countAffected(const RenderMesh& mesh, const std::vector<Hit>& hits);

}  // namespace hitscope::bench
