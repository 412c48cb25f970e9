// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <span>
#include <unordered_map>

#include "mesh/face_corner.h"

namespace hitscope {
namespace {

/// Index of a thing named by two others, in whichever order; numbered as they come.
class PairIndex {
public:
    explicit PairIndex(std::size_t expected) { m_indices.reserve(expected); }
    /// The index of (a, b), `next` when it is new.
    std::uint32_t find(std::uint32_t a, std::uint32_t b, std::size_t next) {
        const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
        return m_indices.try_emplace(key, static_cast<std::uint32_t>(next)).first->second;
    }

private:
    std::unordered_map<std::uint64_t, std::uint32_t> m_indices;
};

/// Points of one array halfway along pairs of its own entries, each pair's once.
template <class Points>
std::uint32_t midpoint(Points& points, PairIndex& known, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t index = known.find(a, b, points.size());
    if (index == points.size()) {
        points.push_back(0.5f * points[a] + 0.5f * points[b]);
    }
    return index;
}

template <class Points>
std::uint32_t addCentroid(Points& points, std::span<const std::uint32_t> indices) {
    typename Points::value_type sum(0.0f);
    for (const std::uint32_t index : indices) {
        sum += points[index];
    }
    points.push_back(sum / static_cast<float>(indices.size()));
    return static_cast<std::uint32_t>(points.size() - 1);
}

/// Replaces a face by quads from each corner to the edge points beside it and the face point. Works on
/// positions and on texture coordinates alike; the result is four indices a quad.
template <class Points>
std::vector<std::uint32_t> quadsOfFace(Points& points, PairIndex& edges,
                                       std::span<const std::uint32_t> face) {
    const std::uint32_t centre = addCentroid(points, face);
    std::vector<std::uint32_t> quads;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t next = face[(i + 1) % face.size()];
        const std::uint32_t previous = face[(i + face.size() - 1) % face.size()];
        const std::uint32_t after = midpoint(points, edges, face[i], next);
        const std::uint32_t before = midpoint(points, edges, previous, face[i]);
        quads.insert(quads.end(), {face[i], after, centre, before});
    }
    return quads;
}

}  // namespace

MeshData makeCube(int segments, float halfExtent) {
    const int n = std::max(segments, 1);
    MeshData mesh;
    mesh.name = "Cube";
    mesh.faceStarts.push_back(0);
    const auto coordinate = [n, halfExtent](int i) {
        return static_cast<float>(static_cast<double>(halfExtent) * (2 * i - n) / n);
    };
    for (int v = 0; v <= n; ++v) {
        for (int u = 0; u <= n; ++u) {
            mesh.texcoords.emplace_back(static_cast<float>(u) / static_cast<float>(n),
                                        static_cast<float>(v) / static_cast<float>(n));
        }
    }

    // Lattice points on the surface, named by their three integers, so that the faces share their edges.
    std::map<std::array<int, 3>, std::uint32_t> lattice;
    const auto vertexAt = [&](const glm::ivec3& p) {
        const auto [entry, isNew] =
            lattice.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(mesh.positions.size()));
        if (isNew) {
            mesh.positions.emplace_back(coordinate(p.x), coordinate(p.y), coordinate(p.z));
        }
        return entry->second;
    };

    struct Side {
        glm::ivec3 origin, u, v;  // u x v points outwards
    };
    const std::array<Side, 6> sides{{{{n, 0, n}, {0, 0, -1}, {0, 1, 0}},
                                     {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                     {{0, n, n}, {1, 0, 0}, {0, 0, -1}},
                                     {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, 0, n}, {1, 0, 0}, {0, 1, 0}},
                                     {{n, 0, 0}, {-1, 0, 0}, {0, 1, 0}}}};
    for (const Side& side : sides) {
        const auto normal = static_cast<std::uint32_t>(mesh.normals.size());
        mesh.normals.push_back(glm::cross(glm::vec3(side.u), glm::vec3(side.v)));
        const auto corner = [&](int u, int v) {
            return FaceCorner{vertexAt(side.origin + u * side.u + v * side.v),
                              static_cast<std::uint32_t>(v * (n + 1) + u), normal};
        };
        for (int v = 0; v < n; ++v) {
            for (int u = 0; u < n; ++u) {
                addFace(mesh,
                        std::array{corner(u, v), corner(u + 1, v), corner(u + 1, v + 1), corner(u, v + 1)});
            }
        }
    }
    return mesh;
}

MeshData makeUvSphere(int segments, int rings, float radius) {
    const int around = std::max(segments, 3);
    const int down = std::max(rings, 2);
    MeshData mesh;
    mesh.name = "Sphere";
    mesh.faceStarts.push_back(0);
    const auto addVertex = [&](double x, double y, double z) {
        mesh.normals.emplace_back(x, y, z);
        mesh.positions.emplace_back(x * radius, y * radius, z * radius);
    };
    addVertex(0.0, 1.0, 0.0);
    for (int ring = 1; ring < down; ++ring) {
        const double theta = std::numbers::pi * ring / down;
        for (int segment = 0; segment < around; ++segment) {
            const double phi = 2.0 * std::numbers::pi * segment / around;
            addVertex(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
        }
    }
    addVertex(0.0, -1.0, 0.0);
    for (int ring = 0; ring <= down; ++ring) {
        // At a pole each triangle has its own point, in the middle of its strip.
        const double shift = ring == 0 || ring == down ? 0.5 : 0.0;
        for (int segment = 0; segment <= around; ++segment) {
            mesh.texcoords.emplace_back(std::min((segment + shift) / around, 1.0),
                                        1.0 - static_cast<double>(ring) / down);
        }
    }

    const auto corner = [&](int ring, int segment) {
        std::uint32_t vertex = 0;
        if (ring == down) {
            vertex = static_cast<std::uint32_t>(mesh.positions.size() - 1);
        } else if (ring > 0) {
            vertex = static_cast<std::uint32_t>(1 + (ring - 1) * around + segment % around);
        }
        return FaceCorner{vertex, static_cast<std::uint32_t>(ring * (around + 1) + segment), vertex};
    };
    for (int ring = 0; ring < down; ++ring) {
        for (int s = 0; s < around; ++s) {
            if (ring == 0) {
                addFace(mesh, std::array{corner(0, s), corner(1, s), corner(1, s + 1)});
            } else if (ring == down - 1) {
                addFace(mesh, std::array{corner(ring, s), corner(down, s), corner(ring, s + 1)});
            } else {
                addFace(mesh, std::array{corner(ring, s), corner(ring + 1, s), corner(ring + 1, s + 1),
                                         corner(ring, s + 1)});
            }
        }
    }
    return mesh;
}

MeshData splitIntoQuadsOnSphere(const MeshData& sphere, float radius) {
    MeshData mesh;
    mesh.name = sphere.name;
    mesh.positions = sphere.positions;
    mesh.texcoords = sphere.texcoords;
    mesh.faceStarts.push_back(0);
    PairIndex edges(sphere.cornerVertices.size());
    PairIndex textureEdges(sphere.cornerVertices.size());
    for (std::size_t f = 0; f < sphere.faceCount(); ++f) {
        const std::vector<std::uint32_t> quads = quadsOfFace(mesh.positions, edges, sphere.face(f));
        const std::span textures = std::span(sphere.cornerTexcoords)
                                       .subspan(sphere.cornerTexcoords.empty() ? 0 : sphere.faceStarts[f],
                                                sphere.cornerTexcoords.empty() ? 0 : sphere.face(f).size());
        const bool textured = !textures.empty() && std::ranges::find(textures, kNoIndex) == textures.end();
        const std::vector<std::uint32_t> textureQuads =
            textured ? quadsOfFace(mesh.texcoords, textureEdges, textures)
                     : std::vector<std::uint32_t>(quads.size(), kNoIndex);
        for (std::size_t c = 0; c < quads.size(); c += 4) {
            std::array<FaceCorner, 4> quad;
            for (std::size_t i = 0; i < 4; ++i) {
                quad[i] = {quads[c + i], textureQuads[c + i], quads[c + i]};
            }
            addFace(mesh, quad);
        }
    }
    for (glm::vec3& position : mesh.positions) {
        const glm::dvec3 p(position);
        const double length = glm::length(p);
        const glm::dvec3 normal = length > 0.0 ? p / length : glm::dvec3(0.0, 1.0, 0.0);
        mesh.normals.emplace_back(normal);
        position = glm::vec3(normal * static_cast<double>(radius));
    }
    return mesh;
}

MeshData makeLowPolyCube(float halfExtent) {
    MeshData mesh = makeCube(8, halfExtent);
    mesh.name = "Low-poly cube";
    return mesh;
}

MeshData makeHighPolyCube(float halfExtent) {
    MeshData mesh = makeCube(32, halfExtent);
    mesh.name = "High-poly cube";
    return mesh;
}

MeshData makeLowPolySphere(float radius) {
    MeshData mesh = makeUvSphere(20, 20, radius);
    mesh.name = "Low-poly sphere";
    return mesh;
}

MeshData makeHighPolySphere(float radius) {
    MeshData mesh =
        splitIntoQuadsOnSphere(splitIntoQuadsOnSphere(makeUvSphere(32, 16, radius), radius), radius);
    mesh.name = "High-poly sphere";
    return mesh;
}

}  // namespace hitscope
