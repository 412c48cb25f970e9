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
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "core/give_up.h"

namespace hitscope {
namespace {

constexpr double kFileShare = 0.5;         // of reading; the rest is taking the numbers out of the buffer
constexpr qint64 kPiece = 1 << 20;         // bytes read at once
constexpr std::size_t kNumbers = 1 << 20;  // copied at once

Difference cannotBeRead(const std::string& why) {
    return {"it cannot be read (" + why + ")"};
}

/// A glTF or GLB file for tinygltf, which asks for its buffer as for a file of its own. It would read all at
/// once otherwise, and nobody could end that.
class GltfFile {
public:
    GltfFile(const QString& path, const std::function<void(double)>& told) : m_file(path), m_told(told) {
        if (!m_file.open(QIODevice::ReadOnly)) {
            throw cannotBeRead(m_file.errorString().toStdString());
        }
        m_isGlb = path.endsWith(QStringLiteral(".glb"), Qt::CaseInsensitive);
    }

    /// The JSON part; that of a GLB names its buffer.
    [[nodiscard]] std::string json();
    [[nodiscard]] tinygltf::FsCallbacks callbacks();

private:
    using Bytes = std::vector<unsigned char>;
    struct Chunk {
        std::uint32_t size = 0;
        std::uint32_t type = 0;
    };
    static constexpr const char* kBuffer = "buffer of the GLB file";

    [[nodiscard]] bool isBuffer(const std::string& name) const { return m_isGlb && name.ends_with(kBuffer); }
    template <class Plain>
    [[nodiscard]] Plain next() {
        Plain value{};
        if (m_file.read(reinterpret_cast<char*>(&value), sizeof value) != sizeof value) {
            throw cannotBeRead("it ends too early");
        }
        return value;  // little endian
    }
    [[nodiscard]] std::string jsonOfGlb();
    template <class Callbacks>
    static void setSizes(Callbacks& callbacks);
    static bool read(QFile& file, qint64 size, Bytes& bytes, const std::function<void(double)>& told);

    QFile m_file;
    const std::function<void(double)>& m_told;
    bool m_isGlb = false;
    qint64 m_bufferSize = 0;  ///< of a GLB file, at the file's end
};

std::string GltfFile::json() {
    return m_isGlb ? jsonOfGlb() : m_file.readAll().toStdString();
}

/// glTF 2.0, section 4.4.
std::string GltfFile::jsonOfGlb() {
    constexpr std::uint32_t kMagic = 0x46546C67;
    constexpr std::uint32_t kJson = 0x4E4F534A;
    constexpr std::uint32_t kBin = 0x004E4942;
    const auto header = next<std::array<std::uint32_t, 3>>();
    if (header[0] != kMagic || header[1] != 2 || header[2] != m_file.size()) {
        throw cannotBeRead("its header is not that of a GLB file of its size");
    }
    const auto first = next<Chunk>();
    std::string json = m_file.read(first.size).toStdString();
    const auto second = next<Chunk>();
    if (first.type != kJson || second.type != kBin || second.size != m_file.size() - m_file.pos()) {
        throw cannotBeRead("its parts are not those of a GLB file");
    }
    m_bufferSize = second.size;
    // As our writer puts it; no text can look like it, for the quotes.
    const std::string_view buffers = R"("buffers":[{)";
    const std::size_t at = json.find(buffers);
    if (at == std::string::npos) {
        throw cannotBeRead("it has no buffer");
    }
    return json.insert(at + buffers.size(), std::string(R"("uri":")") + kBuffer + R"(",)");
}

bool GltfFile::read(QFile& file, qint64 size, Bytes& bytes, const std::function<void(double)>& told) {
    bytes.reserve(static_cast<std::size_t>(size));
    for (qint64 left = size; left > 0;) {
        mayGiveUp();
        const qint64 piece = std::min(left, kPiece);
        bytes.resize(bytes.size() + static_cast<std::size_t>(piece));
        char* const to = reinterpret_cast<char*>(bytes.data() + bytes.size()) - piece;
        if (file.read(to, piece) != piece) {
            return false;
        }
        left -= piece;
        told(kFileShare * static_cast<double>(size - left) / static_cast<double>(size));
    }
    return true;
}

tinygltf::FsCallbacks GltfFile::callbacks() {
    tinygltf::FsCallbacks callbacks{};
    callbacks.user_data = this;
    callbacks.FileExists = [](const std::string& name, void* self) {
        return static_cast<GltfFile*>(self)->isBuffer(name) ||
               QFileInfo(QFile::decodeName(name.c_str())).isFile();
    };
    callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
    callbacks.ReadWholeFile = [](Bytes* bytes, std::string* error, const std::string& name, void* self) {
        auto& glb = *static_cast<GltfFile*>(self);
        QFile other(QFile::decodeName(name.c_str()));
        const bool isBuffer = glb.isBuffer(name);
        QFile& file = isBuffer ? glb.m_file : other;
        const bool isRead = (isBuffer || file.open(QIODevice::ReadOnly)) &&
                            read(file, isBuffer ? glb.m_bufferSize : file.size(), *bytes, glb.m_told);
        *error += isRead ? std::string() : file.errorString().toStdString();
        return isRead;
    };
    // tinygltf 2.9 takes all callbacks or none.
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const Bytes&, void*) { return false; };
    setSizes(callbacks);
    return callbacks;
}

/// tinygltf 2.6 does not ask for sizes.
template <class Callbacks>
void GltfFile::setSizes(Callbacks& callbacks) {
    if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
        callbacks.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string& name,
                                          void* self) {
            const auto& glb = *static_cast<GltfFile*>(self);
            const qint64 bytes =
                glb.isBuffer(name) ? glb.m_bufferSize : QFileInfo(QFile::decodeName(name.c_str())).size();
            *size = static_cast<std::size_t>(bytes);
            return true;
        };
    }
}

/// tinygltf 2.9 refuses files of more than 2 GB where it is not told otherwise.
template <class Loader>
void allowLargeFiles(Loader& loader) {
    if constexpr (requires { loader.SetMaxExternalFileSize(std::size_t{}); }) {
        loader.SetMaxExternalFileSize(std::numeric_limits<std::size_t>::max());
    }
}

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
            mayGiveUp(i);
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
        const std::size_t all = accessor.count * components;
        std::vector<float> numbers;
        numbers.reserve(all);
        const std::size_t size = sizeof(float) * components;
        if (accessor.bufferView >= 0) {
            const unsigned char* const from =
                bytes(accessor.bufferView, accessor.byteOffset, size * accessor.count);
            for (std::size_t i = 0; i < all; i += kNumbers) {
                mayGiveUp();
                const std::size_t count = std::min(kNumbers, all - i);
                numbers.resize(i + count);
                std::memcpy(&numbers[i], from + sizeof(float) * i, sizeof(float) * count);
            }
        }
        numbers.resize(all);
        if (accessor.sparse.isSparse) {
            const auto count = static_cast<std::size_t>(std::max(accessor.sparse.count, 0));
            const unsigned char* const slots =
                bytes(accessor.sparse.indices.bufferView, 0, sizeof(std::uint32_t) * count);
            const unsigned char* const values = bytes(accessor.sparse.values.bufferView, 0, size * count);
            for (std::size_t i = 0; i < count; ++i) {
                mayGiveUp(i);
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
        mayGiveUp();
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

std::vector<ReadPrimitive> primitivesOf(const tinygltf::Model& model,
                                        const std::function<void(double)>& told) {
    const Accessors accessors(model);
    std::vector<ReadPrimitive> read;
    for (std::size_t object = 0; object < model.nodes.size(); ++object) {
        told(kFileShare +
             (1.0 - kFileShare) * static_cast<double>(object) / static_cast<double>(model.nodes.size()));
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

std::vector<ReadPrimitive> readPrimitives(const QString& path, const std::function<void(double)>& told) {
    GltfFile file(path, told);
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks(file.callbacks());
    allowLargeFiles(loader);
    // Pictures are not looked at.
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    const std::string json = file.json();
    const std::string folder = QFile::encodeName(QFileInfo(path).absolutePath()).toStdString();
    tinygltf::Model model;
    std::string error;
    std::string warning;
    if (json.size() > std::numeric_limits<unsigned int>::max() ||
        !loader.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                    static_cast<unsigned int>(json.size()), folder)) {
        throw cannotBeRead(error);
    }
    return primitivesOf(model, told);
}

}  // namespace hitscope
