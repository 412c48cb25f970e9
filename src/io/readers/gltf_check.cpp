// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_check.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <optional>
#include <vector>

#include "io/file_scope.h"
#include "io/readers/gltf_json.h"
#include "io/readers/import_bounds.h"

namespace hitscope {
namespace {

class Check {
public:
    Check(const QJsonObject& root, std::size_t fileSize, const QString& folder)
        : m_root(root), m_fileSize(fileSize), m_folder(folder) {}

    GltfCounts run() {
        checkBuffers();
        checkAccessors();
        checkMeshes();
        checkNodes();
        return {trianglesInScene()};
    }

private:
    struct Size {
        std::uint64_t primitives = 0;
        std::uint64_t vertices = 0;
        std::uint64_t corners = 0;
        std::uint64_t triangles = 0;
    };

    [[nodiscard]] std::uint64_t bytesThere(const QJsonObject& buffer) const;
    void checkBuffers();
    void checkAccessors();
    void checkMeshes();
    void checkNodes();
    void checkParents();
    [[nodiscard]] QJsonArray meshesOf(std::size_t node) const;
    [[nodiscard]] std::uint64_t trianglesInScene() const;
    Size sizeOf(const QJsonObject& primitive);
    std::uint64_t countOf(const QJsonObject& attributes, std::optional<std::uint64_t> wanted);

    QJsonObject m_root;
    std::uint64_t m_fileSize;
    QString m_folder;
    GltfThings m_buffers{m_root, "buffers", "a buffer"};
    GltfThings m_views{m_root, "bufferViews", "a buffer view"};
    GltfThings m_accessors{m_root, "accessors", "an accessor"};
    GltfThings m_meshes{m_root, "meshes", "a mesh"};
    GltfThings m_nodes{m_root, "nodes", "a node"};
    GltfThings m_scenes{m_root, "scenes", "a scene"};
    std::vector<std::uint64_t> m_bufferBytes;
    std::vector<Size> m_sizes;  ///< of each mesh
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
        m_bufferBytes.push_back(std::min(there, gltfNumber(m_buffers[b], "byteLength", there)));
    }
    for (std::size_t v = 0; v < m_views.size(); ++v) {
        const std::uint64_t buffer = m_bufferBytes[m_buffers.find(m_views[v].value(QLatin1String("buffer")))];
        const bool hasLength =
            m_views[v].contains(QLatin1String("byteLength"));  // version 1 may leave it out
        const std::uint64_t end =
            gltfNumber(m_views[v], "byteOffset") + (hasLength ? gltfNumber(m_views[v], "byteLength") : 0);
        if (end > buffer) {
            throw BadGltf(nthOfGltf("buffer view", v) + " goes on behind the end of its buffer");
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
        const std::uint64_t element = gltfComponentBytes(accessor) * gltfComponentCount(accessor);
        const std::uint64_t count = gltfNumber(accessor, "count");
        const QJsonValue view = accessor.value(QLatin1String("bufferView"));
        if (view.isUndefined()) {
            if (count > mostZeros / element) {
                throw BadGltf(nthOfGltf("accessor", a) + " promises " + std::to_string(count) +
                              " values, of which the file holds none");
            }
            continue;
        }
        const QJsonObject& from = m_views[m_views.find(view)];
        const std::uint64_t wholeBuffer = m_bufferBytes[m_buffers.find(from.value(QLatin1String("buffer")))];
        const std::uint64_t length =
            gltfNumber(from, "byteLength", wholeBuffer - gltfNumber(from, "byteOffset"));
        const std::uint64_t stride =
            std::max(gltfNumber(from, "byteStride"), gltfNumber(accessor, "byteStride"));
        const std::uint64_t step = stride == 0 ? element : stride;
        const std::uint64_t offset = gltfNumber(accessor, "byteOffset");
        if (count > 0 && (offset + element > length || (length - offset - element) / step < count - 1)) {
            throw BadGltf(nthOfGltf("accessor", a) + " goes on behind the end of its buffer view");
        }
    }
}

/// How many values each of the attributes has; all the same number.
std::uint64_t Check::countOf(const QJsonObject& attributes, std::optional<std::uint64_t> wanted) {
    for (auto it = attributes.begin(); it != attributes.end(); ++it) {
        const std::uint64_t count = gltfNumber(m_accessors[m_accessors.find(it.value())], "count");
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
        indices.isUndefined() ? vertices : gltfNumber(m_accessors[m_accessors.find(indices)], "count");
    constexpr std::uint64_t kTriangles = 4;
    const std::uint64_t mode = gltfNumber(primitive, "mode", kTriangles);
    if (mode > 6) {
        throw BadGltf("a mesh is of the mode " + std::to_string(mode) + ", of which glTF has 0 to 6");
    }
    const std::uint64_t least = mode == 0 ? 1 : mode < kTriangles ? 2 : 3;
    if (corners < least && primitive.value(QLatin1String("attributes")).toObject().size() > 0) {
        throw BadGltf("a mesh has fewer vertices than one of its faces");
    }
    const std::uint64_t triangles = mode < kTriangles    ? 0
                                    : mode == kTriangles ? corners / 3
                                                         : corners - std::min<std::uint64_t>(corners, 2);
    return {1, vertices, corners, triangles};
}

void Check::checkMeshes() {
    for (std::size_t m = 0; m < m_meshes.size(); ++m) {
        Size all;
        for (const QJsonValue& each : m_meshes[m].value(QLatin1String("primitives")).toArray()) {
            const Size size = sizeOf(each.toObject());
            all.primitives += size.primitives;
            all.vertices += size.vertices;
            all.corners += size.corners;
            all.triangles += size.triangles;
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
                throw BadGltf(nthOfGltf("node", index) + " has two parents");
            }
            hasParent[index] = true;
        }
    }
    for (std::size_t s = 0; s < m_scenes.size(); ++s) {
        std::vector<bool> isRoot(m_nodes.size());
        for (const QJsonValue& root : m_scenes[s].value(QLatin1String("nodes")).toArray()) {
            const std::size_t index = m_nodes.find(root);
            if (hasParent[index] || isRoot[index]) {
                throw BadGltf(nthOfGltf("node", index) + " has a parent, or stands in the scene twice");
            }
            isRoot[index] = true;
        }
    }
}

QJsonArray Check::meshesOf(std::size_t node) const {
    QJsonArray meshes = m_nodes[node].value(QLatin1String("meshes")).toArray();  // version 1
    if (const QJsonValue mesh = m_nodes[node].value(QLatin1String("mesh")); !mesh.isUndefined()) {
        meshes.append(mesh);
    }
    return meshes;
}

void Check::checkNodes() {
    checkParents();
    Size all;
    for (std::size_t n = 0; n < m_nodes.size(); ++n) {
        for (const QJsonValue& mesh : meshesOf(n)) {
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

/// Assimp reads the meshes of one scene alone. BadGltf: it has none of those that there are.
std::uint64_t Check::trianglesInScene() const {
    constexpr const char* kAdvice =
        "Put the meshes into the scene in the program it came from, and export it again.";
    if (m_meshes.size() > 0 && m_nodes.size() == 0) {
        throw BadGltf("it has no nodes, so that nothing places its meshes", kAdvice);
    }
    if (m_meshes.size() == 0 || m_scenes.size() == 0) {
        return 0;
    }
    const QJsonValue shown = m_root.value(QLatin1String("scene"));
    const QJsonObject& scene = m_scenes[shown.isUndefined() ? 0 : m_scenes.find(shown)];
    std::vector<std::size_t> open;
    for (const QJsonValue& node : scene.value(QLatin1String("nodes")).toArray()) {
        open.push_back(m_nodes.find(node));
    }
    if (open.empty()) {
        throw BadGltf("its scene is empty", kAdvice);
    }
    std::vector<bool> isThere(m_meshes.size(), false);
    std::uint64_t triangles = 0;
    bool hasMesh = false;
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        for (const QJsonValue& mesh : meshesOf(node)) {
            const std::size_t index = m_meshes.find(mesh);
            triangles += isThere[index] ? 0 : m_sizes[index].triangles;
            isThere[index] = true;
            hasMesh = true;
        }
        for (const QJsonValue& child : m_nodes[node].value(QLatin1String("children")).toArray()) {
            open.push_back(m_nodes.find(child));
        }
    }
    if (!hasMesh) {
        throw BadGltf("no node of its scene has a mesh", kAdvice);
    }
    return triangles;
}

}  // namespace

GltfCounts checkGltf(const QJsonObject& root, std::size_t fileSize, const QString& folder) {
    return Check(root, fileSize, folder).run();
}

}  // namespace hitscope
