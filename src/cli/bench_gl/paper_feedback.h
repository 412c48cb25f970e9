// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/result.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "gl/render_target.h"
#include "mesh/render_mesh.h"
#include "pipeline/hit_arrays.h"
#include "pipeline/target_buffers.h"

namespace hitscope::bench {

/// The paper's own way of applying a hit by transform feedback (section 2.2, Algorithm 2), to measure ours
/// against: capture every vertex of the mesh, read all of them back, put those that were modified into the
/// mesh on the CPU, upload the mesh. Done as well as that way can be: the right number of vertices, both
/// attributes in one buffer, nothing allocated for a hit but by the upload itself. A context is current for
/// every call and the destructor.
class PaperFeedback {
public:
    /// `deformDefines`: for programs that include deform.glsl (definesOf()), so that it ends at the same mesh
    /// as the pipelines. The error is the driver's.
    [[nodiscard]] static Result<PaperFeedback> create(std::span<const DynamicVertex> vertices,
                                                      const gl::Defines& deformDefines);
    /// Likewise, one a target, each in the buffer that its target is drawn from. The meshes' vertices are in
    /// these buffers now, and `targets` outlive what is made.
    struct Drawn {
        const TargetBuffers* buffers = nullptr;
        std::span<const DynamicVertex> vertices;
    };
    [[nodiscard]] static Result<std::vector<PaperFeedback>> createOn(std::span<const Drawn> targets,
                                                                     const gl::Defines& deformDefines);

    /// Applies one hit; comes back when the new vertices are with the driver.
    void apply(const Hit& hit);
    /// The mesh on the CPU.
    [[nodiscard]] std::span<const DynamicVertex> vertices() const { return m_mesh; }
    /// Back to these; as many as there are.
    void restore(std::span<const DynamicVertex> vertices);

private:
    using SharedProgram = std::shared_ptr<const gl::Program>;
    [[nodiscard]] static Result<SharedProgram> makeProgram(const gl::Defines& deformDefines);
    PaperFeedback(SharedProgram program, std::span<const DynamicVertex> vertices, const TargetBuffers* drawn);
    void capture(const Hit& hit);
    void upload();

    SharedProgram m_program;
    HitArrays m_hit;
    gl::RenderTarget m_framebuffer;
    gl::Buffer m_ownBuffer;      ///< none where a target's is used
    gl::VertexArray m_ownArray;  ///< likewise
    GLuint m_buffer = 0;
    GLuint m_array = 0;
    gl::Buffer m_captured;
    std::vector<DynamicVertex> m_mesh;
    std::vector<DynamicVertex> m_readBack;
};

}  // namespace hitscope::bench
