// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gl/fence.h"
#include "gl/objects.h"
#include "render/picked.h"
#include "render/program_cache.h"
#include "render/renderer.h"

namespace hitscope {

/// Draws which target and which of its triangles or vertices each pixel of a picture shows: through the same
/// vertex program as the picture, so that what is pointed at is what is seen, whatever the pipeline. Only the
/// pixels asked for are drawn and kept, so their number and not the window's is what it costs.
///
/// A context is current for every call and the destructor.
class PickPass {
public:
    PickPass() = default;
    ~PickPass();
    PickPass(const PickPass&) = delete;
    PickPass& operator=(const PickPass&) = delete;

    /// How the programs learn which triangle or vertex it is: `byGeometry`, from a geometry shader
    /// (pick.geom), where the driver needs it (tryPicking()). `defines` are added to the programs.
    void setWay(bool byGeometry, gl::Defines defines = {});

    /// Draws the frame's targets; its other parts neither show nor hide anything. 0 < area.width, height.
    [[nodiscard]] Status draw(const Frame& frame, DeformationPipeline& pipeline, const PixelArea& area,
                              PickElements elements);

    /// The area drawn last: area.width * area.height entries, rows from bottom to top. Waits for the GPU.
    [[nodiscard]] std::vector<PickedElement> read();

    /// Has the area copied as soon as the GPU gets there. What was asked for before is forgotten.
    void startReading();
    [[nodiscard]] bool isReading() const { return m_fence.has_value(); }
    /// As read(), of when startReading() was called; nothing: it has not arrived. Never waits.
    [[nodiscard]] std::optional<std::vector<PickedElement>> takeArrived();

private:
    [[nodiscard]] Status makeRoom(const PixelArea& area);
    [[nodiscard]] Result<const gl::Program*> programFor(const Frame& frame,
                                                        const DeformationPipeline& pipeline, bool points,
                                                        bool filled);

    render::ProgramCache m_programs;
    bool m_byGeometry = false;
    gl::Defines m_defines;
    gl::Framebuffer m_framebuffer;
    gl::Renderbuffer m_elements;
    gl::Renderbuffer m_depth;
    int m_width = 0;   ///< of the buffers
    int m_height = 0;  ///< likewise
    PixelArea m_drawn;
    gl::Buffer m_copy;
    std::size_t m_copied = 0;  ///< pixels in m_copy
    std::optional<gl::Fence> m_fence;
};

}  // namespace hitscope
