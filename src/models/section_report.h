// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <glm/vec2.hpp>
#include <optional>

#include "analysis/scene_section.h"

namespace hitscope {

/// A point of a deformed section curve and what there is to say of it.
struct SectionReading {
    TargetId target;
    glm::vec3 place{0.0f};  ///< world, metres
    /// On the original's section: sectionDepths(). Nothing: the plane does not cut the original.
    std::optional<glm::vec3> nearest;
    std::optional<double> depth;  ///< metres between the two, likewise

    bool operator==(const SectionReading&) const = default;
};

/// Of the section of one target, or of all where `only` is nothing.
struct SectionScope {
    TargetId only;
    [[nodiscard]] bool holds(const TargetSection& section) const { return !only || section.target == only; }
};
/// The selected target's section where the plane cuts it; else that of all.
[[nodiscard]] SectionScope sectionScope(const SceneSection& section, TargetId selected);

/// The place on the deformed section nearest to `at`, in the coordinates of the section's view. Between two
/// corners depth and nearest place are in proportion. Nothing where there is no such curve.
[[nodiscard]] std::optional<SectionReading> readSection(const SceneSection& section,
                                                        const SectionScope& scope, const glm::dvec2& at);
/// The deepest corner; nothing where the plane cuts nothing, or nothing has moved there.
[[nodiscard]] std::optional<SectionReading> deepestOf(const SceneSection& section, const SectionScope& scope);

/// "z 0.520, y 1.200": a place by its section's coordinates.
[[nodiscard]] QString placeText(const SectionView& view, const glm::vec3& place);
/// A line a figure: name, value, unit, with tabs between.
[[nodiscard]] QString sectionText(const SceneSection& section, const SectionScope& scope);
/// A line a corner: "state,target,line,closed,x_m,y_m,z_m,right_m,up_m,depth_m".
[[nodiscard]] QByteArray sectionCsv(const SceneSection& section, const SectionScope& scope);

}  // namespace hitscope
