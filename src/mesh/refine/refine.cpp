// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/refine.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mesh/refine/butterfly.h"
#include "mesh/refine/edge_choice.h"
#include "mesh/refine/face_cutter.h"
#include "mesh/refine/refine_work.h"
#include "mesh/triangulate.h"

namespace hitscope {

namespace {

Error tooMany(std::size_t mostFaces) {
    return {"With edges this short the mesh would have more than " + std::to_string(mostFaces) + " faces.",
            "", "Choose a greater edge length, or refine a part of the mesh."};
}

class Refiner {
public:
    Refiner(const MeshData& mesh, const RefineOptions& options, const MeshGoOn& goOn, std::size_t mostFaces)
        : m_options(options),
          m_length(static_cast<double>(options.edgeLength)),
          m_goOn(goOn),
          m_most(mostFaces),
          m_region(mesh, options.region),
          m_work(mesh, m_region) {}

    [[nodiscard]] Result<RefinedMesh> refine() {
        if (isTooMuch()) {
            return tooMany(m_most);
        }
        m_longest = longestLength(m_work);
        constexpr int kMostPasses = 1000;  // halves end sooner, whatever the floats
        for (int pass = 0; pass < kMostPasses; ++pass) {
            cutPolygons();
            CutEdges edges = choose(pass);
            if (edges.empty()) {
                return m_work.take();
            }
            if (m_work.faceCount() + edges.size() > m_most) {
                return tooMany(m_most);
            }
            m_work.cut(edges);
            if (m_goOn && !m_goOn(progress())) {
                return Error{"Refining was cancelled.", "", "The mesh is as it was."};
            }
        }
        return tooMany(m_most);
    }

private:
    /// Triangles of edges this short have at most so much area; where that already says that they are too
    /// many, none is made.
    [[nodiscard]] bool isTooMuch() const {
        if (m_options.region.kind == MeshRegion::Kind::Balls) {
            return false;
        }
        double area = 0.0;
        for (const RefineWork::Face& face : m_work.faces()) {
            const std::span<const RefineCorner> corners = m_work.cornersOf(face);
            glm::dvec3 across(0.0);
            for (std::size_t i = 1; face.inRegion && i + 1 < corners.size(); ++i) {
                const glm::dvec3 from(m_work.position(corners[0].vertex));
                across += glm::cross(glm::dvec3(m_work.position(corners[i].vertex)) - from,
                                     glm::dvec3(m_work.position(corners[i + 1].vertex)) - from);
            }
            area += 0.5 * glm::length(across);
        }
        return area / (m_length * m_length) > static_cast<double>(m_most);
    }

    void cutPolygons() {
        const bool keepsQuads = m_options.keepQuads && m_options.method == RefineMethod::Midpoint;
        m_work.triangulate([&](const RefineWork::Face& face) {
            const bool isQuad = keepsQuads && face.count == 4 && isConvex(face);
            return !isQuad && hasLongDiagonal(m_work, face, m_length);
        });
    }
    [[nodiscard]] bool isConvex(const RefineWork::Face& face) const {
        const std::span<const RefineCorner> c = m_work.cornersOf(face);
        return isConvexQuad(m_work.position(c[0].vertex), m_work.position(c[1].vertex),
                            m_work.position(c[2].vertex), m_work.position(c[3].vertex));
    }

    [[nodiscard]] CutEdges choose(int pass) const {
        if (m_options.method == RefineMethod::LongestEdge) {
            return longestEdges(m_work, m_length);
        }
        if (m_options.method == RefineMethod::Midpoint) {
            return longEdges(m_work, m_length, m_options.keepQuads);
        }
        CutEdges edges = everyEdge(m_work, m_length);
        // A scheme that smooths may stretch edges; the middles of edges come to an end.
        constexpr double kSpare = 2.0;
        if (pass > std::log2(m_longest / m_length) + kSpare) {
            return edges;
        }
        const Butterfly butterfly(m_work);
        for (auto& [key, edge] : edges) {
            edge.position =
                butterfly.position(static_cast<std::uint32_t>(key >> 32U), static_cast<std::uint32_t>(key));
        }
        return edges;
    }

    /// By how much the longest edge has become shorter, in halves.
    [[nodiscard]] double progress() const {
        const double all = std::log2(m_longest / m_length);
        const double done = std::log2(m_longest / std::max(longestLength(m_work), m_length));
        return all > 0.0 ? std::clamp(done / all, 0.0, 1.0) : 1.0;
    }

    const RefineOptions& m_options;
    double m_length;
    const MeshGoOn& m_goOn;
    std::size_t m_most;
    RegionTest m_region;
    RefineWork m_work;
    double m_longest = 0.0;
};

}  // namespace

Result<RefinedMesh> refine(const MeshData& mesh, const RefineOptions& options, const MeshGoOn& goOn,
                           std::size_t mostFaces) {
    if (!std::isfinite(options.edgeLength) || options.edgeLength <= 0.0f) {
        return Error{"The edge length has to be more than 0 m.", "", "Choose a length in metres."};
    }
    return Refiner(mesh, options, goOn, mostFaces).refine();
}

}  // namespace hitscope
