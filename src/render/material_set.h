// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "gl/program.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// See renderer.h.
class MaterialSet {
public:
    /// Without materials: every index gives the default one.
    MaterialSet() = default;
    /// Uploads the textures that materials refer to, with mipmaps: those of colours as sRGB, others as they
    /// are. Larger ones than the driver has are halved until they fit.
    explicit MaterialSet(const MeshData& mesh);

    /// `texture` on everything, whatever the index.
    explicit MaterialSet(const Image& texture);
    /// This material, which has no texture, on everything.
    explicit MaterialSet(const Material& material);

    /// Sets the uniforms of surface.frag and, where the material has them, binds its texture to unit 0 and
    /// its other maps to the units below; the program is in use. kNoIndex and indices out of range are the
    /// default material, which is white where vertices have colours. sampler: how they are read; 0: as was
    /// set with the texture.
    void apply(const gl::Program& program, std::uint32_t material, bool coloured, GLuint sampler) const;
    [[nodiscard]] bool isTextured(std::uint32_t material) const;
    [[nodiscard]] bool hasNormalMap(std::uint32_t material) const;
    /// Whether what lies behind is to be seen.
    [[nodiscard]] bool isTranslucent(std::uint32_t material) const;
    /// Whether metalness and roughness say how it reflects.
    [[nodiscard]] bool hasMetalRoughness(std::uint32_t material) const;
    [[nodiscard]] bool hasMetalRoughnessMap(std::uint32_t material) const;
    /// Whether a texture of the person's choice takes the place of the mesh's own materials.
    [[nodiscard]] bool isCover() const { return m_covers; }

    static constexpr int kMetalRoughnessUnit = 2;
    static constexpr int kNormalMapUnit = 3;

private:
    [[nodiscard]] const Material& at(std::uint32_t material) const;
    void bindPlain(int unit, int image, GLuint sampler) const;

    std::vector<Material> m_materials;
    bool m_covers = false;  ///< the first one, whatever the index
    // One an image; without name where it is not used so.
    std::vector<gl::Texture> m_textures;
    std::vector<gl::Texture> m_plainTextures;  ///< normal maps, metalness and roughness
};

}  // namespace hitscope
