// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "mesh/render_mesh.h"

namespace hitscope {

/// The bytes of that many vertices in a dynamic or original buffer, in the type OpenGL takes sizes and
/// offsets in.
constexpr std::ptrdiff_t vertexBytes(std::size_t vertices) {
    return static_cast<std::ptrdiff_t>(vertices * sizeof(DynamicVertex));
}

}  // namespace hitscope
