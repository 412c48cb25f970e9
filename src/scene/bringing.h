// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <future>
#include <memory>

#include "gl/side_context.h"
#include "pipeline/target_buffers.h"

namespace hitscope {

struct MeshData;

/// A mesh that is on its way to the GPU, or there, before a target of it.
class Bringing {
public:
    /// side: brings it, and outlives this; null: more() does.
    Bringing(const MeshData& mesh, std::shared_ptr<const RenderMesh> render, gl::SideContext* side);
    ~Bringing();  ///< gives up what is missing
    Bringing(const Bringing&) = delete;
    Bringing& operator=(const Bringing&) = delete;

    [[nodiscard]] const std::shared_ptr<const RenderMesh>& mesh() const { return m_mesh; }
    /// Takes some milliseconds at most. Returns whether all is there.
    bool more();
    /// All of it, now. Once, and the last call.
    [[nodiscard]] std::unique_ptr<TargetBuffers> take();

private:
    std::shared_ptr<const RenderMesh> m_mesh;
    std::unique_ptr<TargetBuffers> m_buffers;
    std::atomic_bool m_stop = false;
    std::future<void> m_beside;  // valid while another thread has m_buffers
};

}  // namespace hitscope
