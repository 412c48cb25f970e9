// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "core/bounds.h"
#include "mesh/section.h"
#include "view/camera.h"

namespace hitscope {

/// A plane that opens the targets: what lies beyond it, where its normal points, is not drawn, not picked and
/// not aimed at. Their shadows, and the projectiles, stay whole. World, metres.
struct CuttingPlane {
    bool on = false;
    glm::vec3 normal{1.0f, 0.0f, 0.0f};  ///< unit
    float offset = 0.0f;                 ///< of the plane from the world's origin, along the normal
    bool flipped = false;                ///< hides the other side instead
    bool originalLine = true;            ///< section lines are drawn
    bool deformedLine = true;
    bool fill = false;  ///< closes what is cut, as if targets were solid; for meshes without holes

    [[nodiscard]] Plane plane() const { return {normal, offset}; }
    /// Unit, towards the side that is hidden: from where one looks at the section.
    [[nodiscard]] glm::vec3 openSide() const { return flipped ? -normal : normal; }
    /// dot(kept(), (p, 1)) is how far p lies within what is shown; negative: it is hidden.
    [[nodiscard]] glm::vec4 kept() const;
    [[nodiscard]] bool hides(const glm::vec3& point) const;  ///< never, when it is off
    bool operator==(const CuttingPlane&) const = default;
};

/// What of a ray (unit direction) lies where targets are shown.
struct ShownRay {
    Ray ray;              ///< from where it enters; else as it was
    float length = 0.0f;  ///< metres from there until it leaves, at most what was asked for
};
/// The part of the first `length` metres; nothing: all of it is hidden.
[[nodiscard]] std::optional<ShownRay> shownPart(const CuttingPlane& plane, const Ray& ray, float length);

/// Offsets between which a plane of that normal meets a box: least and greatest.
struct OffsetRange {
    float low = 0.0f;
    float high = 0.0f;
    [[nodiscard]] float middle() const { return 0.5f * (low + high); }
    [[nodiscard]] bool contains(float offset) const { return low < offset && offset < high; }
};
[[nodiscard]] OffsetRange offsetRange(const Bounds& bounds, const glm::vec3& normal);

/// The rectangle of the plane that stands for it in a picture.
struct PlaneFrame {
    glm::vec3 middle{0.0f};  ///< the box's middle, moved onto the plane
    glm::vec3 right{0.0f};   ///< from there to its edges: half its sides, metres, at right angles
    glm::vec3 up{0.0f};
};
/// A little larger than the box. As seen from the open side.
[[nodiscard]] PlaneFrame planeFrame(const CuttingPlane& plane, const Bounds& bounds);

/// Section lines as a frame draws them; world.
struct SectionLines {
    std::vector<SectionCurve> original;
    std::vector<SectionCurve> deformed;
};

}  // namespace hitscope
