// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <span>

#include "session/target_plan.h"

namespace hitscope {

enum class PrimitiveKind : std::uint8_t { Cube, UvSphere, GeodesicSphere, Torus, Cylinder, Sheet };

struct PrimitiveTraits {
    PrimitiveKind kind = PrimitiveKind::Cube;
    const char* resolution = "";  ///< what the number counts, for people; English, to be translated
    int least = 1;
    int usual = 32;
    int most = 1000;  ///< about 2,000,000 triangles
};
/// In the order in which they are offered.
[[nodiscard]] std::span<const PrimitiveTraits> allPrimitives();
[[nodiscard]] const PrimitiveTraits& traitsOf(PrimitiveKind kind);
[[nodiscard]] QString primitiveName(PrimitiveKind kind);

/// A shape that can be made in any fineness.
struct Primitive {
    PrimitiveKind kind = PrimitiveKind::Cube;
    int resolution = 32;  ///< within the kind's range, or it is brought there
    float size = 5.0f;    ///< metres: its largest extent, > 0
};

[[nodiscard]] std::size_t vertexCount(const Primitive& primitive);
/// Standing on y = 0. Cubes and spheres collide exactly, the others with their triangles. Takes seconds for
/// the finest.
[[nodiscard]] TargetPlan planPrimitive(const Primitive& primitive);

}  // namespace hitscope
