// SPDX-License-Identifier: GPL-3.0-or-later
// Draco, which Assimp brings, has a tinygltf of its own, of another layout and the same names: a library's
// would become that one in a program that has both. So it is compiled in here, under a name of ours.
#define tinygltf hitscope_tinygltf
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <QFile>
#include <cmath>
#include <cstring>
#include <map>

#include "io/writers/file_positions.h"
#include "io/writers/gltf_morphs.h"
#include "io/written_check.h"
#include "io/written_surface_check.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

/// Thrown within this file: what differs.
struct Difference {
    std::string what;
};

/// Numbers of a glTF file's accessors. It is our own file, but the disk may have made anything of it.
class Accessors {
public:
    explicit Accessors(const tinygltf::Model& model) : m_model(model) {}

    [[nodiscard]] std::vector<std::uint32_t> indices(int index) const {
        const tinygltf::Accessor& accessor = at(index);
        std::vector<std::uint32_t> numbers(accessor.count);
        const bool areShort = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
        const std::size_t size = areShort ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
        const unsigned char* const from =
            bytes(accessor.bufferView, accessor.byteOffset, size * accessor.count);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            std::memcpy(&numbers[i], from + size * i, size);  // little endian
        }
        return numbers;
    }
    /// `components` to each element.
    [[nodiscard]] std::vector<float> floats(int index, std::size_t components) const {
        const tinygltf::Accessor& accessor = at(index);
        if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
            throw Difference{"an accessor has no floats"};
        }
        std::vector<float> numbers(accessor.count * components);
        const std::size_t size = sizeof(float) * components;
        if (accessor.bufferView >= 0) {
            std::memcpy(numbers.data(),
                        bytes(accessor.bufferView, accessor.byteOffset, size * accessor.count),
                        size * accessor.count);
        }
        if (accessor.sparse.isSparse) {
            const auto count = static_cast<std::size_t>(std::max(accessor.sparse.count, 0));
            const unsigned char* const slots =
                bytes(accessor.sparse.indices.bufferView, 0, sizeof(std::uint32_t) * count);
            const unsigned char* const values = bytes(accessor.sparse.values.bufferView, 0, size * count);
            for (std::size_t i = 0; i < count; ++i) {
                std::uint32_t slot = 0;
                std::memcpy(&slot, slots + sizeof slot * i, sizeof slot);
                if (slot >= accessor.count) {
                    throw Difference{"a morph target moves a vertex that is not there"};
                }
                std::memcpy(&numbers[components * slot], values + size * i, size);
            }
        }
        return numbers;
    }

private:
    [[nodiscard]] const tinygltf::Accessor& at(int index) const {
        if (index < 0 || static_cast<std::size_t>(index) >= m_model.accessors.size()) {
            throw Difference{"an accessor is not there"};
        }
        return m_model.accessors[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] const unsigned char* bytes(int view, std::size_t offset, std::size_t size) const {
        if (view < 0 || static_cast<std::size_t>(view) >= m_model.bufferViews.size()) {
            throw Difference{"a part of the buffer is not there"};
        }
        const tinygltf::BufferView& from = m_model.bufferViews[static_cast<std::size_t>(view)];
        if (from.buffer != 0 || m_model.buffers.empty() || offset > from.byteLength ||
            size > from.byteLength - offset || from.byteOffset > m_model.buffers[0].data.size() ||
            from.byteLength > m_model.buffers[0].data.size() - from.byteOffset) {
            throw Difference{"the buffer ends too early"};
        }
        return m_model.buffers[0].data.data() + from.byteOffset + offset;
    }

    const tinygltf::Model& m_model;
};

/// A primitive as it is in the file.
struct ReadPrimitive {
    std::vector<std::uint32_t> indices;
    std::vector<float> positions;            ///< 3 a vertex
    std::vector<float> fileVertices;         ///< empty: there are too many to be numbered
    std::vector<std::vector<float>> morphs;  ///< one a target, 3 a vertex
    std::vector<float> normals;              ///< 3 a vertex, or empty
    std::vector<float> turns;                ///< of them, by "Deformed"; 3 a vertex, or empty
    std::vector<float> texcoords;            ///< 2 a vertex, or empty
    int material = -1;
    std::size_t next = 0;  ///< index to be held against the mesh
};

ReadPrimitive readPrimitive(const tinygltf::Primitive& primitive, const Accessors& accessors) {
    ReadPrimitive read;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) {
        throw Difference{"vertices have no positions"};
    }
    read.positions = accessors.floats(position->second, 3);
    read.indices = accessors.indices(primitive.indices);
    const auto number = primitive.attributes.find("_FILE_VERTEX");
    if (number != primitive.attributes.end()) {
        read.fileVertices = accessors.floats(number->second, 1);
        if (3 * read.fileVertices.size() != read.positions.size()) {
            throw Difference{"some vertices have no number"};
        }
    }
    const auto vectors = [&](const auto& attributes, const char* name, std::size_t components) {
        const auto found = attributes.find(name);
        std::vector<float> numbers =
            found == attributes.end() ? std::vector<float>() : accessors.floats(found->second, components);
        if (!numbers.empty() && numbers.size() / components != read.positions.size() / 3) {
            throw Difference{std::string("some vertices have no ") + name};
        }
        return numbers;
    };
    read.normals = vectors(primitive.attributes, "NORMAL", 3);
    read.texcoords = vectors(primitive.attributes, "TEXCOORD_0", 2);
    read.turns =
        primitive.targets.empty() ? std::vector<float>() : vectors(primitive.targets.front(), "NORMAL", 3);
    read.material = primitive.material;
    for (const auto& target : primitive.targets) {
        const auto moved = target.find("POSITION");
        if (moved == target.end()) {
            throw Difference{"a morph target moves nothing"};
        }
        read.morphs.push_back(accessors.floats(moved->second, 3));
        if (read.morphs.back().size() != read.positions.size()) {
            throw Difference{"a morph target has another number of vertices"};
        }
    }
    return read;
}

void checkTargetNames(const tinygltf::Mesh& mesh) {
    if (mesh.primitives.empty() || mesh.primitives.front().targets.empty()) {
        return;
    }
    const bool isNamed = mesh.extras.Has("targetNames") && mesh.extras.Get("targetNames").ArrayLen() > 0 &&
                         mesh.extras.Get("targetNames").Get(0).IsString() &&
                         mesh.extras.Get("targetNames").Get(0).Get<std::string>() == "Deformed";
    const bool isShown = !mesh.weights.empty() && mesh.weights.front() == 1.0;
    if (!isNamed || !isShown) {
        throw Difference{"the deformed shape is not the one that is shown"};
    }
}

/// Those of all nodes, in their order.
std::vector<ReadPrimitive> readPrimitives(const tinygltf::Model& model) {
    const Accessors accessors(model);
    std::vector<ReadPrimitive> read;
    for (const tinygltf::Node& node : model.nodes) {
        if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= model.meshes.size()) {
            throw Difference{"a node has no mesh"};
        }
        const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
        checkTargetNames(mesh);
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            read.push_back(readPrimitive(primitive, accessors));
        }
    }
    return read;
}

/// Holds what was read against the mesh.
class GltfComparison {
public:
    GltfComparison(const MeshExport& what, std::vector<ReadPrimitive> read)
        : m_what(what),
          m_mesh(*what.mesh),
          m_positions(what),
          m_originals(originalNormals(what)),
          m_read(std::move(read)),
          m_seen(m_mesh.positions.size()) {}

    void compare();

private:
    void vertices(const ReadPrimitive& primitive);
    void vertex(const ReadPrimitive& primitive, std::size_t slot, std::uint32_t vertex) const;
    void surface(const ReadPrimitive& primitive, std::size_t slot, std::size_t face,
                 std::size_t corner) const;
    ReadPrimitive& primitiveOf(std::size_t face);

    const MeshExport& m_what;
    const MeshData& m_mesh;
    FilePositions m_positions;
    std::vector<glm::vec3> m_originals;  ///< normals, one a corner, or empty
    std::vector<ReadPrimitive> m_read;
    std::vector<bool> m_seen;                                              ///< file vertices
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
    const float size = std::max({glm::length(original), glm::length(now), glm::length(now - original)});
    const auto check = [&](const glm::vec3& shown, float roundings) {
        if (!(glm::length(shown - now) <= roundings * 1.2e-7f * size)) {
            throw Difference{elsewhere(name + ", deformed,", shown, now)};
        }
    };
    const bool isMorphed = !primitive.morphs.empty();
    check(isMorphed ? original + at(primitive.morphs.front()) : original, isMorphed ? 1.0f : 0.0f);
    glm::vec3 stepped = original;
    for (std::size_t m = 1; m < primitive.morphs.size(); ++m) {
        stepped += at(primitive.morphs[m]);
    }
    if (primitive.morphs.size() > 1) {
        check(stepped, 2.0f * static_cast<float>(primitive.morphs.size()));
    }
}

void GltfComparison::vertices(const ReadPrimitive& primitive) {
    for (std::size_t i = 0; i < primitive.fileVertices.size(); ++i) {
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

void GltfComparison::compare() {
    bool areNumbered = true;
    for (const ReadPrimitive& primitive : m_read) {
        vertices(primitive);
        areNumbered = areNumbered && !primitive.fileVertices.empty();
    }
    for (std::size_t v = 0; areNumbered && v < m_seen.size(); ++v) {
        if (!m_seen[v]) {
            throw Difference{"vertex " + std::to_string(v + 1) + " is not there"};
        }
    }
    Triangulator triangulator;
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
        ReadPrimitive& primitive = primitiveOf(f);
        corners.clear();
        triangulator.triangulate(m_mesh.positions, m_mesh.face(f), corners);
        for (const std::uint32_t corner : corners) {
            const std::uint32_t meant = m_mesh.face(f)[corner];
            const bool isThere =
                primitive.next < primitive.indices.size() &&
                3 * std::size_t{primitive.indices[primitive.next]} < primitive.positions.size();
            const std::size_t slot = isThere ? primitive.indices[primitive.next] : 0;
            if (!isThere || (areNumbered && primitive.fileVertices[slot] != static_cast<float>(meant))) {
                throw Difference{"face " + std::to_string(f + 1) + " has other vertices"};
            }
            if (!areNumbered) {
                vertex(primitive, slot, meant);
            }
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

}  // namespace

Status verifyWrittenGltf(const QString& path, const MeshExport& what) {
    tinygltf::TinyGLTF loader;
    // Pictures are not looked at.
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const std::string name = QFile::encodeName(path).toStdString();
    const bool isRead = path.endsWith(QStringLiteral(".glb"), Qt::CaseInsensitive)
                            ? loader.LoadBinaryFromFile(&model, &error, &warning, name)
                            : loader.LoadASCIIFromFile(&model, &error, &warning, name);
    if (!isRead) {
        return notAsMeant(path, "it cannot be read (" + error + ")");
    }
    try {
        GltfComparison(what, readPrimitives(model)).compare();
    } catch (const Difference& difference) {
        return notAsMeant(path, difference.what);
    } catch (const std::bad_alloc&) {
        return Error{"There is not enough memory to read back what was written.", path.toStdString(),
                     "Close other programs."};
    }
    return Done{};
}

}  // namespace hitscope
