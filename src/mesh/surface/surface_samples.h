// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <random>
#include <span>
#include <vector>

namespace hitscope {

/// Random numbers that are the same on every machine: the engine is the standard's (mt19937_64), and what is
/// made of its numbers is done here, since the standard's distributions differ between libraries.
class RepeatableRandom {
public:
    explicit RepeatableRandom(std::uint64_t seed) : m_engine(seed) {}
    /// In [0, 1), evenly; 53 bits.
    [[nodiscard]] double next();

private:
    std::mt19937_64 m_engine;
};

/// A place on a surface.
struct SurfaceSample {
    std::uint32_t triangle = 0;          ///< its number among all
    double weights[3] = {};              ///< of the triangle's corners; their sum is 1
    glm::vec3 point{0.0f};               ///< metres
    glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< unit, of the triangle
};

/// Triangles of a surface: three indices of positions (metres) each.
struct SurfaceView {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> triangles;
    std::span<const std::uint32_t> chosen;  ///< numbers of those that count, ascending
};

/// Square metres.
[[nodiscard]] double surfaceArea(const SurfaceView& surface);

/// Asked now and then with how much is done, in [0, 1]; false: it is not wanted any more.
using GoOn = std::function<bool(double)>;

/// How many candidates there are for each sample that is kept: more make the spacing more even.
inline constexpr std::size_t kCandidatesPerSample = 6;

/// `count` places spread over the surface as blue noise: candidates are drawn evenly by area, and of them the
/// most crowded are eliminated until `count` are left (C. Yuksel, Sample Elimination for Generating Poisson
/// Disk Sample Sets, Computer Graphics Forum 34, 2015). Places on two sides of a thin wall do not crowd each
/// other. The same seed gives the same places, in every bit, on every machine. Empty where the surface has no
/// area, or goOn said so.
[[nodiscard]] std::vector<SurfaceSample> sampleSurface(const SurfaceView& surface, std::size_t count,
                                                       std::uint64_t seed, const GoOn& goOn = {});

/// Metres: the greatest that the least distance between so many samples of so much area can be, as if it were
/// flat. Samples of sampleSurface() are rarely nearer to each other than six tenths of it.
[[nodiscard]] double widestSpacing(double area, std::size_t count);

}  // namespace hitscope
