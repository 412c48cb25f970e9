// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/gltf_layout.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/give_up.h"
#include "io/writers/line_segments.h"
#include "mesh/corner_normals.h"
#include "mesh/same_bits.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

/// Which primitive each face belongs to, and what these are.
class FaceSorter {
public:
    FaceSorter(const MeshData& mesh, GltfLayout& layout) : m_mesh(mesh), m_layout(layout) {}

    /// Faces by primitive, in their order: those of p are faces[starts[p]] .. faces[starts[p + 1]].
    void sort() {
        std::vector<std::uint32_t> of(m_mesh.faceCount());
        for (std::size_t f = 0; f < of.size(); ++f) {
            mayGiveUp(f);
            of[f] = primitiveOf(f);
        }
        starts.assign(m_layout.primitives.size() + 1, 0);
        for (const std::uint32_t primitive : of) {
            ++starts[primitive + 1];
        }
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
        faces.resize(of.size());
        for (std::size_t f = 0; f < of.size(); ++f) {
            mayGiveUp(f);
            faces[next[of[f]]++] = static_cast<std::uint32_t>(f);
        }
    }

    std::vector<std::size_t> starts;
    std::vector<std::uint32_t> faces;

private:
    /// Objects are runs of faces, so primitives come sorted by them.
    std::uint32_t primitiveOf(std::size_t face) {
        const std::vector<FaceGroup>& groups = m_mesh.groups;
        for (; m_nextGroup < groups.size() && groups[m_nextGroup].firstFace <= face; ++m_nextGroup) {
            if (groups[m_nextGroup].kind == FaceGroup::Kind::Object) {
                m_name = groups[m_nextGroup].name;
                m_isNew = true;
            }
        }
        if (m_isNew) {
            m_layout.objects.push_back(m_name.empty() ? m_mesh.name : m_name);
            m_known.clear();
            m_isNew = false;
        }
        const std::uint32_t material = m_mesh.faceMaterials.empty() ? kNoIndex : m_mesh.faceMaterials[face];
        const auto [at, isNew] =
            m_known.try_emplace(material, static_cast<std::uint32_t>(m_layout.primitives.size()));
        if (isNew) {
            GltfPrimitive& primitive = m_layout.primitives.emplace_back();
            primitive.object = static_cast<std::uint32_t>(m_layout.objects.size() - 1);
            primitive.material = material;
        }
        return at->second;
    }

    const MeshData& m_mesh;
    GltfLayout& m_layout;
    std::size_t m_nextGroup = 0;
    std::string m_name;
    bool m_isNew = true;
    std::map<std::uint32_t, std::uint32_t> m_known;  ///< primitives of the object by material
};

/// Those that no face, line or point has.
std::vector<std::uint32_t> unusedVertices(const MeshData& mesh) {
    std::vector<bool> used(mesh.positions.size());
    const auto use = [&used](const std::vector<std::uint32_t>& indices) {
        for (std::size_t i = 0; i < indices.size(); ++i) {
            mayGiveUp(i);
            used[indices[i]] = true;
        }
    };
    use(mesh.cornerVertices);
    use(lineSegments(mesh));
    use(mesh.points);
    std::vector<std::uint32_t> unused;
    for (std::uint32_t v = 0; v < used.size(); ++v) {
        if (!used[v]) {
            unused.push_back(v);
        }
    }
    return unused;
}

/// Fills primitives, one after the other.
class PrimitiveMaker {
public:
    PrimitiveMaker(const MeshExport& what, std::span<const glm::vec3> originals)
        : m_what(what),
          m_mesh(*what.mesh),
          m_originals(originals),
          m_slots(m_mesh.positions.size(), kNoIndex) {}

    void make(GltfPrimitive& primitive, std::span<const std::uint32_t> faces, bool withUnused);

private:
    void takeVertices(GltfPrimitive& primitive, std::span<const std::uint32_t> faces, bool withUnused);
    std::uint32_t slotOf(GltfPrimitive& primitive, std::uint32_t corner);
    [[nodiscard]] bool areAlike(std::uint32_t a, std::uint32_t b) const;

    const MeshExport& m_what;
    const MeshData& m_mesh;
    std::span<const glm::vec3> m_originals;
    Triangulator m_triangulator;
    std::vector<std::uint32_t> m_slots;  ///< of a file vertex: its first glTF vertex, if any
    std::vector<std::uint32_t> m_next;   ///< of a glTF vertex: the file vertex's next
    std::vector<std::uint32_t> m_corners;
};

/// At the cost of the faces: there may be many primitives.
void PrimitiveMaker::takeVertices(GltfPrimitive& primitive, std::span<const std::uint32_t> faces,
                                  bool withUnused) {
    std::vector<std::uint32_t>& vertices = primitive.fileVertices;
    if (withUnused) {
        vertices = unusedVertices(m_mesh);
    }
    for (const std::uint32_t face : faces) {
        mayGiveUp(face);
        for (const std::uint32_t vertex : m_mesh.face(face)) {
            if (m_slots[vertex] == kNoIndex) {
                m_slots[vertex] = 0;
                vertices.push_back(vertex);
            }
        }
    }
    sortWatched(vertices.begin(), vertices.end());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        m_slots[vertices[i]] = i;
    }
    primitive.ownVertices = vertices.size();
    primitive.corners.assign(primitive.ownVertices, kNoIndex);
    m_next.assign(primitive.ownVertices, kNoIndex);
}

bool PrimitiveMaker::areAlike(std::uint32_t a, std::uint32_t b) const {
    if (!m_mesh.cornerTexcoords.empty()) {
        const std::uint32_t one = m_mesh.cornerTexcoords[a];
        const std::uint32_t other = m_mesh.cornerTexcoords[b];
        const bool isSame = one == other || (one != kNoIndex && other != kNoIndex &&
                                             m_mesh.texcoords[one] == m_mesh.texcoords[other]);
        if (!isSame) {
            return false;
        }
    }
    return m_what.normals.empty() ||
           (sameBits(m_what.normals[a], m_what.normals[b]) && sameBits(m_originals[a], m_originals[b]));
}

std::uint32_t PrimitiveMaker::slotOf(GltfPrimitive& primitive, std::uint32_t corner) {
    std::uint32_t slot = m_slots[m_mesh.cornerVertices[corner]];
    for (;;) {
        if (primitive.corners[slot] == kNoIndex) {
            primitive.corners[slot] = corner;
        }
        if (areAlike(primitive.corners[slot], corner)) {
            return slot;
        }
        if (m_next[slot] == kNoIndex) {
            break;
        }
        slot = m_next[slot];
    }
    const auto added = static_cast<std::uint32_t>(primitive.fileVertices.size());
    m_next[slot] = added;
    m_next.push_back(kNoIndex);
    primitive.fileVertices.push_back(m_mesh.cornerVertices[corner]);
    primitive.corners.push_back(corner);
    return added;
}

void PrimitiveMaker::make(GltfPrimitive& primitive, std::span<const std::uint32_t> faces, bool withUnused) {
    takeVertices(primitive, faces, withUnused);
    for (const std::uint32_t face : faces) {
        mayGiveUp(face);
        m_corners.clear();
        m_triangulator.triangulate(m_mesh.positions, m_mesh.face(face), m_corners);
        for (const std::uint32_t corner : m_corners) {
            primitive.indices.push_back(slotOf(primitive, m_mesh.faceStarts[face] + corner));
        }
    }
    primitive.sortCopies();
    for (std::size_t i = 0; i < primitive.ownVertices; ++i) {
        m_slots[primitive.fileVertices[i]] = kNoIndex;
    }
}

/// Of an object's lines or points, if it has any; with these vertices, too, if it is the first primitive.
void addLoose(std::vector<GltfPrimitive>& primitives, std::uint32_t object, GltfPrimitive::Kind kind,
              const std::vector<std::uint32_t>& elements, const std::vector<std::uint32_t>& unused) {
    if (elements.empty()) {
        return;
    }
    const bool isFirst = primitives.empty();
    GltfPrimitive& primitive = primitives.emplace_back();
    primitive.kind = kind;
    primitive.object = object;
    std::vector<std::uint32_t>& vertices = primitive.fileVertices;
    vertices = elements;
    if (isFirst) {
        vertices.insert(vertices.end(), unused.begin(), unused.end());
    }
    sortWatched(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    primitive.ownVertices = vertices.size();
    primitive.corners.assign(vertices.size(), kNoIndex);
    for (const std::uint32_t vertex : elements) {
        mayGiveUp(primitive.indices.size());
        const auto at = std::lower_bound(vertices.begin(), vertices.end(), vertex);
        primitive.indices.push_back(static_cast<std::uint32_t>(at - vertices.begin()));
    }
}

}  // namespace

std::vector<LooseElements> looseElements(const MeshData& mesh) {
    if (mesh.lines.empty() && mesh.points.empty()) {
        return {};
    }
    std::vector<std::uint32_t> first(mesh.positions.size(), kNoIndex);  // object that has a face there
    std::uint32_t objects = 0;
    std::size_t nextGroup = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        mayGiveUp(f);
        bool isNew = f == 0;
        for (; nextGroup < mesh.groups.size() && mesh.groups[nextGroup].firstFace <= f; ++nextGroup) {
            isNew = isNew || mesh.groups[nextGroup].kind == FaceGroup::Kind::Object;
        }
        objects += isNew ? 1 : 0;
        for (const std::uint32_t vertex : mesh.face(f)) {
            first[vertex] = std::min(first[vertex], objects - 1);
        }
    }
    std::vector<LooseElements> loose(std::max<std::uint32_t>(objects, 1));
    const auto at = [&](std::uint32_t vertex) -> LooseElements& {
        return loose[first[vertex] == kNoIndex ? 0 : first[vertex]];
    };
    for (const std::vector<std::uint32_t>& line : mesh.lines) {
        if (!line.empty()) {
            appendSegments(line, at(line.front()).segments);
        }
    }
    for (const std::uint32_t point : mesh.points) {
        at(point).points.push_back(point);
    }
    return loose;
}

void GltfPrimitive::sortCopies() {
    m_copies.resize(fileVertices.size() - ownVertices);
    std::iota(m_copies.begin(), m_copies.end(), static_cast<std::uint32_t>(ownVertices));
    sortWatched(m_copies.begin(), m_copies.end(), [this](std::uint32_t a, std::uint32_t b) {
        return std::pair(fileVertices[a], a) < std::pair(fileVertices[b], b);
    });
}

void GltfPrimitive::findVertices(std::uint32_t fileVertex, std::vector<std::uint32_t>& found) const {
    const auto end = fileVertices.begin() + static_cast<std::ptrdiff_t>(ownVertices);
    const auto own = std::lower_bound(fileVertices.begin(), end, fileVertex);
    if (own == end || *own != fileVertex) {
        return;
    }
    found.push_back(static_cast<std::uint32_t>(own - fileVertices.begin()));
    auto copy = std::lower_bound(
        m_copies.begin(), m_copies.end(), fileVertex,
        [this](std::uint32_t vertex, std::uint32_t file) { return fileVertices[vertex] < file; });
    for (; copy != m_copies.end() && fileVertices[*copy] == fileVertex; ++copy) {
        found.push_back(*copy);
    }
}

std::vector<glm::vec3> originalNormals(const MeshExport& what) {
    return what.normals.empty() ? std::vector<glm::vec3>() : cornerNormals(*what.mesh, kCreaseAngle);
}

GltfLayout layOut(const MeshExport& what, std::span<const glm::vec3> originalNormals) {
    GltfLayout layout;
    FaceSorter sorter(*what.mesh, layout);
    sorter.sort();
    PrimitiveMaker maker(what, originalNormals);
    for (std::size_t p = 0; p < layout.primitives.size(); ++p) {
        const auto faces =
            std::span(sorter.faces).subspan(sorter.starts[p], sorter.starts[p + 1] - sorter.starts[p]);
        maker.make(layout.primitives[p], faces, p == 0);
    }
    const std::vector<LooseElements> loose = looseElements(*what.mesh);
    std::vector<std::uint32_t> unused;
    if (layout.objects.empty()) {
        layout.objects.push_back(what.mesh->name);  // of lines and points alone
        unused = unusedVertices(*what.mesh);
    }
    for (std::uint32_t object = 0; object < loose.size(); ++object) {
        addLoose(layout.primitives, object, GltfPrimitive::Kind::Lines, loose[object].segments, unused);
        addLoose(layout.primitives, object, GltfPrimitive::Kind::Points, loose[object].points, unused);
    }
    std::stable_sort(layout.primitives.begin(), layout.primitives.end(),
                     [](const GltfPrimitive& a, const GltfPrimitive& b) { return a.object < b.object; });
    return layout;
}

}  // namespace hitscope
