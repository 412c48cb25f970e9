// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/ply_indices.h"

#include <algorithm>
#include <span>
#include <string>

namespace hitscope {

Status checkPlyIndices(const MeshData& mesh, std::size_t vertices) {
    const auto badIn = [vertices](std::span<const std::uint32_t> of) {
        return std::find_if(of.begin(), of.end(),
                            [vertices](std::uint32_t vertex) { return vertex >= vertices; });
    };
    const auto error = [vertices](std::uint32_t vertex, const char* kind, std::size_t number) {
        return Error{"It refers to vertex " + std::to_string(vertex) +
                         " (counted from 0), but the file has " + std::to_string(vertices) + " vertices.",
                     kind + std::to_string(number + 1),
                     "Write the file again with the program it came from."};
    };
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const std::span<const std::uint32_t> face = mesh.face(f);
        if (const auto bad = badIn(face); bad != face.end()) {
            return error(*bad, "face ", f);
        }
    }
    for (std::size_t l = 0; l < mesh.lines.size(); ++l) {
        const std::span<const std::uint32_t> line = mesh.lines[l];
        if (const auto bad = badIn(line); bad != line.end()) {
            return error(*bad, "edge ", l);
        }
    }
    return Done{};
}

}  // namespace hitscope
