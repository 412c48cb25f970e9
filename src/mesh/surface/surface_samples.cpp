// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <queue>
#include <utility>

namespace hitscope {

namespace {

struct SampledTriangle {
    glm::dvec3 corners[3];
    glm::dvec3 areaVector;  ///< as long as the area, outwards
};

SampledTriangle triangleAt(const SurfaceView& surface, std::uint32_t number) {
    SampledTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.corners[i] = glm::dvec3(surface.positions[surface.triangles[std::size_t{3} * number + i]]);
    }
    triangle.areaVector = 0.5 * glm::cross(triangle.corners[1] - triangle.corners[0],
                                           triangle.corners[2] - triangle.corners[0]);
    return triangle;
}

/// Area up to and with each of the chosen triangles.
std::vector<double> areasUpTo(const SurfaceView& surface) {
    std::vector<double> upTo;
    upTo.reserve(surface.chosen.size());
    double sum = 0.0;
    for (const std::uint32_t number : surface.chosen) {
        sum += glm::length(triangleAt(surface, number).areaVector);
        upTo.push_back(sum);
    }
    return upTo;
}

SurfaceSample sampleOf(const SurfaceView& surface, std::uint32_t number, double u, double v) {
    const SampledTriangle triangle = triangleAt(surface, number);
    const double root = std::sqrt(u);
    SurfaceSample sample;
    sample.triangle = number;
    sample.weights[0] = 1.0 - root;
    sample.weights[1] = root * (1.0 - v);
    sample.weights[2] = root * v;
    sample.point =
        glm::vec3(sample.weights[0] * triangle.corners[0] + sample.weights[1] * triangle.corners[1] +
                  sample.weights[2] * triangle.corners[2]);
    sample.normal = glm::vec3(triangle.areaVector / glm::length(triangle.areaVector));
    return sample;
}

std::vector<SurfaceSample> candidatesOf(const SurfaceView& surface, std::span<const double> areas,
                                        std::size_t count, std::uint64_t seed) {
    RepeatableRandom random(seed);
    std::vector<SurfaceSample> candidates;
    candidates.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double at = random.next() * areas.back();
        // The first that ends beyond: never one without area.
        auto found = std::upper_bound(areas.begin(), areas.end(), at);
        found = found == areas.end() ? std::lower_bound(areas.begin(), areas.end(), areas.back()) : found;
        const double u = random.next();
        const double v = random.next();
        candidates.push_back(
            sampleOf(surface, surface.chosen[static_cast<std::size_t>(found - areas.begin())], u, v));
    }
    return candidates;
}

/// Finds the candidates near one.
class Neighbours {
public:
    Neighbours(std::span<const SurfaceSample> samples, double reach) : m_samples(samples), m_reach(reach) {
        m_cells.reserve(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            m_cells.push_back({cellOf(samples[i].point), static_cast<std::uint32_t>(i)});
        }
        std::sort(m_cells.begin(), m_cells.end());
    }

    /// Calls found(index, distance) for each other that is nearer than the reach, on the same side.
    template <class Found>
    void of(std::size_t index, const Found& found) const {
        const SurfaceSample& sample = m_samples[index];
        const Cell middle = cellOf(sample.point);
        for (std::int64_t x = middle[0] - 1; x <= middle[0] + 1; ++x) {
            for (std::int64_t y = middle[1] - 1; y <= middle[1] + 1; ++y) {
                const Entry first{{x, y, middle[2] - 1}, 0};
                auto at = std::lower_bound(m_cells.begin(), m_cells.end(), first);
                for (; at != m_cells.end() && at->first <= Cell{x, y, middle[2] + 1}; ++at) {
                    const SurfaceSample& other = m_samples[at->second];
                    const double distance = glm::distance(glm::dvec3(sample.point), glm::dvec3(other.point));
                    if (at->second != index && distance < m_reach &&
                        glm::dot(sample.normal, other.normal) > 0.0f) {
                        found(at->second, distance);
                    }
                }
            }
        }
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    using Entry = std::pair<Cell, std::uint32_t>;

    [[nodiscard]] Cell cellOf(const glm::vec3& point) const {
        const auto along = [this](float value) {
            return static_cast<std::int64_t>(std::floor(static_cast<double>(value) / m_reach));
        };
        return {along(point.x), along(point.y), along(point.z)};
    }

    std::span<const SurfaceSample> m_samples;
    double m_reach;
    std::vector<Entry> m_cells;
};

/// How much a neighbour at that share of the reach crowds: Yuksel's weight, his alpha being 8. Very near ones
/// count as if they were a little farther off, by which spacings become more even (his beta and gamma).
double crowding(double share, double least) {
    const double once = 1.0 - std::max(share, least);
    const double twice = once * once;
    const double fourTimes = twice * twice;
    return fourTimes * fourTimes;
}

constexpr std::size_t kLookEvery = 4096;  // candidates between two questions whether to go on

/// Leaves `count` of the candidates; nothing: goOn said so.
bool eliminate(std::vector<SurfaceSample>& candidates, std::size_t count, double area, const GoOn& goOn) {
    const double widest = widestSpacing(area, count);
    const Neighbours neighbours(candidates, widest);
    const double excess = static_cast<double>(count) / static_cast<double>(candidates.size());
    const double least = 0.65 * (1.0 - excess * std::sqrt(excess));
    std::vector<double> crowded(candidates.size());
    std::priority_queue<std::pair<double, std::uint32_t>> queue;
    const auto isWanted = [&](std::size_t done) {
        return !goOn || done % kLookEvery != 0 ||
               goOn(static_cast<double>(done) / (2.0 * static_cast<double>(candidates.size())));
    };
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (!isWanted(i)) {
            return false;
        }
        neighbours.of(
            i, [&](std::size_t, double distance) { crowded[i] += crowding(distance / widest, least); });
        queue.emplace(crowded[i], static_cast<std::uint32_t>(i));
    }
    std::vector<bool> isGone(candidates.size(), false);
    for (std::size_t left = candidates.size(); left > count;) {
        const auto [weight, index] = queue.top();
        queue.pop();
        if (weight != crowded[index]) {
            queue.emplace(crowded[index], index);  // others have gone since: it has become less
            continue;
        }
        isGone[index] = true;
        --left;
        if (!isWanted(candidates.size() + (candidates.size() - left))) {
            return false;
        }
        neighbours.of(index, [&](std::size_t other, double distance) {
            crowded[other] -= crowding(distance / widest, least);
        });
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (!isGone[i]) {
            candidates[kept++] = candidates[i];
        }
    }
    candidates.resize(kept);
    return true;
}

}  // namespace

double RepeatableRandom::next() {
    constexpr int kUnused = 64 - 53;
    return static_cast<double>(m_engine() >> kUnused) * 0x1.0p-53;
}

double surfaceArea(const SurfaceView& surface) {
    const std::vector<double> areas = areasUpTo(surface);
    return areas.empty() ? 0.0 : areas.back();
}

double widestSpacing(double area, std::size_t count) {
    const double twiceRootThree = 3.4641016151377544;  // of the densest packing of circles
    return 2.0 * std::sqrt(area / (twiceRootThree * static_cast<double>(std::max<std::size_t>(count, 1))));
}

std::vector<SurfaceSample> sampleSurface(const SurfaceView& surface, std::size_t count, std::uint64_t seed,
                                         const GoOn& goOn) {
    const std::vector<double> areas = areasUpTo(surface);
    if (count == 0 || areas.empty() || !(areas.back() > 0.0) || !std::isfinite(areas.back())) {
        return {};
    }
    std::vector<SurfaceSample> samples = candidatesOf(surface, areas, count * kCandidatesPerSample, seed);
    return eliminate(samples, count, areas.back(), goOn) ? std::move(samples) : std::vector<SurfaceSample>();
}

}  // namespace hitscope
