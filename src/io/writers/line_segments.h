// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// Appends a line in segments of two vertices each.
inline void appendSegments(std::span<const std::uint32_t> line, std::vector<std::uint32_t>& segments) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        segments.push_back(line[i - 1]);
        segments.push_back(line[i]);
    }
}

/// All lines of a mesh, two vertices a segment.
[[nodiscard]] inline std::vector<std::uint32_t> lineSegments(const MeshData& mesh) {
    std::vector<std::uint32_t> segments;
    for (const std::vector<std::uint32_t>& line : mesh.lines) {
        appendSegments(line, segments);
    }
    return segments;
}

}  // namespace hitscope
