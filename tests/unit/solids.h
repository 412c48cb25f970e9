// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh_support.h"

namespace hitscope::test {

/// A torus about the z axis: `around` by `across` quads.
inline MeshData torus(std::uint32_t around, std::uint32_t across, double radius, double tube) {
    PageVector<glm::vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < around; ++i) {
        const double u = 2.0 * std::numbers::pi * i / around;
        for (std::uint32_t j = 0; j < across; ++j) {
            const double v = 2.0 * std::numbers::pi * j / across;
            const double out = radius + tube * std::cos(v);
            positions.emplace_back(out * std::cos(u), out * std::sin(u), tube * std::sin(v));
            const std::uint32_t right = (i + 1) % around * across;
            const std::uint32_t up = (j + 1) % across;
            faces.push_back({i * across + j, right + j, right + up, i * across + up});
        }
    }
    return meshOf(std::move(positions), faces);
}

/// The wall of a cylinder of radius 1 and height 1, n quads around; with lids: two n-gons.
inline MeshData cylinder(std::uint32_t n, bool hasLids) {
    PageVector<glm::vec3> positions;
    std::vector<std::vector<std::uint32_t>> faces;
    std::vector<std::uint32_t> top;
    std::vector<std::uint32_t> bottom;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        positions.emplace_back(std::cos(angle), std::sin(angle), 1.0);
        const std::uint32_t next = (i + 1) % n;
        faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
        top.push_back(2 * i + 1);
        bottom.push_back(2 * (n - 1 - i));
    }
    if (hasLids) {
        faces.push_back(top);
        faces.push_back(bottom);
    }
    return meshOf(std::move(positions), faces);
}

/// `leaves` triangles that share one edge along z.
inline MeshData nonManifoldFan(std::uint32_t leaves) {
    PageVector<glm::vec3> positions{{0, 0, 0}, {0, 0, 1}};
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t i = 0; i < leaves; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / leaves;
        positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        faces.push_back({0, 1, 2 + i});
    }
    return meshOf(std::move(positions), faces);
}

/// Every corner a vertex of its own, as files with seams everywhere have it.
inline MeshData exploded(const MeshData& mesh) {
    MeshData split;
    split.faceStarts = mesh.faceStarts;
    for (const std::uint32_t vertex : mesh.cornerVertices) {
        split.cornerVertices.push_back(static_cast<std::uint32_t>(split.positions.size()));
        split.positions.push_back(mesh.positions[vertex]);
    }
    return split;
}

/// Both meshes in one.
inline MeshData together(const MeshData& first, const MeshData& second) {
    MeshData both = first;
    const auto shift = static_cast<std::uint32_t>(first.positions.size());
    both.positions.insert(both.positions.end(), second.positions.begin(), second.positions.end());
    for (std::size_t f = 0; f < second.faceCount(); ++f) {
        for (const std::uint32_t vertex : second.face(f)) {
            both.cornerVertices.push_back(vertex + shift);
        }
        both.faceStarts.push_back(static_cast<std::uint32_t>(both.cornerVertices.size()));
    }
    return both;
}

inline void turnOver(MeshData& mesh, std::size_t face) {
    std::reverse(mesh.cornerVertices.begin() + mesh.faceStarts[face],
                 mesh.cornerVertices.begin() + mesh.faceStarts[face + 1]);
}

}  // namespace hitscope::test
