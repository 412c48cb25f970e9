// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "gl/objects.h"
#include "render/renderer.h"
#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope {

/// The session's vertex selection on the GPU. A context is current for every call and the destructor.
class SceneMarks {
public:
    /// Brings the buffers to the selection, at the cost of what it holds where it has changed.
    void follow(const Session& session);
    /// On these targets: selected ones first, so that the picked and the hovered vertex are on top.
    [[nodiscard]] std::vector<VertexMarks> on(std::span<const DrawItem> targets) const;

private:
    struct Marks {
        gl::Buffer indices;
        GLsizei count = 0;
    };
    struct Single {
        std::optional<VertexRef> vertex;
        Marks marks;
    };
    static void fill(Marks& marks, const Target* target, std::span<const std::uint32_t> fileVertices);
    static void follow(Single& single, const Session& session, const std::optional<VertexRef>& vertex);

    std::uint64_t m_revision = 0;
    std::map<TargetId, Marks> m_selected;
    Single m_picked;
    Single m_hovered;
};

}  // namespace hitscope
