// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/refine_work.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "mesh/refine/face_cutter.h"
#include "mesh/surface/welded_vertices.h"
#include "mesh/triangulate.h"

namespace hitscope {

namespace {

/// The middle, rounded once: the same for both directions of an edge.
glm::vec3 middle(const glm::vec3& a, const glm::vec3& b) {
    return glm::vec3(0.5 * (glm::dvec3(a) + glm::dvec3(b)));
}

}  // namespace

RefineWork::RefineWork(const MeshData& mesh, const RegionTest& region)
    : m_mesh(mesh), m_region(region), m_places(weldedVertices(mesh)) {
    m_made.mesh = mesh;
    m_made.firstNew = mesh.vertexCount();
    MeshData& made = m_made.mesh;
    if (made.sourceVertices.empty()) {
        made.sourceVertices.resize(mesh.vertexCount());
        std::iota(made.sourceVertices.begin(), made.sourceVertices.end(), 0U);
    }
    const std::vector<bool> inRegion = region.faces();
    std::vector<bool> isNear(mesh.vertexCount(), false);  // places of the region's faces
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (const std::uint32_t vertex : mesh.face(f)) {
            isNear[m_places[vertex]] = isNear[m_places[vertex]] || inRegion[f];
        }
    }
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        const std::span<const std::uint32_t> face = mesh.face(f);
        const auto near = std::count_if(face.begin(), face.end(),
                                        [&](std::uint32_t vertex) { return isNear[m_places[vertex]]; });
        if (near == 0) {
            ++m_untouched;
            continue;
        }
        m_faces.push_back({static_cast<std::uint32_t>(m_corners.size()),
                           static_cast<std::uint32_t>(face.size()), f, inRegion[f]});
        for (std::uint32_t c = mesh.faceStarts[f]; c < mesh.faceStarts[f + 1]; ++c) {
            m_corners.push_back({mesh.cornerVertices[c],
                                 mesh.cornerTexcoords.empty() ? kNoIndex : mesh.cornerTexcoords[c],
                                 mesh.cornerNormals.empty() ? kNoIndex : mesh.cornerNormals[c]});
        }
    }
}

double RefineWork::squaredLength(std::uint32_t a, std::uint32_t b) const {
    const glm::dvec3 along = glm::dvec3(position(b)) - glm::dvec3(position(a));
    return glm::dot(along, along);
}

void RefineWork::copy(const Face& face, Parts& parts) const {
    const std::span<const RefineCorner> corners = cornersOf(face);
    Face same = face;
    same.first = static_cast<std::uint32_t>(parts.corners.size());
    parts.corners.insert(parts.corners.end(), corners.begin(), corners.end());
    parts.faces.push_back(same);
}

/// A part of a face that is in the region need not be.
void RefineWork::add(const Face& parent, std::span<const RefineCorner> corners, Parts& parts) const {
    Face part{static_cast<std::uint32_t>(parts.corners.size()), static_cast<std::uint32_t>(corners.size()),
              parent.source, parent.inRegion};
    if (parent.inRegion) {
        std::vector<glm::vec3> places;
        for (const RefineCorner& corner : corners) {
            places.push_back(position(corner.vertex));
        }
        part.inRegion = m_region.hasPart(places);
    }
    parts.corners.insert(parts.corners.end(), corners.begin(), corners.end());
    parts.faces.push_back(part);
}

void RefineWork::triangulate(const std::function<bool(const Face&)>& decide) {
    Parts parts;
    Triangulator triangulator;
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> triangles;
    for (const Face& face : m_faces) {
        if (face.count == 3 || !decide(face)) {
            copy(face, parts);
            continue;
        }
        vertices.clear();
        triangles.clear();
        for (const RefineCorner& corner : cornersOf(face)) {
            vertices.push_back(corner.vertex);
        }
        triangulator.triangulate(m_made.mesh.positions, vertices, triangles);
        for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
            const std::span<const RefineCorner> all = cornersOf(face);
            add(face, std::array{all[triangles[t]], all[triangles[t + 1]], all[triangles[t + 2]]}, parts);
        }
    }
    m_faces = std::move(parts.faces);
    m_corners = std::move(parts.corners);
}

void RefineWork::cut(CutEdges& edges) {
    m_vertices.clear();
    m_texcoords.clear();
    m_normals.clear();
    Parts parts;
    parts.faces.reserve(m_faces.size() + 2 * edges.size());
    parts.corners.reserve(m_corners.size() + 6 * edges.size());
    std::vector<std::optional<RefineCorner>> middles;
    for (const Face& face : m_faces) {
        const std::span<const RefineCorner> corners = cornersOf(face);
        middles.assign(corners.size(), std::nullopt);
        bool any = false;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const RefineCorner& next = corners[i + 1 < corners.size() ? i + 1 : 0];
            if (const auto edge = edges.find(edgeKey(placeOf(corners[i]), placeOf(next)));
                edge != edges.end()) {
                middles[i] = between(corners[i], next, edge->second);
                any = true;
            }
        }
        if (!any) {
            copy(face, parts);
            continue;
        }
        FaceCutter(*this, face, middles).cut([&](std::span<const RefineCorner> part) {
            add(face, part, parts);
        });
    }
    m_faces = std::move(parts.faces);
    m_corners = std::move(parts.corners);
}

// New vertices

RefineCorner RefineWork::between(const RefineCorner& a, const RefineCorner& b, CutEdge& edge) {
    return {vertexBetween(a.vertex, b.vertex, edge), texcoordBetween(a.texcoord, b.texcoord),
            normalBetween(a.normal, b.normal)};
}

/// One position an edge, and as many vertices at it as the edge has pairs of vertices.
std::uint32_t RefineWork::vertexBetween(std::uint32_t a, std::uint32_t b, CutEdge& edge) {
    const auto [made, isNew] = m_vertices.try_emplace(edgeKey(a, b), 0);
    if (isNew) {
        if (!edge.position) {
            edge.position = middle(position(m_places[a]), position(m_places[b]));
        }
        made->second =
            addVertex(*edge.position, {std::min(a, b), std::max(a, b), kNoIndex, kNoIndex}, edge.place);
        edge.place = m_places[made->second];
    }
    return made->second;
}

std::uint32_t RefineWork::addVertex(const glm::vec3& position, const std::array<std::uint32_t, 4>& parents,
                                    std::uint32_t place) {
    MeshData& mesh = m_made.mesh;
    const auto number = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(position);
    mesh.sourceVertices.push_back(kNoIndex);
    if (!mesh.filePositions.empty()) {
        mesh.filePositions.push_back(mesh.placement.toFile(position));
    }
    if (!mesh.colours.empty()) {
        glm::vec3 sum(0.0f);
        float count = 0.0f;
        for (const std::uint32_t parent : parents) {
            if (parent != kNoIndex) {
                sum += mesh.colours[parent];
                count += 1.0f;
            }
        }
        mesh.colours.push_back(glm::min(sum / count, glm::vec3(1.0f)));
    }
    m_made.parents.push_back(parents);
    m_places.push_back(place == kNoIndex ? number : place);
    return number;
}

std::uint32_t RefineWork::texcoordBetween(std::uint32_t a, std::uint32_t b) {
    if (a == kNoIndex || b == kNoIndex || a == b) {
        return a == b ? a : kNoIndex;
    }
    std::vector<glm::vec2>& all = m_made.mesh.texcoords;
    const auto [made, isNew] = m_texcoords.try_emplace(edgeKey(a, b), static_cast<std::uint32_t>(all.size()));
    if (isNew) {
        all.push_back(0.5f * all[a] + 0.5f * all[b]);
    }
    return made->second;
}

std::uint32_t RefineWork::normalBetween(std::uint32_t a, std::uint32_t b) {
    if (a == kNoIndex || b == kNoIndex || a == b) {
        return a == b ? a : kNoIndex;
    }
    std::vector<glm::vec3>& all = m_made.mesh.normals;
    const auto [made, isNew] = m_normals.try_emplace(edgeKey(a, b), static_cast<std::uint32_t>(all.size()));
    if (isNew) {
        const glm::vec3 sum = 0.5f * all[a] + 0.5f * all[b];
        const float length = glm::length(sum);
        // Of normals that are against one another none is between.
        all.push_back(length > 1.0e-6f ? sum / length : all[std::min(a, b)]);
    }
    return made->second;
}

RefineCorner RefineWork::centreOf(std::span<const RefineCorner> quad) {
    glm::dvec3 sum(0.0);
    for (const RefineCorner& corner : quad) {
        sum += glm::dvec3(position(corner.vertex));
    }
    const auto half = [](std::uint32_t a, std::uint32_t b, const auto& between) { return between(a, b); };
    const auto texcoord = [this](std::uint32_t a, std::uint32_t b) { return texcoordBetween(a, b); };
    const auto normal = [this](std::uint32_t a, std::uint32_t b) { return normalBetween(a, b); };
    RefineCorner centre;
    centre.vertex = addVertex(glm::vec3(0.25 * sum),
                              {quad[0].vertex, quad[1].vertex, quad[2].vertex, quad[3].vertex}, kNoIndex);
    centre.texcoord = half(half(quad[0].texcoord, quad[2].texcoord, texcoord),
                           half(quad[1].texcoord, quad[3].texcoord, texcoord), texcoord);
    centre.normal = half(half(quad[0].normal, quad[2].normal, normal),
                         half(quad[1].normal, quad[3].normal, normal), normal);
    return centre;
}

// What came of it

RefinedMesh RefineWork::take() {
    fillFaces();
    m_made.mesh.sourceHash = 0;
    return std::move(m_made);
}

void RefineWork::fillFaces() {
    MeshData& made = m_made.mesh;
    made.faceStarts.assign(1, 0);
    made.cornerVertices.clear();
    made.cornerTexcoords.clear();
    made.cornerNormals.clear();
    made.faceMaterials.clear();
    made.faceSmoothing.clear();
    std::vector<std::uint32_t> starts;  // of the parts of each face of the mesh
    const auto end = [&](std::uint32_t source) {
        made.faceStarts.push_back(static_cast<std::uint32_t>(made.cornerVertices.size()));
        if (!m_mesh.faceMaterials.empty()) {
            made.faceMaterials.push_back(m_mesh.faceMaterials[source]);
        }
        if (!m_mesh.faceSmoothing.empty()) {
            made.faceSmoothing.push_back(m_mesh.faceSmoothing[source]);
        }
    };
    const auto put = [&](std::uint32_t vertex, std::uint32_t texcoord, std::uint32_t normal) {
        made.cornerVertices.push_back(vertex);
        if (!m_mesh.cornerTexcoords.empty()) {
            made.cornerTexcoords.push_back(texcoord);
        }
        if (!m_mesh.cornerNormals.empty()) {
            made.cornerNormals.push_back(normal);
        }
    };
    auto part = m_faces.begin();
    for (std::uint32_t source = 0; source < m_mesh.faceCount(); ++source) {
        starts.push_back(static_cast<std::uint32_t>(made.faceCount()));
        if (part == m_faces.end() || part->source != source) {
            for (std::uint32_t c = m_mesh.faceStarts[source]; c < m_mesh.faceStarts[source + 1]; ++c) {
                put(m_mesh.cornerVertices[c],
                    m_mesh.cornerTexcoords.empty() ? kNoIndex : m_mesh.cornerTexcoords[c],
                    m_mesh.cornerNormals.empty() ? kNoIndex : m_mesh.cornerNormals[c]);
            }
            end(source);
        }
        for (; part != m_faces.end() && part->source == source; ++part) {
            for (const RefineCorner& corner : cornersOf(*part)) {
                put(corner.vertex, corner.texcoord, corner.normal);
            }
            end(source);
        }
    }
    starts.push_back(static_cast<std::uint32_t>(made.faceCount()));
    fillGroups(starts);
}

void RefineWork::fillGroups(const std::vector<std::uint32_t>& starts) {
    for (FaceGroup& group : m_made.mesh.groups) {
        group.firstFace = starts[std::min<std::size_t>(group.firstFace, starts.size() - 1)];
    }
}

}  // namespace hitscope
