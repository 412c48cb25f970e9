// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene/scene_gpu.h"
#include "session/vertex_selection.h"

namespace hitscope {

/// Finds the vertices that pixels of the picture show. Makes no GL call itself, but a context is current for
/// every call and the destructor.
///
/// Positions in the picture are in device pixels from its upper left corner, (0.5, 0.5) the middle of its
/// first pixel: what QWidget's logical pixels are times its device pixel ratio.
class ScenePicker {
public:
    /// `session` and `scene` outlive this.
    ScenePicker(Session& session, SceneGpu& scene);
    ~ScenePicker();
    ScenePicker(const ScenePicker&) = delete;
    ScenePicker& operator=(const ScenePicker&) = delete;

    /// Of the triangle seen at that pixel, the corner nearest to `at`, as SceneGpu::draw() last drew the
    /// targets. In a picture of wireframes only: the vertex, hidden by surfaces or not, that falls nearest to
    /// `at` within kReach. Waits for the GPU.
    [[nodiscard]] Result<std::optional<VertexRef>> pick(const SceneGpu::View& view, const glm::vec2& at);

    /// Likewise without waiting: arrived() has it some milliseconds later. Only one at a time: what was asked
    /// for before is forgotten.
    [[nodiscard]] Status request(const SceneGpu::View& view, const glm::vec2& at);
    [[nodiscard]] bool isPending() const;
    /// Once for each request; its error is the driver's. Nothing: not yet.
    [[nodiscard]] std::optional<std::optional<VertexRef>> arrived();

    /// Whether vertices hidden behind surfaces count.
    enum class Depth : std::uint8_t { Visible, Through };
    /// The changed vertices of the visible targets within an outline (a polygon's corners in order, any
    /// winding; crossing lines count by the even-odd rule), each list ascending. Waits for the GPU. A picture
    /// of wireframes only hides nothing.
    [[nodiscard]] Result<std::map<TargetId, std::vector<std::uint32_t>>> changedWithin(
        const SceneGpu::View& view, std::span<const glm::vec2> outline, Depth depth);

    /// Logical pixels: how near the cursor has to come to a vertex of a wireframe.
    static constexpr float kReach = 10.0f;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

}  // namespace hitscope
