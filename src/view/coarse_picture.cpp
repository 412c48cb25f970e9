// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/coarse_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "core/parallel.h"
#include "core/srgb.h"

namespace hitscope {
namespace {

constexpr std::size_t kLeastFaces = 50'000;  // fewer are drawn sooner than a thread starts
constexpr float kAmbient = 0.15f;            // shares of the light: from everywhere,
constexpr float kFromEye = 0.2f;             // from the eye,
constexpr float kFromLight = 0.45f;          // from the light
constexpr float kFar = std::numeric_limits<float>::infinity();

struct Pixel {
    float depth = kFar;
    std::uint8_t colour[3] = {0, 0, 0};  // sRGB
};

struct Corner {
    float x = 0.0f;  // pixels, from the left
    float y = 0.0f;  // pixels, from the top
    float depth = 0.0f;
    bool isInFront = false;
};

/// Draws faces into a picture of its own.
class FacePainter {
public:
    FacePainter(const MeshData& mesh, const Camera& camera, const glm::vec3& light, int width, int height)
        : m_mesh(mesh),
          m_toClip(camera.projection(static_cast<float>(width) / static_cast<float>(height)) * camera.view()),
          m_eye(camera.eye()),
          m_forward(camera.forward()),
          m_light(glm::normalize(light)),
          m_isOrthographic(camera.isOrthographic()),
          m_width(width),
          m_height(height),
          m_pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        for (int i = 0; i < 256; ++i) {
            m_gamma[static_cast<std::size_t>(i)] = srgbByteOfLinear(static_cast<float>(i) / 255.0f);
        }
    }

    void paint(std::size_t firstFace, std::size_t endFace) {
        for (std::size_t f = firstFace; f < endFace; ++f) {
            paintFace(f);
        }
    }
    [[nodiscard]] const std::vector<Pixel>& pixels() const { return m_pixels; }

private:
    [[nodiscard]] Corner cornerAt(const glm::vec3& position) const {
        const glm::vec4 clip = m_toClip * glm::vec4(position, 1.0f);
        if (!(clip.w > 0.0f)) {
            return {};
        }
        return {0.5f * (clip.x / clip.w + 1.0f) * static_cast<float>(m_width),
                0.5f * (1.0f - clip.y / clip.w) * static_cast<float>(m_height), clip.z / clip.w, true};
    }
    void paintFace(std::size_t face);
    void paintTriangle(const Corner& a, const Corner& b, const Corner& c);
    /// The face's colour in `m_shade`.
    void shade(std::size_t face, std::span<const std::uint32_t> vertices);

    const MeshData& m_mesh;
    glm::mat4 m_toClip;
    glm::vec3 m_eye;
    glm::vec3 m_forward;
    glm::vec3 m_light;
    bool m_isOrthographic;
    int m_width;
    int m_height;
    std::vector<Pixel> m_pixels;
    std::array<std::uint8_t, 256> m_gamma{};
    std::uint8_t m_shade[3] = {0, 0, 0};
};

void FacePainter::shade(std::size_t face, std::span<const std::uint32_t> vertices) {
    const glm::vec3& a = m_mesh.positions[vertices[0]];
    const glm::vec3& b = m_mesh.positions[vertices[1]];
    const glm::vec3& c = m_mesh.positions[vertices[2]];
    const glm::vec3 across = glm::cross(b - a, c - a);
    const glm::vec3 sight = m_isOrthographic ? m_forward : a - m_eye;
    const float lengths = glm::length(across) * glm::length(sight);
    float light = kAmbient + kFromEye;
    if (lengths > 0.0f) {
        const float facing = glm::dot(across, sight) / lengths;
        // Of the side that is seen.
        const glm::vec3 outwards = across * ((facing > 0.0f ? -1.0f : 1.0f) / glm::length(across));
        light = kAmbient + kFromEye * std::abs(facing) +
                kFromLight * std::max(0.0f, -glm::dot(outwards, m_light));
    }
    glm::vec3 colour = Material().diffuse;
    if (!m_mesh.faceMaterials.empty() && m_mesh.faceMaterials[face] != kNoIndex) {
        colour = m_mesh.materials[m_mesh.faceMaterials[face]].diffuse;
    }
    for (int i = 0; i < 3; ++i) {
        const float linear = std::clamp(colour[i] * light, 0.0f, 1.0f);
        m_shade[i] = m_gamma[static_cast<std::size_t>(255.0f * linear)];
    }
}

void FacePainter::paintFace(std::size_t face) {
    const std::span<const std::uint32_t> vertices = m_mesh.face(face);
    const Corner first = cornerAt(m_mesh.positions[vertices[0]]);
    Corner previous = cornerAt(m_mesh.positions[vertices[1]]);
    shade(face, vertices);
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        const Corner next = cornerAt(m_mesh.positions[vertices[i]]);
        if (first.isInFront && previous.isInFront && next.isInFront) {
            paintTriangle(first, previous, next);
        }
        previous = next;
    }
}

/// Of all pixels whose middle is within.
void FacePainter::paintTriangle(const Corner& a, const Corner& b, const Corner& c) {
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    if (!(right >= 0.0f && bottom >= 0.0f && left <= static_cast<float>(m_width) &&
          top <= static_cast<float>(m_height))) {
        return;
    }
    const int firstX = static_cast<int>(std::ceil(std::max(left, 0.5f) - 0.5f));
    const int lastX = static_cast<int>(std::floor(std::min(right, static_cast<float>(m_width)) - 0.5f));
    const int firstY = static_cast<int>(std::ceil(std::max(top, 0.5f) - 0.5f));
    const int lastY = static_cast<int>(std::floor(std::min(bottom, static_cast<float>(m_height)) - 0.5f));
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (firstX > lastX || firstY > lastY || area == 0.0f) {
        return;
    }
    const float toShare = 1.0f / area;
    for (int y = firstY; y <= lastY; ++y) {
        for (int x = firstX; x <= lastX; ++x) {
            const float px = static_cast<float>(x) + 0.5f;
            const float py = static_cast<float>(y) + 0.5f;
            const float ofC = toShare * ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x));
            const float ofB = toShare * ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x));
            const float ofA = 1.0f - ofB - ofC;
            if (!(ofA >= 0.0f && ofB >= 0.0f && ofC >= 0.0f)) {
                continue;
            }
            const float depth = ofA * a.depth + ofB * b.depth + ofC * c.depth;
            Pixel& pixel = m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                                    static_cast<std::size_t>(x)];
            if (depth < pixel.depth) {
                pixel.depth = depth;
                std::copy_n(m_shade, 3, pixel.colour);
            }
        }
    }
}

}  // namespace

Image drawCoarsely(const MeshData& mesh, const Camera& camera, const glm::vec3& light, int width,
                   int height) {
    const std::size_t faces = mesh.faceCount();
    const std::size_t parts = std::clamp<std::size_t>(faces / kLeastFaces, 1, usefulThreads());
    std::vector<FacePainter> painters(parts, FacePainter(mesh, camera, light, width, height));
    forEachAtOnce(parts, [&](std::size_t part) {
        painters[part].paint(faces * part / parts, faces * (part + 1) / parts);
    });
    Image image;
    image.width = width;
    image.height = height;
    image.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; 4 * i < image.pixels.size(); ++i) {
        const Pixel* nearest = &painters[0].pixels()[i];
        for (std::size_t part = 1; part < parts; ++part) {
            // Where two are as near, that of the earlier face stays, as on one processor.
            const Pixel& pixel = painters[part].pixels()[i];
            nearest = pixel.depth < nearest->depth ? &pixel : nearest;
        }
        if (nearest->depth < kFar) {
            std::copy_n(nearest->colour, 3, &image.pixels[4 * i]);
            image.pixels[4 * i + 3] = 255;
        }
    }
    return image;
}

}  // namespace hitscope
