// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "deform/dent_shape.h"
#include "mesh/render_mesh.h"

namespace hitscope {

// What deform() and deformAll() count as none: see deform.cpp.

/// Nearer than 1e-11 m counts as r = 0. Some renderers flush denormal numbers to zero; from here on that
/// changes nothing: a sum of two squares that feels a lost denormal is below 1e-30, less than half a unit in
/// the last place of r2.
inline constexpr float kNoDistance2 = 1e-22f;
/// Smaller components of a turned normal count as 0, so that neither they nor the residuals by which
/// exactDivide() in deform.glsl corrects a quotient are denormal.
inline constexpr float kNoComponent = 1e-20f;
/// A sum of normal and displacement has no direction if its square is not above this.
inline constexpr float kNoLength2 = 1e-12f;

/// deform() of each of these vertices, with the same bits. The paper's form goes through four at a time where
/// the processor has SSE: a vertex costs two square roots and four quotients, and it makes four of either in
/// the time of one.
void deformAll(std::span<DynamicVertex> vertices, const DentShape& dent);

}  // namespace hitscope
