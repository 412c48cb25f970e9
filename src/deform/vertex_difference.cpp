// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/vertex_difference.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>

#include "core/grouped.h"

namespace hitscope {

void VertexDifference::add(std::span<const DynamicVertex> actual, std::span<const DynamicVertex> expected) {
    vertices += expected.size();
    for (std::size_t i = 0; i < expected.size(); ++i) {
        // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
        if (std::memcmp(&actual[i], &expected[i], sizeof(DynamicVertex)) == 0) {
            continue;
        }
        ++different;
        const float distance = glm::distance(actual[i].position, expected[i].position);
        largest = std::isnan(distance) ? std::numeric_limits<float>::infinity() : std::max(largest, distance);
    }
}

std::string describe(const VertexDifference& difference) {
    std::ostringstream text;
    const bool isOne = difference.different == 1;
    text << grouped(difference.different) << " of " << grouped(difference.vertices)
         << (isOne ? " vertices differs, " : " vertices differ, ");
    if (difference.largest > 0.0f) {
        constexpr int kDigits = 2;
        text.precision(kDigits);
        text << "by up to " << difference.largest << " m";
    } else {
        text << (isOne ? "in its normal only" : "in their normals only");
    }
    return text.str();
}

}  // namespace hitscope
