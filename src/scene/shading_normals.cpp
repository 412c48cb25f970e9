// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/shading_normals.h"

namespace hitscope {

/// Short gaps are filled, since a call costs more than a few vertices.
void writeShadingNormals(TargetBuffers& buffers, std::span<const std::uint32_t> vertices,
                         const TurnedNormals& normals) {
    constexpr std::uint32_t kLargestGap = 32;
    std::size_t begin = 0;
    while (begin < vertices.size()) {
        std::size_t end = begin + 1;
        while (end < vertices.size() && vertices[end] - vertices[end - 1] <= kLargestGap) {
            ++end;
        }
        const std::uint32_t first = vertices[begin];
        buffers.writeShadingNormals(first, normals.some(first, vertices[end - 1] + 1 - first));
        begin = end;
    }
}

}  // namespace hitscope
