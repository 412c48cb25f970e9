// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "render/frame_context.h"

namespace hitscope::render {

/// A corner of a trail's ribbon, laid out as in the GPU's buffer.
struct TrailVertex {
    glm::vec3 position{0.0f};  ///< metres, world
    std::uint32_t colour = 0;  ///< red, green, blue, opacity; a byte each, red lowest
};
static_assert(sizeof(TrailVertex) == 16);

/// Adds the ribbon behind a projectile, two triangles a part, that fades and narrows towards its end and
/// faces the camera's eye. Nothing for one that lies still. All ribbons are one triangle strip: the first and
/// the last corner of each come twice, so that what joins it to the next one has no area.
void addTrail(const ProjectileItem& projectile, const Camera& camera, std::vector<TrailVertex>& vertices);

/// The trails of projectiles in flight, all in one draw. A context is current for every call and the
/// destructor.
class TrailPass {
public:
    TrailPass();
    /// With blending, depth test on and depth writes off.
    [[nodiscard]] Status draw(const FrameContext& context);

private:
    gl::Buffer m_buffer;
    gl::VertexArray m_array;
    std::vector<TrailVertex> m_vertices;
};

}  // namespace hitscope::render
