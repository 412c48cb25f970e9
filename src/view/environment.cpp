// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include "core/srgb.h"

namespace hitscope {
namespace {

/// colour * exp(sharpness * (cosine - 1)): a light without an edge, which blurred is one of its kind again.
struct SoftLight {
    glm::vec3 towards;  ///< unit
    glm::vec3 colour;
    float sharpness;
};

const glm::vec3 kSky(0.34f, 0.39f, 0.47f);
const glm::vec3 kHorizon(0.25f, 0.265f, 0.29f);
const glm::vec3 kGround(0.085f, 0.078f, 0.072f);

const std::array<SoftLight, 3>& softLights() {
    static const std::array<SoftLight, 3> lights{{
        {glm::normalize(glm::vec3(-0.50f, 0.80f, 0.45f)), {5.4f, 5.05f, 4.6f}, 14.0f},
        {glm::normalize(glm::vec3(0.85f, 0.30f, 0.25f)), {0.62f, 0.75f, 0.95f}, 9.0f},
        {glm::normalize(glm::vec3(0.15f, 0.35f, -0.95f)), {2.4f, 2.3f, 2.2f}, 22.0f},
    }};
    return lights;
}

/// The integral of exp(sharpness * (cosine - 1)) over all directions, divided by 2 pi.
float weightOf(float sharpness) {
    return (1.0f - std::exp(-2.0f * sharpness)) / sharpness;
}

/// Of the lobe in which a surface of that roughness reflects (GGX, seen from the front).
float lobeSharpness(float roughness) {
    const float alpha = std::max(roughness * roughness, 0.004f);
    return 0.5f / (alpha * alpha);
}

float smoothstep(float low, float high, float value) {
    const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

constexpr std::size_t kHarmonics = 9;

std::array<float, kHarmonics> harmonics(const glm::vec3& d) {
    return {0.282095f,
            0.488603f * d.y,
            0.488603f * d.z,
            0.488603f * d.x,
            1.092548f * d.x * d.y,
            1.092548f * d.y * d.z,
            0.315392f * (3.0f * d.z * d.z - 1.0f),
            1.092548f * d.x * d.z,
            0.546274f * (d.x * d.x - d.y * d.y)};
}

/// Of the light around, times what the cosine leaves of each order, over pi.
std::array<glm::vec3, kHarmonics> projectLight() {
    constexpr int kDirections = 4096;
    std::array<glm::vec3, kHarmonics> sums{};
    for (int i = 0; i < kDirections; ++i) {
        // Spread evenly, by the golden angle.
        const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / kDirections;
        const float across = std::sqrt(std::max(1.0f - y * y, 0.0f));
        const float turn = 2.3999632f * static_cast<float>(i);
        const glm::vec3 d(across * std::cos(turn), y, across * std::sin(turn));
        const glm::vec3 light = environmentLight(d, 0.0f);
        const std::array<float, kHarmonics> basis = harmonics(d);
        for (std::size_t k = 0; k < kHarmonics; ++k) {
            sums[k] += light * basis[k];
        }
    }
    constexpr std::array<float, kHarmonics> kLeft{1.0f,  2.0f / 3.0f, 2.0f / 3.0f, 2.0f / 3.0f, 0.25f,
                                                  0.25f, 0.25f,       0.25f,       0.25f};
    for (std::size_t k = 0; k < kHarmonics; ++k) {
        sums[k] *= kLeft[k] * 4.0f * glm::pi<float>() / kDirections;
    }
    return sums;
}

/// Of a place in an octahedral map, [-1, 1]^2; a little beyond it the map goes on across its edge.
glm::vec3 directionAt(glm::vec2 at) {
    if (std::abs(at.x) > 1.0f) {
        at = {std::copysign(2.0f - std::abs(at.x), at.x), -at.y};
    }
    if (std::abs(at.y) > 1.0f) {
        at = {-at.x, std::copysign(2.0f - std::abs(at.y), at.y)};
    }
    glm::vec3 d(at.x, 1.0f - std::abs(at.x) - std::abs(at.y), at.y);
    if (d.y < 0.0f) {
        const float x = (1.0f - std::abs(at.y)) * std::copysign(1.0f, at.x);
        const float z = (1.0f - std::abs(at.x)) * std::copysign(1.0f, at.y);
        d = {x, d.y, z};
    }
    return glm::normalize(d);
}

glm::vec3 matcapColour(const glm::vec3& normal) {
    const glm::vec3 base(0.50f, 0.465f, 0.43f);
    const glm::vec3 mirrored = 2.0f * normal.z * normal - glm::vec3(0.0f, 0.0f, 1.0f);
    const float grazing = std::pow(1.0f - normal.z, 4.0f);
    const glm::vec3 light = base * environmentDiffuse(normal) +
                            (0.045f + 0.30f * grazing) * environmentLight(mirrored, 0.42f) +
                            0.025f * environmentLight(mirrored, 0.2f);
    return glm::min(light, glm::vec3(1.0f));
}

}  // namespace

glm::vec3 environmentLight(const glm::vec3& direction, float roughness) {
    const float blur = glm::mix(0.12f, 1.1f, roughness);
    glm::vec3 light = glm::mix(kGround, kHorizon, smoothstep(-blur, 0.35f * blur, direction.y));
    light = glm::mix(light, kSky, smoothstep(0.0f, 1.0f, direction.y) * (1.0f - 0.5f * roughness));
    const float lobe = lobeSharpness(roughness);
    for (const SoftLight& soft : softLights()) {
        const float sharpness = soft.sharpness * lobe / (soft.sharpness + lobe);
        const float strength = weightOf(soft.sharpness) / weightOf(sharpness);
        light += soft.colour * (strength * std::exp(sharpness * (glm::dot(direction, soft.towards) - 1.0f)));
    }
    return light;
}

glm::vec3 environmentDiffuse(const glm::vec3& normal) {
    static const std::array<glm::vec3, kHarmonics> light = projectLight();
    const std::array<float, kHarmonics> basis = harmonics(normal);
    glm::vec3 sum(0.0f);
    for (std::size_t k = 0; k < kHarmonics; ++k) {
        sum += light[k] * basis[k];
    }
    return glm::max(sum, glm::vec3(0.0f));
}

glm::vec3 environmentKeyDirection() {
    return -softLights().front().towards;
}

Lights environmentLights() {
    Lights lights;
    lights.directional.direction = environmentKeyDirection();
    lights.directional.terms = {{1.0f, 0.97f, 0.92f}, 0.45f, 0.75f, 0.45f};
    for (PointLight& light : lights.points) {
        light.on = false;
    }
    lights.spot.on = false;
    return lights;
}

EnvironmentTable makeEnvironmentTable() {
    EnvironmentTable table;
    constexpr int kSide = EnvironmentTable::kSide;
    table.texels.reserve(std::size_t{EnvironmentTable::kLayers} * kSide * kSide);
    for (int layer = 0; layer < EnvironmentTable::kLayers; ++layer) {
        const float roughness =
            static_cast<float>(layer - 1) / static_cast<float>(EnvironmentTable::kRoughnesses - 1);
        for (int row = 0; row < kSide; ++row) {
            for (int column = 0; column < kSide; ++column) {
                const glm::vec2 at(static_cast<float>(column) - 0.5f, static_cast<float>(row) - 0.5f);
                const glm::vec3 d = directionAt(2.0f * at / float{EnvironmentTable::kInner} - 1.0f);
                table.texels.push_back(layer == 0 ? environmentDiffuse(d) : environmentLight(d, roughness));
            }
        }
    }
    return table;
}

Image makeMatcap(int side) {
    Image image{side, side, {}};
    image.pixels.reserve(std::size_t{4} * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            glm::vec2 at =
                (2.0f * glm::vec2(column, side - 1 - row) + 1.0f) / static_cast<float>(side) - 1.0f;
            at /= std::max(1.0f, glm::length(at));
            const float towards = std::sqrt(std::max(1.0f - glm::dot(at, at), 0.0f));
            const glm::vec3 colour = matcapColour(glm::normalize(glm::vec3(at, towards)));
            image.pixels.insert(image.pixels.end(), {srgbByteOfLinear(colour.r), srgbByteOfLinear(colour.g),
                                                     srgbByteOfLinear(colour.b), 255});
        }
    }
    return image;
}

}  // namespace hitscope
