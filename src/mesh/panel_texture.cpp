// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/panel_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <thread>
#include <vector>

namespace hitscope {

namespace {

constexpr int kRows = 4;           // of panels
constexpr float kSeam = 0.0035f;   // half the width of the gap between panels; lengths are of the picture
constexpr float kBevel = 0.007f;   // from the seam to where a panel is flat
constexpr float kRivet = 0.0055f;  // radius
constexpr float kRivetFromEdge = 0.022f;  // of its middle
constexpr float kWearReach = 0.06f;       // from an edge, where paint chips more easily

// sRGB, [0, 1].
constexpr std::array<glm::vec3, 4> kPaints = {
    {{0.42f, 0.50f, 0.55f}, {0.60f, 0.59f, 0.55f}, {0.66f, 0.47f, 0.24f}, {0.36f, 0.43f, 0.40f}}};
constexpr glm::vec3 kMetal(0.55f, 0.55f, 0.56f);
constexpr glm::vec3 kPrimer(0.47f, 0.30f, 0.22f);
constexpr glm::vec3 kRust(0.38f, 0.21f, 0.12f);

/// [0, 1)
float hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) * (1.0f / 16777216.0f);
}

/// Value noise over [0, 1)^2 with this many cells each way, which closes at the edges.
float noise(glm::vec2 at, std::uint32_t across, std::uint32_t up, std::uint32_t seed) {
    const glm::vec2 scaled = at * glm::vec2(across, up);
    const glm::vec2 cell = glm::floor(scaled);
    const glm::vec2 f = scaled - cell;
    const glm::vec2 s = f * f * (3.0f - 2.0f * f);
    const auto x = static_cast<std::uint32_t>(cell.x) % across;
    const auto y = static_cast<std::uint32_t>(cell.y) % up;
    const std::uint32_t nextX = (x + 1) % across;
    const std::uint32_t nextY = (y + 1) % up;
    return glm::mix(glm::mix(hash(x, y, seed), hash(nextX, y, seed), s.x),
                    glm::mix(hash(x, nextY, seed), hash(nextX, nextY, seed), s.x), s.y);
}

/// Octaves of noise, each twice as fine and half as strong; [0, 1).
float clouds(glm::vec2 at, std::uint32_t cells, int octaves, std::uint32_t seed) {
    float sum = 0.0f;
    float weight = 0.5f;
    for (int octave = 0; octave < octaves; ++octave) {
        sum +=
            weight * noise(at, cells << octave, cells << octave, seed + static_cast<std::uint32_t>(octave));
        weight *= 0.5f;
    }
    return sum / (1.0f - 2.0f * weight);
}

float ramp(float from, float to, float value) {
    const float t = std::clamp((value - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// Where a point is on its panel.
struct Spot {
    std::uint32_t panel = 0;  ///< its number
    glm::vec2 nearest{0.0f};  ///< to the nearest upright and the nearest level edge
    glm::vec2 towards{0.0f};  ///< -1: that edge is on the left or above; 1: on the right or below
    [[nodiscard]] float edge() const { return std::min(nearest.x, nearest.y); }
};

/// Rows of panels of uneven width; the first of a row begins anywhere, so that no seam goes right across.
class Panels {
public:
    explicit Panels(std::uint32_t seed) {
        for (std::uint32_t row = 0; row < kRows; ++row) {
            std::vector<float>& starts = m_starts[row];
            float x = hash(row, 0, seed) * 0.3f;
            const float first = x;
            for (std::uint32_t i = 1; x < first + 0.8f; ++i) {
                starts.push_back(x);
                x += 0.2f + 0.25f * hash(row, i, seed);
            }
        }
    }

    [[nodiscard]] Spot at(glm::vec2 point) const {
        const float y = point.y * kRows;
        const auto row = std::min(static_cast<std::size_t>(y), std::size_t{kRows - 1});
        const std::vector<float>& starts = m_starts[row];
        // The last panel of a row goes on over the edge to where the first begins.
        const float x = point.x < starts.front() ? point.x + 1.0f : point.x;
        const auto next = std::upper_bound(starts.begin(), starts.end(), x);
        const float left = x - *(next - 1);
        const float right = (next == starts.end() ? starts.front() + 1.0f : *next) - x;
        const float above = (y - static_cast<float>(row)) / kRows;
        const float below = 1.0f / kRows - above;
        Spot spot;
        spot.panel = static_cast<std::uint32_t>(row) * 16 + static_cast<std::uint32_t>(next - starts.begin());
        spot.nearest = {std::min(left, right), std::min(above, below)};
        spot.towards = {left < right ? -1.0f : 1.0f, above < below ? -1.0f : 1.0f};
        return spot;
    }

private:
    std::array<std::vector<float>, kRows> m_starts;
};

class Painter {
public:
    Painter(int size, std::uint32_t seed) : m_size(size), m_seed(seed * 7919u), m_panels(m_seed) {}

    [[nodiscard]] glm::vec3 colour(int column, int row) const {
        const glm::vec2 at = (glm::vec2(column, row) + 0.5f) / static_cast<float>(m_size);
        const Spot spot = m_panels.at(at);
        const float grain = hash(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), m_seed);
        // Brushed along x: fine across, long along.
        const float brushed = noise(at, 24, 512, m_seed + 40);
        const glm::vec3 surface = worn(at, spot, brushed);
        const float light = 1.0f + 0.10f * (brushed - 0.5f) + 0.09f * (grain - 0.5f) + relief(spot);
        return surface * light * (1.0f - 0.75f * (1.0f - ramp(0.5f * kSeam, kSeam, spot.edge())));
    }

private:
    /// Paint, or what is under it where it has come off.
    [[nodiscard]] glm::vec3 worn(glm::vec2 at, const Spot& spot, float brushed) const {
        const float tone = clouds(at, 6, 3, m_seed + 10);
        const float chips = clouds(at, 20, 4, m_seed + 20);
        const float own = hash(spot.panel, 1, m_seed);
        const glm::vec3 paint =
            kPaints[static_cast<std::size_t>(hash(spot.panel, 0, m_seed) * kPaints.size())];
        glm::vec3 colour = paint * (0.82f + 0.14f * own + 0.20f * (tone - 0.5f) * 2.0f);
        // Streaks of dirt that run down.
        const float streaks = noise(at, 96, 3, m_seed + 30) * clouds(at, 5, 2, m_seed + 35);
        colour *= 1.0f - 0.35f * ramp(0.30f, 0.62f, streaks);
        const float ease = 0.17f * (1.0f - ramp(0.0f, kWearReach, spot.edge())) + 0.05f * own;
        const float bare = chips + ease;
        colour = glm::mix(colour, kPrimer, ramp(0.700f, 0.715f, bare));
        colour = glm::mix(colour, kMetal * (0.86f + 0.28f * brushed), ramp(0.730f, 0.745f, bare));
        return glm::mix(colour, kRust, 0.75f * ramp(0.55f, 0.75f, tone) * ramp(0.74f, 0.82f, bare));
    }

    /// Light from above left, on bevels and rivets.
    [[nodiscard]] static float relief(const Spot& spot) {
        const auto slope = [](float distance) { return 1.0f - ramp(kSeam, kSeam + kBevel, distance); };
        float light =
            -0.22f * (slope(spot.nearest.x) * spot.towards.x + slope(spot.nearest.y) * spot.towards.y);
        const glm::vec2 fromRivet = spot.nearest - glm::vec2(kRivetFromEdge);
        const float away = glm::length(fromRivet) / kRivet;
        if (away < 1.6f) {
            const glm::vec2 outwards = -fromRivet * -spot.towards / (kRivet * std::max(away, 0.3f));
            const float head = 1.0f - ramp(0.85f, 1.0f, away);
            light += head * (0.10f - 0.30f * away * 0.7071f * (outwards.x + outwards.y));
            light -= 0.30f * ramp(0.85f, 1.0f, away) * (1.0f - ramp(1.0f, 1.6f, away));
        }
        return light;
    }

    int m_size;
    std::uint32_t m_seed;
    Panels m_panels;
};

void paintRows(Image& image, const Painter& painter, int first, int last) {
    for (int row = first; row < last; ++row) {
        auto* pixel = image.pixels.data() +
                      std::size_t{4} * static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width);
        for (int column = 0; column < image.width; ++column, pixel += 4) {
            const glm::vec3 colour = glm::clamp(painter.colour(column, row), 0.0f, 1.0f) * 255.0f + 0.5f;
            pixel[0] = static_cast<std::uint8_t>(colour.r);
            pixel[1] = static_cast<std::uint8_t>(colour.g);
            pixel[2] = static_cast<std::uint8_t>(colour.b);
            pixel[3] = 255;
        }
    }
}

}  // namespace

Image makePanelTexture(int size, std::uint32_t seed) {
    Image image;
    image.width = size;
    image.height = size;
    image.pixels.resize(std::size_t{4} * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const Painter painter(size, seed);
    const int parts = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
    std::vector<std::thread> threads;
    for (int part = 0; part < parts; ++part) {
        threads.emplace_back(paintRows, std::ref(image), std::cref(painter), size * part / parts,
                             size * (part + 1) / parts);
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    return image;
}

}  // namespace hitscope
