// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/section.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "mesh/surface/sewn_vertices.h"

namespace hitscope {

namespace {

constexpr std::size_t kRun = 32;  // triangles

float heightOver(const Plane& plane, const glm::vec3& point) {
    return glm::dot(plane.normal, point) - plane.offset;
}

bool reaches(const Bounds& box, const Plane& plane) {
    const glm::vec3 middle = 0.5f * (box.min + box.max);
    const glm::vec3 half = 0.5f * (box.max - box.min);
    const float reach = glm::dot(half, glm::abs(plane.normal));
    // Rounded differently than the corners' own heights.
    const float slack = 1.0e-5f * (reach + std::abs(plane.offset) + glm::length(middle));
    return std::abs(heightOver(plane, middle)) <= reach + slack;
}

/// The cuts through edges and which of them a triangle joins.
class CutGraph {
public:
    /// Of the edge between two vertices on different sides.
    std::uint32_t cut(std::uint32_t a, std::uint32_t b, std::span<const glm::vec3> positions,
                      const Plane& plane) {
        const auto [low, high] = std::minmax(a, b);
        const std::uint64_t key = (std::uint64_t{low} << 32U) | high;
        const auto [found, isNew] = m_cuts.try_emplace(key, static_cast<std::uint32_t>(m_points.size()));
        if (isNew) {
            // Always from the lower number to the higher: the same point whichever triangle asks.
            const float from = heightOver(plane, positions[low]);
            const float to = heightOver(plane, positions[high]);
            m_points.push_back(glm::mix(positions[low], positions[high], from / (from - to)));
            m_joins.emplace_back();
        }
        return found->second;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        const auto segment = static_cast<std::uint32_t>(m_segments.size());
        m_segments.push_back({a, b});
        m_joins[a].push_back(segment);
        m_joins[b].push_back(segment);
    }

    std::vector<SectionCurve> chain() {
        m_isUsed.assign(m_segments.size(), false);
        std::vector<SectionCurve> curves;
        const auto take = [&curves](SectionCurve&& curve) {
            if (curve.points.size() > 1) {
                curves.push_back(std::move(curve));
            }
        };
        for (std::uint32_t cut = 0; cut < m_points.size(); ++cut) {
            while (m_joins[cut].size() != 2 && unusedAt(cut)) {
                take(walk(cut));
            }
        }
        for (std::uint32_t cut = 0; cut < m_points.size(); ++cut) {
            if (unusedAt(cut)) {
                take(walk(cut));
            }
        }
        return curves;
    }

private:
    [[nodiscard]] const std::uint32_t* unusedAt(std::uint32_t cut) const {
        const auto found = std::find_if(m_joins[cut].begin(), m_joins[cut].end(),
                                        [this](std::uint32_t segment) { return !m_isUsed[segment]; });
        return found != m_joins[cut].end() ? &*found : nullptr;
    }

    /// To the next cut where the way is not clear, or round to the first. Cuts of several edges at one place,
    /// of a vertex in the plane, are one point; if that is all, the curve has no length.
    SectionCurve walk(std::uint32_t first) {
        SectionCurve curve;
        curve.points.push_back(m_points[first]);
        std::uint32_t here = first;
        while (const std::uint32_t* segment = unusedAt(here)) {
            m_isUsed[*segment] = true;
            const auto& [a, b] = m_segments[*segment];
            here = here == a ? b : a;
            if (here == first) {
                curve.closed = true;
                break;
            }
            if (m_points[here] != curve.points.back()) {
                curve.points.push_back(m_points[here]);
            }
            if (m_joins[here].size() != 2) {
                break;
            }
        }
        if (curve.closed && curve.points.size() > 1 && curve.points.front() == curve.points.back()) {
            curve.points.pop_back();
        }
        return curve;
    }

    std::unordered_map<std::uint64_t, std::uint32_t> m_cuts;  ///< by edge
    std::vector<glm::vec3> m_points;
    std::vector<std::vector<std::uint32_t>> m_joins;  ///< segments, by cut
    std::vector<std::array<std::uint32_t, 2>> m_segments;
    std::vector<bool> m_isUsed;  ///< by segment
};

}  // namespace

MeshSections::MeshSections(const RenderMesh& mesh) {
    // The render vertices' order is one in space.
    std::vector<std::uint32_t> order(mesh.triangles.size() / 3);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&mesh](std::uint32_t a, std::uint32_t b) {
        return mesh.triangles[3 * std::size_t{a}] < mesh.triangles[3 * std::size_t{b}];
    });
    m_triangles.reserve(mesh.triangles.size());
    for (const std::uint32_t triangle : order) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            m_triangles.push_back(mesh.fileVertices[mesh.triangles[3 * std::size_t{triangle} + corner]]);
        }
    }
    std::vector<glm::vec3> positions(mesh.fileVertexStarts.empty() ? 0 : mesh.fileVertexStarts.size() - 1);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        positions[mesh.fileVertices[i]] = mesh.vertices[i].position;
    }
    m_sewn = std::make_shared<const std::vector<std::uint32_t>>(sewnVertices(positions, m_triangles));
    setPositions(positions);
}

void MeshSections::setPositions(std::span<const glm::vec3> positions) {
    m_positions.assign(positions.begin(), positions.end());
    m_runs.clear();
    for (std::size_t run = 0; 3 * kRun * run < m_triangles.size(); ++run) {
        m_runs.push_back(boxOf(run));
    }
}

Bounds MeshSections::boxOf(std::size_t run) const {
    Bounds box;
    const std::size_t end = std::min(m_triangles.size(), (run + 1) * 3 * kRun);
    for (std::size_t i = run * 3 * kRun; i < end; ++i) {
        box.add(m_positions[m_triangles[i]]);
    }
    return box;
}

/// A run is listed once for each vertex that has corners in it.
void MeshSections::listRuns() {
    const auto each = [this](auto&& see) {
        std::vector<std::uint32_t> last(m_positions.size(), std::numeric_limits<std::uint32_t>::max());
        for (std::size_t i = 0; i < m_triangles.size(); ++i) {
            const auto run = static_cast<std::uint32_t>(i / (3 * kRun));
            if (last[m_triangles[i]] != run) {
                last[m_triangles[i]] = run;
                see(m_triangles[i], run);
            }
        }
    };
    m_runStarts.assign(m_positions.size() + 1, 0);
    each([this](std::uint32_t vertex, std::uint32_t) { ++m_runStarts[vertex + 1]; });
    std::partial_sum(m_runStarts.begin(), m_runStarts.end(), m_runStarts.begin());
    m_runsOf.resize(m_runStarts.back());
    std::vector<std::uint32_t> next(m_runStarts.begin(), m_runStarts.end() - 1);
    each([this, &next](std::uint32_t vertex, std::uint32_t run) { m_runsOf[next[vertex]++] = run; });
}

void MeshSections::move(std::span<const MovedVertex> moved) {
    if (m_runStarts.empty() && !moved.empty()) {
        listRuns();
    }
    std::vector<std::uint32_t> runs;
    for (const MovedVertex& vertex : moved) {
        m_positions[vertex.vertex] = vertex.position;
        runs.insert(runs.end(), m_runsOf.begin() + m_runStarts[vertex.vertex],
                    m_runsOf.begin() + m_runStarts[vertex.vertex + 1]);
    }
    std::sort(runs.begin(), runs.end());
    runs.erase(std::unique(runs.begin(), runs.end()), runs.end());
    for (const std::uint32_t run : runs) {
        m_runs[run] = boxOf(run);
    }
}

std::size_t MeshSections::trianglesNear(const Plane& plane) const {
    return kRun *
           static_cast<std::size_t>(std::count_if(
               m_runs.begin(), m_runs.end(), [&plane](const Bounds& box) { return reaches(box, plane); }));
}

std::vector<SectionCurve> MeshSections::cut(const Plane& plane) const {
    CutGraph graph;
    const auto at = [this](std::size_t corner) {
        const std::uint32_t vertex = m_triangles[corner];
        return m_sewn->empty() ? vertex : (*m_sewn)[vertex];
    };
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        if (!reaches(m_runs[run], plane)) {
            continue;
        }
        const std::size_t end = std::min(m_triangles.size(), (run + 1) * 3 * kRun);
        for (std::size_t first = run * 3 * kRun; first < end; first += 3) {
            std::array<std::uint32_t, 2> ends{};
            std::size_t cuts = 0;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t a = at(first + corner);
                const std::uint32_t b = at(first + (corner + 1) % 3);
                const bool isAboveA = heightOver(plane, m_positions[a]) >= 0.0f;
                const bool isAboveB = heightOver(plane, m_positions[b]) >= 0.0f;
                if (isAboveA != isAboveB) {
                    ends[cuts++] = graph.cut(a, b, m_positions, plane);  // twice or not at all
                }
            }
            if (cuts == 2 && ends[0] != ends[1]) {
                graph.join(ends[0], ends[1]);
            }
        }
    }
    return graph.chain();
}

}  // namespace hitscope
