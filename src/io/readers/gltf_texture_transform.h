// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <glm/vec2.hpp>
#include <vector>

namespace hitscope {

/// KHR_texture_transform: where a texture is looked up for the coordinates of a vertex. Scaled first, then
/// turned, then moved.
struct TextureTransform {
    glm::dvec2 scale{1.0};
    double rotation = 0.0;  ///< radians
    glm::dvec2 offset{0.0};

    bool operator==(const TextureTransform&) const = default;
    /// Both as glTF has them: v points down.
    [[nodiscard]] glm::vec2 apply(const glm::vec2& texcoord) const;
};

struct MaterialTransform {
    /// Of the texture that colours the material; without such a one, of its first.
    TextureTransform main;
    bool isMixed = false;  ///< other textures of the material are moved in another way
};

/// One a material, in the file's order; empty for version 1, which knows nothing of it.
[[nodiscard]] std::vector<MaterialTransform> textureTransformsOf(const QJsonObject& root);

}  // namespace hitscope
