// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/material_set.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gl/context.h"

namespace hitscope {
namespace {

constexpr float kLeastOpacity = 0.15f;  // a target that cannot be seen cannot be aimed at
constexpr float kMostAnisotropy = 8.0f;

Material makeDefaultMaterial() {
    Material clay;
    clay.diffuse = glm::vec3(0.47f, 0.435f, 0.40f);
    clay.specular = glm::vec3(0.30f);
    clay.shininess = 40.0f;
    return clay;
}

/// Half the size in both directions; the mean of four 8-bit values, which is near enough for a fallback.
Image halved(const Image& image) {
    Image half;
    half.width = std::max(1, image.width / 2);
    half.height = std::max(1, image.height / 2);
    half.pixels.resize(std::size_t{4} * half.width * half.height);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const std::array<int, 2> xs{2 * x, std::min(2 * x + 1, image.width - 1)};
            const std::array<int, 2> ys{2 * y, std::min(2 * y + 1, image.height - 1)};
            for (int channel = 0; channel < 4; ++channel) {
                int sum = 0;
                for (const int sourceY : ys) {
                    for (const int sourceX : xs) {
                        sum += image.pixels[std::size_t{4} * (std::size_t(sourceY) * image.width + sourceX) +
                                            channel];
                    }
                }
                half.pixels[std::size_t{4} * (std::size_t(y) * half.width + x) + channel] =
                    static_cast<std::uint8_t>((sum + 2) / 4);
            }
        }
    }
    return half;
}

bool isUsable(const Image& image) {
    return image.width > 0 && image.height > 0 &&
           image.pixels.size() == std::size_t{4} * image.width * image.height;
}

/// Not where the CPU draws: there it takes as long as all else, and llvmpipe (Mesa 22.3) goes through as many
/// texels as the derivatives say, which are without bounds where the edge of a triangle is seen from aside.
void setAnisotropy() {
    if (gl::rendererInfo().isSoftware()) {
        return;
    }
    if (!epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") &&
        !epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic")) {
        return;
    }
    GLfloat most = 1.0f;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(most, kMostAnisotropy));
}

/// Rows are read as they lie in an Image, whatever the caller's unpack state was.
class PlainUnpacking {
public:
    PlainUnpacking() {
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            glGetIntegerv(kNames[i], &m_values[i]);
            glPixelStorei(kNames[i], kNames[i] == GL_UNPACK_ALIGNMENT ? 4 : 0);
        }
        glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &m_buffer);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_texture);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    }
    ~PlainUnpacking() {
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            glPixelStorei(kNames[i], m_values[i]);
        }
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(m_buffer));
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(m_texture));
    }
    PlainUnpacking(const PlainUnpacking&) = delete;
    PlainUnpacking& operator=(const PlainUnpacking&) = delete;

private:
    static constexpr std::array<GLenum, 4> kNames{GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH,
                                                  GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS};
    std::array<GLint, 4> m_values{};
    GLint m_buffer = 0;
    GLint m_texture = 0;
};

gl::Texture upload(const Image& original, GLint format) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    Image smaller;
    const Image* image = &original;
    while (most > 0 && std::max(image->width, image->height) > most) {
        smaller = halved(*image);
        image = &smaller;
    }
    gl::Texture texture = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, format, image->width, image->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image->pixels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    setAnisotropy();
    return texture;
}

}  // namespace

MaterialSet::MaterialSet(const MeshData& mesh) : m_materials(mesh.materials) {
    m_textures.resize(mesh.images.size());
    m_plainTextures.resize(mesh.images.size());
    const PlainUnpacking plain;
    const auto take = [&mesh](int& index, std::vector<gl::Texture>& textures, GLint format) {
        const auto image = static_cast<std::size_t>(std::max(index, 0));
        if (index < 0 || image >= mesh.images.size() || !isUsable(mesh.images[image])) {
            index = -1;
        } else if (!textures[image]) {
            textures[image] = upload(mesh.images[image], format);
        }
    };
    for (Material& material : m_materials) {
        take(material.diffuseImage, m_textures, GL_SRGB8_ALPHA8);
        take(material.normalMap.image, m_plainTextures, GL_RGBA8);
        take(material.metalRoughness.image, m_plainTextures, GL_RGBA8);
    }
}

MaterialSet::MaterialSet(const Image& texture) : m_covers(true) {
    Material material;
    material.diffuse = glm::vec3(1.0f);
    material.specular = glm::vec3(0.35f);
    material.shininess = 48.0f;
    if (isUsable(texture)) {
        const PlainUnpacking plain;
        material.diffuseImage = 0;
        m_textures.push_back(upload(texture, GL_SRGB8_ALPHA8));
    }
    m_materials.push_back(std::move(material));
}

MaterialSet::MaterialSet(const Material& material) : m_materials{material}, m_covers(true) {}

const Material& MaterialSet::at(std::uint32_t material) const {
    if (m_covers) {
        return m_materials.front();
    }
    static const Material defaultMaterial = makeDefaultMaterial();
    return material < m_materials.size() ? m_materials[material] : defaultMaterial;
}

bool MaterialSet::isTranslucent(std::uint32_t material) const {
    return at(material).opacity < 0.999f;
}

bool MaterialSet::isTextured(std::uint32_t material) const {
    return at(material).diffuseImage >= 0;
}

bool MaterialSet::hasNormalMap(std::uint32_t material) const {
    return at(material).normalMap.image >= 0;
}

bool MaterialSet::hasMetalRoughness(std::uint32_t material) const {
    return at(material).metalRoughness.isGiven();
}

bool MaterialSet::hasMetalRoughnessMap(std::uint32_t material) const {
    return hasMetalRoughness(material) && at(material).metalRoughness.image >= 0;
}

void MaterialSet::bindPlain(int unit, int image, GLuint sampler) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindSampler(static_cast<GLuint>(unit), sampler);
    glBindTexture(GL_TEXTURE_2D, m_plainTextures[static_cast<std::size_t>(image)].id());
    glActiveTexture(GL_TEXTURE0);
}

void MaterialSet::apply(const gl::Program& program, std::uint32_t material, bool coloured,
                        GLuint sampler) const {
    const Material& surface = at(material);
    const bool isDefault = !m_covers && material >= m_materials.size();
    program.set("u_diffuse", coloured && isDefault ? glm::vec3(1.0f) : surface.diffuse);
    program.set("u_specular", surface.specular);
    // pow(x, 0) is one everywhere: a file's exponent of zero would make the whole lit side shine.
    program.set("u_shininess", std::isfinite(surface.shininess) ? std::max(surface.shininess, 1.0f) : 32.0f);
    program.set("u_opacity", std::clamp(surface.opacity, kLeastOpacity, 1.0f));
    if (surface.diffuseImage >= 0) {
        program.set("u_texture", 0);
        glBindSampler(0, sampler);
        glBindTexture(GL_TEXTURE_2D, m_textures[static_cast<std::size_t>(surface.diffuseImage)].id());
    }
    if (const NormalMap& map = surface.normalMap; map.image >= 0) {
        program.set("u_normalMap", kNormalMapUnit);
        program.set("u_normalStrength", map.strength);
        bindPlain(kNormalMapUnit, map.image, sampler);
    }
    if (const MetalRoughness& metal = surface.metalRoughness; metal.isGiven()) {
        program.set("u_metalRoughness", glm::vec2(metal.metalness, metal.roughness));
        if (metal.image >= 0) {
            program.set("u_metalRoughnessMap", kMetalRoughnessUnit);
            bindPlain(kMetalRoughnessUnit, metal.image, sampler);
        }
    }
}

}  // namespace hitscope
