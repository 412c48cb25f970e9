// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "deform/hit.h"

namespace hitscope {

/// The deformation function (paper, Algorithm 3 and equations 1-4): moves `position` and turns `normal` if
/// the vertex is within max_distance of the hit. Returns whether it is. shaders/deform.glsl is its twin: the
/// same operations in the same order, each rounded to float, nothing contracted; tests/gl compares them bit
/// for bit.
bool deform(glm::vec3& position, glm::vec3& normal, const Hit& hit);

}  // namespace hitscope
