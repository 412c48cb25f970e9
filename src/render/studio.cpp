// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/studio.h"

#include "view/environment.h"

namespace hitscope::render {
namespace {

constexpr int kMatcapSide = 256;  // pixels

void bindToUnit(GLenum kind, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + Studio::kUnit);
    glBindSampler(Studio::kUnit, 0);
    glBindTexture(kind, texture);
    glActiveTexture(GL_TEXTURE0);
}

void setClamped(GLenum kind) {
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(kind, side, GL_CLAMP_TO_EDGE);
    }
}

gl::Texture makeEnvironment() {
    const EnvironmentTable table = makeEnvironmentTable();
    gl::Texture texture = gl::Texture::make();
    bindToUnit(GL_TEXTURE_3D, texture.id());
    glActiveTexture(GL_TEXTURE0 + Studio::kUnit);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB16F, EnvironmentTable::kSide, EnvironmentTable::kSide,
                 EnvironmentTable::kLayers, 0, GL_RGB, GL_FLOAT, table.texels.data());
    setClamped(GL_TEXTURE_3D);
    glActiveTexture(GL_TEXTURE0);
    return texture;
}

gl::Texture uploadMatcap() {
    const Image image = makeMatcap(kMatcapSide);
    gl::Texture texture = gl::Texture::make();
    bindToUnit(GL_TEXTURE_2D, texture.id());
    glActiveTexture(GL_TEXTURE0 + Studio::kUnit);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.pixels.data());
    setClamped(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE0);
    return texture;
}

}  // namespace

bool isStudioWanted(const Frame& frame) {
    return !frame.change && (frame.options.environment || frame.options.look == SurfaceLook::Matcap);
}

gl::Defines studioDefines(const Frame& frame) {
    return {{frame.options.look == SurfaceLook::Matcap ? "HITSCOPE_MATCAP" : "HITSCOPE_ENVIRONMENT", "1"}};
}

void Studio::prepare(const Frame& frame) {
    if (frame.options.look == SurfaceLook::Matcap) {
        if (!m_matcap) {
            m_matcap = uploadMatcap();
        }
    } else if (!m_environment) {
        m_environment = makeEnvironment();
    }
}

void Studio::apply(const gl::Program& program, const Frame& frame) const {
    if (frame.options.look == SurfaceLook::Matcap) {
        program.set("u_matcap", kUnit);
        program.set("u_up", frame.camera.up());
        bindToUnit(GL_TEXTURE_2D, m_matcap.id());
    } else {
        program.set("u_environment", kUnit);
        program.set("u_keyLight", -environmentKeyDirection());
        bindToUnit(GL_TEXTURE_3D, m_environment.id());
    }
}

}  // namespace hitscope::render
