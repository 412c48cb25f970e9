// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_stream.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>
#include <type_traits>

#include "core/finite.h"

namespace hitscope {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

/// What may be written as it lies in memory. GLM's vectors do not count as trivially copyable once
/// GLM_FORCE_CTOR_INIT gives them constructors, though they are plain numbers still.
template <class T>
constexpr bool kIsPlain = std::is_standard_layout_v<T>&& std::is_trivially_destructible_v<T>;

constexpr char kMagic[8] = {'H', 'S', 'M', 'E', 'S', 'H', '\r', '\n'};

/// Lists the parts of a mesh in the order of the stream; `stream` writes or reads each.
template <class Stream, class Mesh>
void visitMesh(Stream& stream, Mesh& mesh) {
    stream.text(mesh.name);
    stream.array(mesh.positions);
    stream.array(mesh.filePositions);
    stream.plain(mesh.sourceHash);
    stream.plain(mesh.placement.centre);
    stream.plain(mesh.placement.scale);
    stream.array(mesh.colours);
    stream.array(mesh.normals);
    stream.array(mesh.texcoords);
    stream.array(mesh.faceStarts);
    stream.array(mesh.cornerVertices);
    stream.array(mesh.cornerTexcoords);
    stream.array(mesh.cornerNormals);
    stream.array(mesh.faceMaterials);
    stream.array(mesh.faceSmoothing);
    stream.list(mesh.groups, [&](auto& group) {
        stream.plain(group.kind);
        stream.text(group.name);
        stream.plain(group.firstFace);
    });
    stream.list(mesh.materials, [&](auto& material) {
        stream.text(material.name);
        stream.plain(material.ambient);
        stream.plain(material.diffuse);
        stream.plain(material.specular);
        stream.plain(material.shininess);
        stream.plain(material.opacity);
        stream.text(material.diffuseTexture);
        stream.plain(material.diffuseImage);
        stream.plain(material.normalMap.kind);
        stream.text(material.normalMap.texture);
        stream.plain(material.normalMap.strength);
        stream.plain(material.normalMap.image);
        stream.plain(material.metalRoughness.metalness);
        stream.plain(material.metalRoughness.roughness);
        stream.text(material.metalRoughness.texture);
        stream.plain(material.metalRoughness.image);
    });
    stream.list(mesh.images, [&](auto& image) {
        stream.plain(image.width);
        stream.plain(image.height);
        stream.array(image.pixels);
    });
    stream.list(mesh.lines, [&](auto& line) { stream.array(line); });
    stream.array(mesh.points);
    stream.list(mesh.materialLibraries, [&](auto& library) { stream.text(library); });
    stream.list(mesh.pictureFiles, [&](auto& name) { stream.text(name); });
}

class Writer {
public:
    explicit Writer(QFileDevice& file) : m_file(file) {}

    /// A full disk takes a part first, and says why only when it is asked for the rest.
    void bytes(const void* data, std::uint64_t size) {
        const char* from = static_cast<const char*>(data);
        while (m_good && size > 0) {
            const qint64 written = m_file.write(from, static_cast<qint64>(size));
            m_good = written > 0;
            from += std::max<qint64>(written, 0);
            size -= static_cast<std::uint64_t>(std::max<qint64>(written, 0));
        }
    }
    template <class T>
    void plain(const T& value) {
        static_assert(kIsPlain<T>);
        bytes(&value, sizeof value);
    }
    template <class T, class Allocator>
    void array(const std::vector<T, Allocator>& values) {
        static_assert(kIsPlain<T>);
        plain(static_cast<std::uint64_t>(values.size()));
        bytes(values.data(), values.size() * sizeof(T));
    }
    void text(const std::string& value) {
        plain(static_cast<std::uint64_t>(value.size()));
        bytes(value.data(), value.size());
    }
    template <class T, class Each>
    void list(const std::vector<T>& values, const Each& each) {
        plain(static_cast<std::uint64_t>(values.size()));
        for (const T& value : values) {
            each(value);
        }
    }
    [[nodiscard]] bool good() const { return m_good; }

private:
    QFileDevice& m_file;
    bool m_good = true;
};

/// Thrown inside this file alone: the stream is not what the writer makes.
struct BadStream : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Reader {
public:
    Reader(QIODevice& device, const ProgressSink& progress, const std::atomic_bool* cancelled,
           std::uint64_t memoryBytes)
        : m_device(device),
          m_progress(progress),
          m_cancelled(cancelled),
          m_size(static_cast<std::uint64_t>(std::max<qint64>(device.size(), 0))),
          m_left(m_size),
          m_memoryLeft(memoryBytes) {}

    void bytes(void* data, std::uint64_t size) {
        char* to = static_cast<char*>(data);
        if (size > m_left) {
            throw BadStream("it ends too early");
        }
        while (size > 0) {
            constexpr std::uint64_t kChunk = 1 << 20;  // progress and cancelling in between
            const std::uint64_t part = std::min(size, kChunk);
            if (m_cancelled && *m_cancelled) {
                throw BadStream("cancelled");
            }
            if (m_device.read(to, static_cast<qint64>(part)) != static_cast<qint64>(part)) {
                throw BadStream("it cannot be read");
            }
            to += part;
            size -= part;
            m_left -= part;
            if (m_progress && part == kChunk) {
                m_progress(1.0 - static_cast<double>(m_left) / static_cast<double>(m_size), "Taking over");
            }
        }
    }
    template <class T>
    void plain(T& value) {
        static_assert(kIsPlain<T>);
        bytes(&value, sizeof value);
    }
    template <class T, class Allocator>
    void array(std::vector<T, Allocator>& values) {
        static_assert(kIsPlain<T>);
        values.resize(count(sizeof(T), sizeof(T)));
        bytes(values.data(), values.size() * sizeof(T));
    }
    void text(std::string& value) {
        value.resize(count(1, 1));
        bytes(value.data(), value.size());
    }
    template <class T, class Each>
    void list(std::vector<T>& values, const Each& each) {
        const std::uint64_t size = count(sizeof(std::uint64_t), sizeof(T));  // each holds a length at least
        values.reserve(size);
        for (std::uint64_t i = 0; i < size; ++i) {
            each(values.emplace_back());
        }
    }
    [[nodiscard]] std::uint64_t left() const { return m_left; }

private:
    /// Bytes an entry takes in the stream at least, and in memory.
    std::uint64_t count(std::uint64_t entrySize, std::uint64_t memorySize) {
        std::uint64_t entries = 0;
        plain(entries);
        if (entries > m_left / entrySize) {
            throw BadStream("an array is longer than the rest of it");
        }
        if (entries > m_memoryLeft / memorySize) {
            throw BadStream("it takes more memory than it may have");
        }
        m_memoryLeft -= entries * memorySize;
        return entries;
    }

    QIODevice& m_device;
    const ProgressSink& m_progress;
    const std::atomic_bool* m_cancelled;
    std::uint64_t m_size;
    std::uint64_t m_left;
    std::uint64_t m_memoryLeft;
};

/// Of what a face's corners refer to, and pictures hold: validate() leaves to readers what is not drawn.
template <class Vector>
void checkCorners(const std::vector<std::uint32_t>& corners, const std::vector<Vector>& values,
                  const char* what) {
    if (std::all_of(values.begin(), values.end(), [](const Vector& v) { return isFinite(v); })) {
        return;
    }
    for (const std::uint32_t index : corners) {
        if (index != kNoIndex && !isFinite(values[index])) {
            throw BadStream(what);
        }
    }
}

bool isFraction(float value) {
    return value >= 0.0f && value <= 1.0f;
}

bool isColour(const glm::vec3& c) {
    return isFraction(c.x) && isFraction(c.y) && isFraction(c.z);
}

/// What no reader of ours hands over, and what draws and saves does not look for.
void checkDrawn(const MeshData& mesh) {
    constexpr int kMaxSide = 8192;  // pixels, as for the readers
    checkCorners(mesh.cornerNormals, mesh.normals, "a normal is no number");
    checkCorners(mesh.cornerTexcoords, mesh.texcoords, "a texture coordinate is no number");
    for (const Material& material : mesh.materials) {
        if (!isColour(material.ambient) || !isColour(material.diffuse) || !isColour(material.specular) ||
            !std::isfinite(material.shininess) || material.shininess <= 0.0f ||
            !isFraction(material.opacity)) {
            throw BadStream("a material is not in its range");
        }
    }
    for (const Image& image : mesh.images) {
        if (image.width < 1 || image.height < 1 || image.width > kMaxSide || image.height > kMaxSide) {
            throw BadStream("a picture has no size, or is too large");
        }
    }
}

Error handOverError(const QFileDevice& file) {
    return {"The mesh that was read cannot be handed over: " + file.errorString().toStdString() + ".",
            file.fileName().toStdString(), "Make room in the folder for temporary files."};
}

Error streamError(const std::string& why) {
    return {"The import worker's answer cannot be used: " + why + ".", {}, "Try opening the file again."};
}

}  // namespace

Status writeMeshStream(const MeshData& mesh, QFileDevice& file) {
    Writer writer(file);
    writer.bytes(kMagic, sizeof kMagic);
    writer.plain(kMeshStreamVersion);
    visitMesh(writer, mesh);
    if (writer.good()) {
        return Done{};
    }
    return handOverError(file);
}

Status writeMeshStream(const MeshData& mesh, const QString& path) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) ? writeMeshStream(mesh, file)
                                                                   : handOverError(file);
}

Result<MeshData> readMeshStream(const QString& path, const ProgressSink& progress,
                                const std::atomic_bool* cancelled, std::uint64_t memoryBytes) {
    QFile file(path);
    if (QFileInfo info(path); info.exists() && !info.isFile()) {  // opening a pipe could wait for ever
        return streamError("it is no file");
    }
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
        return streamError(file.errorString().toStdString());
    }
    return readMeshStream(file, progress, cancelled, memoryBytes);
}

Result<MeshData> readMeshStream(QIODevice& device, const ProgressSink& progress,
                                const std::atomic_bool* cancelled, std::uint64_t memoryBytes) {
    try {
        Reader reader(device, progress, cancelled, memoryBytes);
        char magic[sizeof kMagic] = {};
        std::uint32_t version = 0;
        reader.bytes(magic, sizeof magic);
        reader.plain(version);
        if (std::memcmp(magic, kMagic, sizeof kMagic) != 0 || version != kMeshStreamVersion) {
            throw BadStream("it is of another version of Hitscope");
        }
        MeshData mesh;
        visitMesh(reader, mesh);
        if (reader.left() != 0) {
            throw BadStream("it goes on after its end");
        }
        if (const Status valid = validate(mesh); !valid) {
            return valid.error();
        }
        checkDrawn(mesh);
        return mesh;
    } catch (const BadStream& bad) {
        return streamError(bad.what());
    } catch (const std::bad_alloc&) {
        return Error{
            "The mesh does not fit into memory.", {}, "Close other programs, or open a smaller mesh."};
    }
}

}  // namespace hitscope
