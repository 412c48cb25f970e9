// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <new>

#include "core/give_up.h"
#include "io/check/written_check.h"
#include "io/check/written_gltf_read.h"
#include "io/check/written_surface_check.h"
#include "io/writers/file_positions.h"
#include "io/writers/gltf_morphs.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

constexpr int kTriangles = static_cast<int>(GltfPrimitive::Kind::Triangles);

/// Holds what was read against the mesh.
class GltfComparison {
public:
    GltfComparison(const MeshExport& what, std::vector<ReadPrimitive> read)
        : m_what(what),
          m_mesh(*what.mesh),
          m_positions(what),
          m_originals(originalNormals(what)),
          m_seen(m_mesh.positions.size()) {
        for (ReadPrimitive& primitive : read) {
            (primitive.mode == kTriangles ? m_read : m_loose).push_back(std::move(primitive));
        }
    }

    void compare(const ExportGoOn& goOn);

private:
    void vertices(const ReadPrimitive& primitive);
    void vertex(const ReadPrimitive& primitive, std::size_t slot, std::uint32_t vertex) const;
    void surface(const ReadPrimitive& primitive, std::size_t slot, std::size_t face,
                 std::size_t corner) const;
    ReadPrimitive& primitiveOf(std::size_t face);
    [[nodiscard]] std::uint32_t slotAt(const ReadPrimitive& primitive, std::size_t at, std::uint32_t vertex,
                                       const std::string& name) const;
    void faces(const ExportGoOn& goOn);
    void looseElements(std::size_t& next, std::size_t object, GltfPrimitive::Kind kind,
                       const std::vector<std::uint32_t>& meant) const;
    void allLoose() const;

    const MeshExport& m_what;
    const MeshData& m_mesh;
    FilePositions m_positions;
    std::vector<glm::vec3> m_originals;  ///< normals, one a corner, or empty
    std::vector<ReadPrimitive> m_read;   ///< of faces
    std::vector<ReadPrimitive> m_loose;  ///< of lines and points
    bool m_areNumbered = true;           ///< all vertices
    std::vector<bool> m_seen;            ///< file vertices
    std::map<std::pair<std::size_t, std::uint32_t>, std::size_t> m_known;  ///< by object and material
    std::size_t m_objects = 0;                                             ///< begun before the face
    std::size_t m_nextGroup = 0;
};

/// The place of the original, with "Deformed", and with all steps.
void GltfComparison::vertex(const ReadPrimitive& primitive, std::size_t slot, std::uint32_t vertex) const {
    const auto at = [slot](const std::vector<float>& numbers) {
        return glm::vec3(numbers[3 * slot], numbers[3 * slot + 1], numbers[3 * slot + 2]);
    };
    const std::string name = "vertex " + std::to_string(vertex + 1);
    const glm::vec3 original = at(primitive.positions);
    const glm::vec3 meant(m_positions.original(vertex));
    if (original != meant) {
        throw Difference{elsewhere(name, original, meant)};
    }
    const glm::vec3 now(m_positions.now(vertex));
    // In double: floats overflow where lengths are squared.
    const auto apart = [](const glm::vec3& a, const glm::vec3& b) {
        return glm::distance(glm::dvec3(a), glm::dvec3(b));
    };
    const double size =
        std::max({apart(original, glm::vec3(0.0f)), apart(now, glm::vec3(0.0f)), apart(now, original)});
    const auto check = [&](const glm::vec3& shown, double roundings) {
        // gcc 12's SLP vectorizer takes a double in place of `now`: equal floats are compared as such.
        if (shown != now && !(apart(shown, now) <= roundings * 1.2e-7 * size)) {
            throw Difference{elsewhere(name + ", deformed,", shown, now)};
        }
    };
    const bool isMorphed = !primitive.morphs.empty();
    check(isMorphed ? original + at(primitive.morphs.front()) : original, isMorphed ? 1.0 : 0.0);
    glm::vec3 stepped = original;
    for (std::size_t m = 1; m < primitive.morphs.size(); ++m) {
        stepped += at(primitive.morphs[m]);
    }
    if (primitive.morphs.size() > 1) {
        check(stepped, 2.0 * static_cast<double>(primitive.morphs.size()));
    }
}

void GltfComparison::vertices(const ReadPrimitive& primitive) {
    for (std::size_t i = 0; i < primitive.fileVertices.size(); ++i) {
        mayGiveUp(i);
        const float number = primitive.fileVertices[i];
        if (!(number >= 0.0f && number < static_cast<float>(m_seen.size()))) {
            throw Difference{"a vertex has a number that cannot be"};
        }
        const auto v = static_cast<std::uint32_t>(number);
        m_seen[v] = true;
        vertex(primitive, i, v);
    }
}

/// Normals, of the original and with "Deformed", and texture coordinates of a corner.
void GltfComparison::surface(const ReadPrimitive& primitive, std::size_t slot, std::size_t face,
                             std::size_t corner) const {
    constexpr float kRounding = 2e-6f;
    const std::size_t c = m_mesh.faceStarts[face] + corner;
    const auto vectorAt = [slot](const std::vector<float>& numbers) {
        return glm::vec3(numbers[3 * slot], numbers[3 * slot + 1], numbers[3 * slot + 2]);
    };
    const auto check = [&](const char* kind, const glm::vec3& is, const glm::vec3& meant) {
        if (!(glm::length(is - meant) <= kRounding)) {
            throw Difference{otherVector(cornerName(face, corner), kind, is, meant, 3)};
        }
    };
    if (!m_originals.empty()) {
        if (primitive.normals.empty()) {
            throw Difference{cornerName(face, corner) + " has no normal"};
        }
        const glm::vec3 original = vectorAt(primitive.normals);
        check("normal", original, unitNormal(m_originals[c]));
        if (!m_what.normals.empty() && !primitive.turns.empty()) {
            check("normal, deformed,", original + vectorAt(primitive.turns), unitNormal(m_what.normals[c]));
        }
    }
    if (!m_mesh.cornerTexcoords.empty()) {
        const std::uint32_t index = m_mesh.cornerTexcoords[c];
        const glm::vec2 texcoord = index == kNoIndex ? glm::vec2(0.0f) : m_mesh.texcoords[index];
        const glm::vec2 meant(texcoord.x, 1.0f - texcoord.y);  // glTF's begin above
        if (primitive.texcoords.empty()) {
            throw Difference{cornerName(face, corner) + " has no texture coordinate"};
        }
        const glm::vec2 is(primitive.texcoords[2 * slot], primitive.texcoords[2 * slot + 1]);
        if (is != meant) {
            throw Difference{otherVector(cornerName(face, corner), "texture coordinate", glm::vec3(is, 0.0f),
                                         glm::vec3(meant, 0.0f), 2)};
        }
    }
}

/// They come as the first face of each object and material does.
ReadPrimitive& GltfComparison::primitiveOf(std::size_t face) {
    for (; m_nextGroup < m_mesh.groups.size() && m_mesh.groups[m_nextGroup].firstFace <= face;
         ++m_nextGroup) {
        m_objects += m_mesh.groups[m_nextGroup].kind == FaceGroup::Kind::Object ? 1 : 0;
    }
    const std::uint32_t material = m_mesh.faceMaterials.empty() ? kNoIndex : m_mesh.faceMaterials[face];
    const std::size_t p = m_known.try_emplace({m_objects, material}, m_known.size()).first->second;
    if (p >= m_read.size()) {
        throw Difference{"it has fewer objects or materials than it should have"};
    }
    const std::size_t meant = material == kNoIndex ? m_mesh.materials.size() : material;
    if (m_read[p].material != static_cast<int>(meant)) {
        throw Difference{"face " + std::to_string(face + 1) + " has material " +
                         std::to_string(m_read[p].material + 1) + " and should have " +
                         std::to_string(meant + 1)};
    }
    return m_read[p];
}

/// The glTF vertex that an index refers to, which is that of the file; `name`: of what it is a corner.
std::uint32_t GltfComparison::slotAt(const ReadPrimitive& primitive, std::size_t at, std::uint32_t vertex,
                                     const std::string& name) const {
    const bool isThere =
        at < primitive.indices.size() && 3 * std::size_t{primitive.indices[at]} < primitive.positions.size();
    const std::uint32_t slot = isThere ? primitive.indices[at] : 0;
    if (!isThere || (m_areNumbered && primitive.fileVertices[slot] != static_cast<float>(vertex))) {
        throw Difference{name + " has other vertices"};
    }
    if (!m_areNumbered) {
        this->vertex(primitive, slot, vertex);
    }
    return slot;
}

void GltfComparison::faces(const ExportGoOn& goOn) {
    Triangulator triangulator;
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
        tellPart(goOn, ExportStep::Comparing, f, m_mesh.faceCount());
        ReadPrimitive& primitive = primitiveOf(f);
        corners.clear();
        triangulator.triangulate(m_mesh.positions, m_mesh.face(f), corners);
        for (const std::uint32_t corner : corners) {
            const std::uint32_t slot =
                slotAt(primitive, primitive.next, m_mesh.face(f)[corner], "face " + std::to_string(f + 1));
            surface(primitive, slot, f, corner);
            ++primitive.next;
        }
    }
    for (const ReadPrimitive& primitive : m_read) {
        if (primitive.next != primitive.indices.size()) {
            throw Difference{"it has more triangles than it should have"};
        }
    }
}

/// An object's lines or points; `next` is the primitive that should have them.
void GltfComparison::looseElements(std::size_t& next, std::size_t object, GltfPrimitive::Kind kind,
                                   const std::vector<std::uint32_t>& meant) const {
    if (meant.empty()) {
        return;
    }
    const bool areLines = kind == GltfPrimitive::Kind::Lines;
    const std::string names = areLines ? "lines" : "points";
    const bool isThere = next < m_loose.size() && m_loose[next].object == object &&
                         m_loose[next].mode == static_cast<int>(kind);
    if (!isThere || m_loose[next].indices.size() != meant.size()) {
        throw Difference{"object " + std::to_string(object + 1) + " has other " + names};
    }
    for (std::size_t i = 0; i < meant.size(); ++i) {
        const std::size_t number = areLines ? i / 2 : i;
        (void)slotAt(m_loose[next], i, meant[i],
                     (areLines ? "line " : "point ") + std::to_string(number + 1) + " of object " +
                         std::to_string(object + 1));
    }
    ++next;
}

void GltfComparison::allLoose() const {
    const std::vector<LooseElements> meant = hitscope::looseElements(m_mesh);
    std::size_t next = 0;
    for (std::size_t object = 0; object < meant.size(); ++object) {
        looseElements(next, object, GltfPrimitive::Kind::Lines, meant[object].segments);
        looseElements(next, object, GltfPrimitive::Kind::Points, meant[object].points);
    }
    if (next != m_loose.size()) {
        throw Difference{"it has more lines or points than it should have"};
    }
}

void GltfComparison::compare(const ExportGoOn& goOn) {
    for (const std::vector<ReadPrimitive>* const list : {&m_read, &m_loose}) {
        for (const ReadPrimitive& primitive : *list) {
            vertices(primitive);
            m_areNumbered = m_areNumbered && !primitive.fileVertices.empty();
        }
    }
    for (std::size_t v = 0; m_areNumbered && v < m_seen.size(); ++v) {
        if (!m_seen[v]) {
            throw Difference{"vertex " + std::to_string(v + 1) + " is not there"};
        }
    }
    faces(goOn);
    allLoose();
}

}  // namespace

Status verifyWrittenGltf(const QString& path, const MeshExport& what, const ExportGoOn& goOn) {
    try {
        const auto told = [&goOn](double share) {
            if (goOn) {
                goOn(ExportStep::Checking, share);
            }
        };
        GltfComparison(what, readPrimitives(path, told)).compare(goOn);
    } catch (const Difference& difference) {
        return notAsMeant(path, difference.what);
    } catch (const std::bad_alloc&) {
        return Error{"There is not enough memory to read back what was written.", path.toStdString(),
                     "Close other programs."};
    }
    return Done{};
}

}  // namespace hitscope
