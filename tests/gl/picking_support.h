// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "gl/context.h"
#include "scene/scene_gpu.h"
#include "scene/scene_picker.h"
#include "session/target.h"

namespace hitscope::test {

/// How vertices are drawn.
struct Shown {
    bool original = false;
    float factor = 1.0f;

    [[nodiscard]] glm::vec3 placeOf(const Target& target, std::uint32_t renderVertex) const;
};

/// Three dented targets, and what pixels of their picture show by rays cast on the CPU.
class PickedScene {
public:
    void start();  ///< a context; the calls below need one
    void close();  ///< the scene; GL errors are failures
    void open(PipelineKind kind);

    [[nodiscard]] SceneGpu::View viewOf(float ratio) const;
    /// Whether a ray through that pixel meets, of what the view shows, a triangle whose nearest corner this
    /// is.
    [[nodiscard]] bool isSeenAt(SceneGpu::View view, glm::vec2 at,
                                const std::optional<VertexRef>& picked) const;
    [[nodiscard]] bool isInView(const SceneGpu::View& view, const VertexRef& vertex) const;

    std::unique_ptr<gl::OffscreenContext> m_context;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;
    std::unique_ptr<ScenePicker> m_picker;
};

}  // namespace hitscope::test
