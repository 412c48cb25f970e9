// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/objects.h"
#include "gl/program.h"
#include "render/renderer.h"

namespace hitscope::render {

/// Whether surfaces are lit by the studio of view/environment.h: around the scene, or in a matcap.
[[nodiscard]] bool isStudioWanted(const Frame& frame);
/// What their programs are built with then.
[[nodiscard]] gl::Defines studioDefines(const Frame& frame);

/// The studio's tables as textures, each made when it is first used. A context is current for every call and
/// the destructor.
class Studio {
public:
    /// Makes what this frame needs.
    void prepare(const Frame& frame);
    /// Sets the uniforms of environment.glsl or matcap.glsl and binds its table; the program is in use.
    void apply(const gl::Program& program, const Frame& frame) const;

    static constexpr int kUnit = 5;

private:
    gl::Texture m_environment;
    gl::Texture m_matcap;
};

}  // namespace hitscope::render
