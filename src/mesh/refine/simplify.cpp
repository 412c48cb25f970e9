// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/simplify.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesh/refine/collapses.h"
#include "mesh/refine/refine_work.h"
#include "mesh/surface/welded_vertices.h"
#include "mesh/triangulate.h"

namespace hitscope {

namespace {

/// A number for each combination of material and groups: where it changes is a border.
std::vector<std::uint32_t> partsOf(const MeshData& mesh) {
    std::vector<std::uint32_t> parts(mesh.faceCount(), 0);
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    std::size_t group = 0;
    for (std::size_t f = 0; f < parts.size(); ++f) {
        while (group < mesh.groups.size() && mesh.groups[group].firstFace <= f) {
            ++group;
        }
        const std::uint32_t material = mesh.faceMaterials.empty() ? 0 : mesh.faceMaterials[f];
        parts[f] =
            known
                .try_emplace(std::uint64_t{group} << 32U | material, static_cast<std::uint32_t>(known.size()))
                .first->second;
    }
    return parts;
}

class Simplifier {
public:
    explicit Simplifier(const MeshData& mesh) : m_mesh(mesh), m_places(weldedVertices(mesh)) {}

    [[nodiscard]] Result<MeshData> simplify(const SimplifyOptions& options, const MeshGoOn& goOn) {
        m_inRegion = RegionTest(m_mesh, options.region).faces();
        cutFaces();
        std::vector<bool> stays(m_mesh.vertexCount(), false);  // by place
        for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
            for (const std::uint32_t vertex : m_mesh.face(f)) {
                stays[m_places[vertex]] = stays[m_places[vertex]] || !m_inRegion[f];
            }
        }
        for (const std::uint32_t vertex : named()) {
            stays[m_places[vertex]] = true;
        }
        const auto wanted = static_cast<std::size_t>(
            std::llround(static_cast<double>(options.share) * static_cast<double>(m_triangles.size())));
        Result<std::vector<CollapsedTriangle>> left =
            collapse(m_mesh, m_places, m_triangles, stays, std::max<std::size_t>(wanted, 1), goOn);
        if (!left) {
            return left.error();
        }
        return rebuilt(left.value());
    }

private:
    /// Vertices that are more than corners of faces.
    [[nodiscard]] std::vector<std::uint32_t> named() const {
        std::vector<std::uint32_t> vertices = m_mesh.points;
        for (const std::vector<std::uint32_t>& line : m_mesh.lines) {
            vertices.insert(vertices.end(), line.begin(), line.end());
        }
        return vertices;
    }

    [[nodiscard]] RefineCorner cornerAt(std::uint32_t c) const {
        return {m_mesh.cornerVertices[c],
                m_mesh.cornerTexcoords.empty() ? kNoIndex : m_mesh.cornerTexcoords[c],
                m_mesh.cornerNormals.empty() ? kNoIndex : m_mesh.cornerNormals[c]};
    }

    void cutFaces() {
        const std::vector<std::uint32_t> parts = partsOf(m_mesh);
        Triangulator triangulator;
        std::vector<std::uint32_t> corners;
        for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f) {
            if (!m_inRegion[f]) {
                continue;
            }
            corners.clear();
            triangulator.triangulate(m_mesh.positions, m_mesh.face(f), corners);
            for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
                const std::uint32_t first = m_mesh.faceStarts[f];
                m_triangles.push_back({{cornerAt(first + corners[i]), cornerAt(first + corners[i + 1]),
                                        cornerAt(first + corners[i + 2])},
                                       f,
                                       parts[f],
                                       false});
            }
        }
    }

    [[nodiscard]] MeshData rebuilt(const std::vector<CollapsedTriangle>& left);
    void putFace(MeshData& made, std::uint32_t source, std::span<const RefineCorner> corners) const;
    void dropUnused(MeshData& made) const;

    const MeshData& m_mesh;
    std::vector<std::uint32_t> m_places;
    std::vector<bool> m_inRegion;  ///< by face
    std::vector<CollapsedTriangle> m_triangles;
};

void Simplifier::putFace(MeshData& made, std::uint32_t source, std::span<const RefineCorner> corners) const {
    for (const RefineCorner& corner : corners) {
        made.cornerVertices.push_back(corner.vertex);
        if (!m_mesh.cornerTexcoords.empty()) {
            made.cornerTexcoords.push_back(corner.texcoord);
        }
        if (!m_mesh.cornerNormals.empty()) {
            made.cornerNormals.push_back(corner.normal);
        }
    }
    made.faceStarts.push_back(static_cast<std::uint32_t>(made.cornerVertices.size()));
    if (!m_mesh.faceMaterials.empty()) {
        made.faceMaterials.push_back(m_mesh.faceMaterials[source]);
    }
    if (!m_mesh.faceSmoothing.empty()) {
        made.faceSmoothing.push_back(m_mesh.faceSmoothing[source]);
    }
}

/// A polygon of which no triangle has changed stays one. `left`: in the order of their sources.
MeshData Simplifier::rebuilt(const std::vector<CollapsedTriangle>& left) {
    MeshData made = m_mesh;
    made.faceStarts.assign(1, 0);
    for (auto* list : {&made.cornerVertices, &made.cornerTexcoords, &made.cornerNormals, &made.faceMaterials,
                       &made.faceSmoothing}) {
        list->clear();
    }
    std::vector<std::uint32_t> starts;
    std::vector<RefineCorner> corners;
    auto next = left.begin();
    for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f) {
        starts.push_back(static_cast<std::uint32_t>(made.faceCount()));
        const auto end =
            std::find_if(next, left.end(), [f](const auto& triangle) { return triangle.source != f; });
        const bool isWhole = static_cast<std::size_t>(end - next) + 2 == m_mesh.face(f).size() &&
                             std::none_of(next, end, [](const auto& triangle) { return triangle.isChanged; });
        if (!m_inRegion[f] || isWhole) {
            corners.clear();
            for (std::uint32_t c = m_mesh.faceStarts[f]; c < m_mesh.faceStarts[f + 1]; ++c) {
                corners.push_back(cornerAt(c));
            }
            putFace(made, f, corners);
            next = end;
        }
        for (; next != end; ++next) {
            putFace(made, f, next->corners);
        }
    }
    starts.push_back(static_cast<std::uint32_t>(made.faceCount()));
    for (FaceGroup& group : made.groups) {
        group.firstFace = starts[std::min<std::size_t>(group.firstFace, starts.size() - 1)];
    }
    dropUnused(made);
    made.sourceHash = 0;
    return made;
}

/// Vertices go that faces used and use no more.
void Simplifier::dropUnused(MeshData& made) const {
    std::vector<bool> stays(m_mesh.vertexCount(), true);
    for (const std::uint32_t vertex : m_mesh.cornerVertices) {
        stays[vertex] = false;
    }
    for (const std::uint32_t vertex : made.cornerVertices) {
        stays[vertex] = true;
    }
    for (const std::uint32_t vertex : named()) {
        stays[vertex] = true;
    }
    if (made.sourceVertices.empty()) {
        made.sourceVertices.resize(m_mesh.vertexCount());
        std::iota(made.sourceVertices.begin(), made.sourceVertices.end(), 0U);
    }
    std::vector<std::uint32_t> numbers(stays.size(), kNoIndex);
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < stays.size(); ++v) {
        if (stays[v]) {
            const auto take = [v, count](auto& list) {
                if (!list.empty()) {
                    list[count] = list[v];
                }
            };
            take(made.positions);
            take(made.filePositions);
            take(made.colours);
            take(made.sourceVertices);
            numbers[v] = count++;
        }
    }
    const auto shorten = [count](auto& list) { list.resize(std::min<std::size_t>(list.size(), count)); };
    shorten(made.positions);
    shorten(made.filePositions);
    shorten(made.colours);
    shorten(made.sourceVertices);
    const auto renumber = [&numbers](std::vector<std::uint32_t>& list) {
        std::transform(list.begin(), list.end(), list.begin(), [&](std::uint32_t v) { return numbers[v]; });
    };
    renumber(made.cornerVertices);
    renumber(made.points);
    std::for_each(made.lines.begin(), made.lines.end(), renumber);
}

}  // namespace

Result<MeshData> simplify(const MeshData& mesh, const SimplifyOptions& options, const MeshGoOn& goOn) {
    if (!(options.share > 0.0f && options.share < 1.0f)) {
        return Error{"The share of faces to keep has to be between 0 and 1.", "",
                     "Choose a share within that."};
    }
    return Simplifier(mesh).simplify(options, goOn);
}

}  // namespace hitscope
