// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/histogram.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Least, greatest and sum of some numbers.
struct Spread {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
    double sum = 0.0;
    std::size_t count = 0;

    void add(double value);
    void add(const Spread& other);
    /// Of numbers that are `factor` times as large. factor > 0.
    [[nodiscard]] Spread times(double factor) const {
        return {least * factor, greatest * factor, sum * factor, count};
    }
    [[nodiscard]] double mean() const { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
    bool operator==(const Spread&) const = default;
};

/// Axis-aligned box in double; empty until something is added.
struct Box {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const { return min.x > max.x; }
    void add(const glm::dvec3& point);
    void add(const Box& other);
    [[nodiscard]] glm::dvec3 size() const { return empty() ? glm::dvec3(0.0) : max - min; }
    bool operator==(const Box&) const = default;
};

/// What a surface measures with its vertices where they are. All sums are in double.
struct SurfaceMeasures {
    Box box;            ///< metres, of all vertices
    Spread edgeLength;  ///< metres
    Spread faceArea;    ///< square metres; the sum is the surface's area
    Spread aspect;      ///< of the faces that are not degenerate; see FaceMeasure
    std::size_t degenerateFaces = 0;
    std::size_t flippedFaces = 0;  ///< look the other way than they did in the original
    double signedVolume = 0.0;     ///< cubic metres; < 0 where the faces look inwards
    glm::dvec3 volumeMoment{0.0};  ///< signedVolume times the centre of mass, metres from the origin
    bool operator==(const SurfaceMeasures&) const = default;

    void add(const SurfaceMeasures& other);
    /// The same in the coordinates of the mesh's file; these are in the local frame.
    [[nodiscard]] SurfaceMeasures inFile(const Placement& placement) const;
    /// Of the enclosed solid of even density; meaningful only if it is watertight.
    [[nodiscard]] double volume() const { return signedVolume < 0.0 ? -signedVolume : signedVolume; }
    [[nodiscard]] glm::dvec3 centreOfMass() const { return volumeMoment / signedVolume; }
};

/// How far vertices have been moved: the changed ones only, the least moved first.
struct Displacements {
    std::vector<float> lengths;           ///< metres, > 0, ascending
    std::vector<std::uint32_t> vertices;  ///< file vertex of each

    struct Summary {
        Spread length;                   ///< metres
        double median = 0.0;             ///< metres
        double rootMeanSquare = 0.0;     ///< metres
        double standardDeviation = 0.0;  ///< metres, of the changed vertices as the whole population
        bool operator==(const Summary&) const = default;
    };
    /// The file vertices displaced by at least `least` and at most `most` metres.
    [[nodiscard]] std::span<const std::uint32_t> within(double least, double most) const;
};

/// Of all these lists together.
[[nodiscard]] Displacements::Summary summarise(std::span<const Displacements* const> lists);

/// Of the lengths of all these lists, in equal parts of [0, most]; empty for most = 0.
[[nodiscard]] Histogram histogramOf(std::span<const Displacements* const> lists, double most,
                                    std::size_t bins);

}  // namespace hitscope
