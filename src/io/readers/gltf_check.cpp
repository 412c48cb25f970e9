// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_check.h"

#include <QFileInfo>
#include <QHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

#include "io/file_scope.h"
#include "io/readers/import_bounds.h"

namespace hitscope {
namespace {

/// Thrown inside this file alone.
struct BadGltf : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The JSON of a binary file, or all of a text.
std::string_view jsonOf(std::string_view file) {
    if (!file.starts_with("glTF")) {
        return file;
    }
    // Both versions: four letters, version, length of all; version 1: length of the JSON and its kind, the
    // JSON; version 2 the same, as the first of several such chunks.
    constexpr std::size_t kHeader = 20;
    constexpr std::size_t kLengthAt = 12;
    std::uint32_t length = 0;
    if (file.size() < kHeader) {
        throw BadGltf("it ends inside its header");
    }
    std::memcpy(&length, file.data() + kLengthAt, sizeof length);
    if (length > file.size() - kHeader) {
        throw BadGltf("it ends inside its JSON");
    }
    return file.substr(kHeader, length);
}

std::string nth(const char* what, std::size_t index) {
    return std::string(what) + " " + std::to_string(index);
}

/// Things of one kind: a list in version 2, named by their numbers; in version 1 they have names.
class Things {
public:
    Things(const QJsonObject& root, const char* key, const char* what) : m_what(what) {
        const QJsonValue value = root.value(QLatin1String(key));
        for (const QJsonValue& each : value.toArray()) {
            m_things.push_back(each.toObject());
        }
        const QJsonObject named = value.toObject();
        for (auto it = named.begin(); it != named.end(); ++it) {
            m_names.insert(it.key(), m_things.size());
            m_things.push_back(it.value().toObject());
        }
    }
    [[nodiscard]] std::size_t size() const { return m_things.size(); }
    [[nodiscard]] const QJsonObject& operator[](std::size_t index) const { return m_things[index]; }
    [[nodiscard]] std::size_t find(const QJsonValue& reference) const {
        if (reference.isString() && m_names.contains(reference.toString())) {
            return m_names.value(reference.toString());
        }
        const double number = reference.toDouble(-1.0);
        if (number >= 0.0 && number < static_cast<double>(m_things.size()) && m_names.isEmpty()) {
            return static_cast<std::size_t>(number);
        }
        throw BadGltf("it refers to " + std::string(m_what) + " that it does not have");
    }

private:
    const char* m_what;
    std::vector<QJsonObject> m_things;
    QHash<QString, std::size_t> m_names;
};

/// A whole number, not negative; `otherwise` where there is none.
std::uint64_t number(const QJsonObject& object, const char* key, std::uint64_t otherwise = 0) {
    constexpr double kMost = 1e15;  // what follows multiplies and adds; all of it stays far from 2^64
    const QJsonValue value = object.value(QLatin1String(key));
    if (value.isUndefined()) {
        return otherwise;
    }
    const double given = value.toDouble(-1.0);
    if (!(given >= 0.0 && given <= kMost) || given != std::floor(given)) {
        throw BadGltf(std::string("its ") + key + " is no number of things");
    }
    return static_cast<std::uint64_t>(given);
}

std::uint64_t componentBytes(const QJsonObject& accessor) {
    switch (number(accessor, "componentType")) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        default:
            return 4;
    }
}

std::uint64_t componentCount(const QJsonObject& accessor) {
    const QString type = accessor.value(QLatin1String("type")).toString();
    static const QHash<QString, std::uint64_t> counts{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                      {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const auto known = counts.find(type);
    if (known == counts.end()) {
        throw BadGltf("it has numbers of an unknown type");
    }
    return *known;
}

class Check {
public:
    Check(const QJsonObject& root, std::size_t fileSize, const QString& folder)
        : m_root(root), m_fileSize(fileSize), m_folder(folder) {}

    GltfCounts run() {
        checkBuffers();
        checkAccessors();
        checkMeshes();
        checkNodes();
        return {m_triangles};
    }

private:
    struct Size {
        std::uint64_t primitives = 0;
        std::uint64_t vertices = 0;
        std::uint64_t corners = 0;
    };

    [[nodiscard]] std::uint64_t bytesThere(const QJsonObject& buffer) const;
    void checkBuffers();
    void checkAccessors();
    void checkMeshes();
    void checkNodes();
    void checkParents();
    Size sizeOf(const QJsonObject& primitive);
    std::uint64_t countOf(const QJsonObject& attributes, std::optional<std::uint64_t> wanted);

    QJsonObject m_root;
    std::uint64_t m_fileSize;
    QString m_folder;
    Things m_buffers{m_root, "buffers", "a buffer"};
    Things m_views{m_root, "bufferViews", "a buffer view"};
    Things m_accessors{m_root, "accessors", "an accessor"};
    Things m_meshes{m_root, "meshes", "a mesh"};
    Things m_nodes{m_root, "nodes", "a node"};
    Things m_scenes{m_root, "scenes", "a scene"};
    std::vector<std::uint64_t> m_bufferBytes;
    std::vector<Size> m_sizes;  ///< of each mesh
    std::uint64_t m_triangles = 0;
};

/// At most: how long it really is, whatever it says.
std::uint64_t Check::bytesThere(const QJsonObject& buffer) const {
    const QString uri = buffer.value(QLatin1String("uri")).toString();
    if (uri.isEmpty() || uri.startsWith(QLatin1String("data:"))) {
        return m_fileSize;
    }
    if (const QString path = resolveUri(m_folder, uri); !path.isEmpty()) {
        return std::max(m_fileSize, static_cast<std::uint64_t>(QFileInfo(path).size()));
    }
    return m_fileSize;  // it is not there, or outside: Assimp says so
}

void Check::checkBuffers() {
    for (std::size_t b = 0; b < m_buffers.size(); ++b) {
        const std::uint64_t there = bytesThere(m_buffers[b]);
        m_bufferBytes.push_back(std::min(there, number(m_buffers[b], "byteLength", there)));
    }
    for (std::size_t v = 0; v < m_views.size(); ++v) {
        const std::uint64_t buffer = m_bufferBytes[m_buffers.find(m_views[v].value(QLatin1String("buffer")))];
        const bool hasLength =
            m_views[v].contains(QLatin1String("byteLength"));  // version 1 may leave it out
        const std::uint64_t end =
            number(m_views[v], "byteOffset") + (hasLength ? number(m_views[v], "byteLength") : 0);
        if (end > buffer) {
            throw BadGltf(nth("buffer view", v) + " goes on behind the end of its buffer");
        }
    }
}

void Check::checkAccessors() {
    // Numbers of which none is stored are zeros that others replace, or lie compressed elsewhere (Draco's
    // way).
    constexpr std::uint64_t kMostCompressed = 64;
    std::uint64_t all = m_fileSize;
    for (const std::uint64_t bytes : m_bufferBytes) {
        all += bytes;
    }
    const std::uint64_t mostZeros = std::max<std::uint64_t>(1 << 20, kMostCompressed * all);
    for (std::size_t a = 0; a < m_accessors.size(); ++a) {
        const QJsonObject& accessor = m_accessors[a];
        const std::uint64_t element = componentBytes(accessor) * componentCount(accessor);
        const std::uint64_t count = number(accessor, "count");
        const QJsonValue view = accessor.value(QLatin1String("bufferView"));
        if (view.isUndefined()) {
            if (count > mostZeros / element) {
                throw BadGltf(nth("accessor", a) + " promises " + std::to_string(count) +
                              " values, of which the file holds none");
            }
            continue;
        }
        const QJsonObject& from = m_views[m_views.find(view)];
        const std::uint64_t wholeBuffer = m_bufferBytes[m_buffers.find(from.value(QLatin1String("buffer")))];
        const std::uint64_t length = number(from, "byteLength", wholeBuffer - number(from, "byteOffset"));
        const std::uint64_t stride = std::max(number(from, "byteStride"), number(accessor, "byteStride"));
        const std::uint64_t step = stride == 0 ? element : stride;
        const std::uint64_t offset = number(accessor, "byteOffset");
        if (count > 0 && (offset + element > length || (length - offset - element) / step < count - 1)) {
            throw BadGltf(nth("accessor", a) + " goes on behind the end of its buffer view");
        }
    }
}

/// How many values each of the attributes has; all the same number.
std::uint64_t Check::countOf(const QJsonObject& attributes, std::optional<std::uint64_t> wanted) {
    for (auto it = attributes.begin(); it != attributes.end(); ++it) {
        const std::uint64_t count = number(m_accessors[m_accessors.find(it.value())], "count");
        if (count != wanted.value_or(count)) {
            throw BadGltf("the attributes of a mesh have different lengths");
        }
        wanted = count;
    }
    return wanted.value_or(0);
}

Check::Size Check::sizeOf(const QJsonObject& primitive) {
    const std::uint64_t vertices =
        countOf(primitive.value(QLatin1String("attributes")).toObject(), std::nullopt);
    for (const QJsonValue& target : primitive.value(QLatin1String("targets")).toArray()) {
        countOf(target.toObject(), vertices);
    }
    const QJsonValue indices = primitive.value(QLatin1String("indices"));
    const std::uint64_t corners =
        indices.isUndefined() ? vertices : number(m_accessors[m_accessors.find(indices)], "count");
    constexpr std::uint64_t kTriangles = 4;
    const std::uint64_t mode = number(primitive, "mode", kTriangles);
    const std::uint64_t least = mode == 0 ? 1 : mode < kTriangles ? 2 : 3;
    if (corners < least && primitive.value(QLatin1String("attributes")).toObject().size() > 0) {
        throw BadGltf("a mesh has fewer vertices than one of its faces");
    }
    if (mode >= kTriangles) {
        m_triangles += mode == kTriangles ? corners / 3 : corners - std::min<std::uint64_t>(corners, 2);
    }
    return {1, vertices, corners};
}

void Check::checkMeshes() {
    for (std::size_t m = 0; m < m_meshes.size(); ++m) {
        Size all;
        for (const QJsonValue& each : m_meshes[m].value(QLatin1String("primitives")).toArray()) {
            const Size size = sizeOf(each.toObject());
            all.primitives += size.primitives;
            all.vertices += size.vertices;
            all.corners += size.corners;
        }
        m_sizes.push_back(all);
    }
}

/// A tree, as the format wants it: with two ways to a node, and two from there, few nodes make very many.
void Check::checkParents() {
    std::vector<bool> hasParent(m_nodes.size());
    for (std::size_t n = 0; n < m_nodes.size(); ++n) {
        for (const QJsonValue& child : m_nodes[n].value(QLatin1String("children")).toArray()) {
            const std::size_t index = m_nodes.find(child);
            if (hasParent[index]) {
                throw BadGltf(nth("node", index) + " has two parents");
            }
            hasParent[index] = true;
        }
    }
    for (std::size_t s = 0; s < m_scenes.size(); ++s) {
        std::vector<bool> isRoot(m_nodes.size());
        for (const QJsonValue& root : m_scenes[s].value(QLatin1String("nodes")).toArray()) {
            const std::size_t index = m_nodes.find(root);
            if (hasParent[index] || isRoot[index]) {
                throw BadGltf(nth("node", index) + " has a parent, or stands in the scene twice");
            }
            isRoot[index] = true;
        }
    }
}

void Check::checkNodes() {
    checkParents();
    Size all;
    for (std::size_t n = 0; n < m_nodes.size(); ++n) {
        QJsonArray meshes = m_nodes[n].value(QLatin1String("meshes")).toArray();  // version 1
        if (const QJsonValue mesh = m_nodes[n].value(QLatin1String("mesh")); !mesh.isUndefined()) {
            meshes.append(mesh);
        }
        for (const QJsonValue& mesh : meshes) {
            const Size& size = m_sizes[m_meshes.find(mesh)];
            all.primitives += size.primitives;
            all.vertices += size.vertices;
            all.corners += size.corners;
        }
        if (all.primitives > kMostInstances || all.vertices > kMostVertices || all.corners > kMostCorners) {
            throw BadGltf("with all instances of its meshes it has more vertices than can be opened");
        }
    }
}

}  // namespace

Result<GltfCounts> checkGltf(std::string_view file, const QString& folder) {
    try {
        const std::string_view json = jsonOf(file);
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(
            QByteArray::fromRawData(json.data(), static_cast<qsizetype>(json.size())), &error);
        if (!document.isObject()) {
            throw BadGltf("its JSON is wrong at byte " + std::to_string(error.offset) + ": " +
                          error.errorString().toStdString());
        }
        return Check(document.object(), file.size(), folder).run();
    } catch (const BadGltf& bad) {
        return Error{std::string(bad.what()), {}, {}};
    }
}

}  // namespace hitscope
