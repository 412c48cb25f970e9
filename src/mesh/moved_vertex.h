// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace hitscope {

/// Where a file vertex now is; metres, local frame.
struct MovedVertex {
    std::uint32_t vertex = 0;
    glm::vec3 position{0.0f};
};

}  // namespace hitscope
