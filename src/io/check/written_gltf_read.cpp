// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/check/written_gltf_read.h"

// Draco, which Assimp brings, has a tinygltf of its own, of another layout and the same names: a library's
// would become that one in a program that has both. So it is compiled in here, under a name of ours.
#define tinygltf hitscope_tinygltf
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <QFile>
#include <algorithm>
#include <cstring>

namespace hitscope {
namespace {

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
    read.mode = primitive.mode;
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

std::vector<ReadPrimitive> primitivesOf(const tinygltf::Model& model) {
    const Accessors accessors(model);
    std::vector<ReadPrimitive> read;
    for (std::size_t object = 0; object < model.nodes.size(); ++object) {
        const tinygltf::Node& node = model.nodes[object];
        if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= model.meshes.size()) {
            throw Difference{"a node has no mesh"};
        }
        const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
        checkTargetNames(mesh);
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            read.push_back(readPrimitive(primitive, accessors));
            read.back().object = object;
        }
    }
    return read;
}

}  // namespace

std::vector<ReadPrimitive> readPrimitives(const QString& path) {
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
        throw Difference{"it cannot be read (" + error + ")"};
    }
    return primitivesOf(model);
}

}  // namespace hitscope
