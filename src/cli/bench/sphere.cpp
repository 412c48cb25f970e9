// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/sphere.h"

#include <algorithm>
#include <cmath>

#include "mesh/primitives.h"

namespace hitscope::bench {

namespace {

constexpr int kPaperVertices = 7938;
constexpr int kNearPaper = 100;  // "8K" means the paper's as well

}  // namespace

// Twice as many segments around as rings down: 2 rings^2 vertices.
MeshData makeSphere(int vertices) {
    if (std::abs(vertices - kPaperVertices) <= kNearPaper) {
        return makeHighPolySphere(kSphereRadius);
    }
    const int rings = std::max(2, static_cast<int>(std::lround(std::sqrt(0.5 * vertices))));
    return makeUvSphere(2 * rings, rings, kSphereRadius);
}

}  // namespace hitscope::bench
