// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/result.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "gl/render_target.h"
#include "mesh/render_mesh.h"
#include "pipeline/hit_arrays.h"

namespace hitscope::bench {

/// The paper's own way of applying a hit by transform feedback (section 2.2, Algorithm 2), to measure ours
/// against: capture every vertex of the mesh, read all of them back, put those that were modified into the
/// mesh on the CPU, upload the mesh. Done as well as that way can be: the right number of vertices, both
/// attributes in one buffer, nothing allocated for a hit but by the upload itself. A context is current for
/// every call and the destructor.
class PaperFeedback {
public:
    /// The error is the driver's.
    [[nodiscard]] static Result<PaperFeedback> create(std::span<const DynamicVertex> vertices);

    /// Applies one hit; comes back when the new vertices are with the driver.
    void apply(const Hit& hit);
    /// The mesh on the CPU.
    [[nodiscard]] std::span<const DynamicVertex> vertices() const { return m_mesh; }
    /// Back to these; as many as there are.
    void restore(std::span<const DynamicVertex> vertices);

private:
    PaperFeedback(gl::Program program, std::span<const DynamicVertex> vertices);
    void capture(const Hit& hit);
    void upload();

    gl::Program m_program;
    HitArrays m_hit;
    gl::RenderTarget m_framebuffer;
    gl::Buffer m_buffer;
    gl::Buffer m_captured;
    gl::VertexArray m_array;
    std::vector<DynamicVertex> m_mesh;
    std::vector<DynamicVertex> m_readBack;
};

}  // namespace hitscope::bench
