// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>

#include "core/result.h"
#include "session/target_plan.h"
#include "session/target_source.h"

namespace hitscope {

class Session;

// Metres, of meshes that are always the same.
inline constexpr float kPaperHalfExtent = 2.5f;  ///< or radius
inline constexpr float kTurntableHeight = 0.3f;
inline constexpr float kTurntableFlatness = 0.05f;  ///< height over width, of those of any size
inline constexpr float kFineTorusRadius = 1.9f;     ///< to the middle of the tube
inline constexpr float kFineTorusTube = 0.6f;       ///< radius

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

[[nodiscard]] std::size_t vertexCount(const Primitive& primitive);
/// Metres: one that suits the scene. That of the paper's targets, or, where the largest one that is shown has
/// less than a tenth or more than ten times of it, about as large as that one, in round numbers.
[[nodiscard]] float usualPrimitiveSize(const Session& session);
/// Standing on y = 0. Cubes and spheres collide exactly, the others with their triangles. Takes seconds for
/// the finest.
[[nodiscard]] TargetPlan planPrimitive(const Primitive& primitive);
/// Raises a target by the height of a turntable, which is added where it stood: two steps to undo. Refused
/// where there is no such target, or it has no width.
[[nodiscard]] Status putOnTurntable(Session& session, TargetId id);
/// About the mesh's own origin. The paper's collide exactly, the others with their triangles.
[[nodiscard]] TargetPlan planBuiltIn(BuiltInMesh mesh);

}  // namespace hitscope
