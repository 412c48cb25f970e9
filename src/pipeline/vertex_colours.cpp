// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/vertex_colours.h"

#include <algorithm>
#include <cmath>

#include "core/srgb.h"

namespace hitscope {

namespace {

/// A multiple of 255: the 8-bit values that most files have are met exactly.
constexpr int kSteps = 16 * 255;

using Table = std::array<std::uint16_t, kSteps + 1>;

/// A table, as a mesh may have millions of vertices.
Table makeTable() {
    Table table{};
    for (int i = 0; i <= kSteps; ++i) {
        const double value = static_cast<double>(i) / kSteps;
        table[static_cast<std::size_t>(i)] =
            static_cast<std::uint16_t>(std::lround(65535.0 * linearOfSrgb(value)));
    }
    return table;
}

}  // namespace

std::vector<LinearColour> linearColours(std::span<const glm::vec3> srgb,
                                        std::span<const std::uint32_t> fileVertices) {
    static const Table table = makeTable();
    std::vector<LinearColour> colours;
    colours.reserve(fileVertices.size());
    for (const std::uint32_t vertex : fileVertices) {
        LinearColour linear{};
        for (int i = 0; i < 3; ++i) {
            const float step = std::clamp(srgb[vertex][i], 0.0f, 1.0f) * static_cast<float>(kSteps);
            linear[static_cast<std::size_t>(i)] = table[static_cast<std::size_t>(step + 0.5f)];
        }
        colours.push_back(linear);
    }
    return colours;
}

}  // namespace hitscope
