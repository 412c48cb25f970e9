// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_objects.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

namespace hitscope {

namespace {

struct Run {
    const std::string* name = nullptr;  ///< null: before the first name
    std::uint32_t firstFace = 0;
    std::uint32_t endFace = 0;
};

std::vector<Run> objectRuns(const MeshData& mesh) {
    const auto faces = static_cast<std::uint32_t>(mesh.faceCount());
    std::vector<Run> runs;
    const auto end = [&runs](std::uint32_t face) {
        runs.back().endFace = face;
        if (runs.back().firstFace == face) {
            runs.pop_back();
        }
    };
    runs.push_back({nullptr, 0, faces});
    for (const FaceGroup& group : mesh.groups) {
        if (group.kind != FaceGroup::Kind::Object || group.firstFace >= faces) {
            continue;
        }
        end(group.firstFace);
        const bool goesOn = !runs.empty() && runs.back().name != nullptr && *runs.back().name == group.name;
        if (!goesOn) {
            runs.push_back({&group.name, group.firstFace, faces});
        } else {
            runs.back().endFace = faces;
        }
    }
    if (faces == 0) {
        runs.clear();
    }
    return runs;
}

/// Numbers of what is used, in the order of the numbers before.
class Kept {
public:
    explicit Kept(std::size_t count) : m_numbers(count, kNoIndex) {}

    void use(std::uint32_t before) { m_numbers[before] = 0; }
    void number() {
        for (std::size_t before = 0; before < m_numbers.size(); ++before) {
            if (m_numbers[before] != kNoIndex) {
                m_numbers[before] = static_cast<std::uint32_t>(m_kept.size());
                m_kept.push_back(static_cast<std::uint32_t>(before));
            }
        }
    }
    [[nodiscard]] std::uint32_t operator[](std::uint32_t before) const { return m_numbers[before]; }
    template <class Entry>
    [[nodiscard]] std::vector<Entry> of(const std::vector<Entry>& all) const {
        std::vector<Entry> kept;
        kept.reserve(m_kept.size());
        for (const std::uint32_t before : m_kept) {
            kept.push_back(all[before]);
        }
        return kept;
    }

private:
    std::vector<std::uint32_t> m_numbers;
    std::vector<std::uint32_t> m_kept;
};

/// The corners' indices of [first, end) and what they refer to, without the rest.
template <class Entry>
void takeUsed(const std::vector<std::uint32_t>& indices, std::uint32_t first, std::uint32_t end,
              const std::vector<Entry>& entries, std::vector<std::uint32_t>& madeIndices,
              std::vector<Entry>& madeEntries) {
    if (indices.empty()) {
        return;
    }
    const std::span<const std::uint32_t> wanted(indices.data() + first, end - first);
    Kept kept(entries.size());
    for (const std::uint32_t index : wanted) {
        if (index != kNoIndex) {
            kept.use(index);
        }
    }
    kept.number();
    madeIndices.reserve(wanted.size());
    for (const std::uint32_t index : wanted) {
        madeIndices.push_back(index == kNoIndex ? kNoIndex : kept[index]);
    }
    madeEntries = kept.of(entries);
}

void takeUsedImages(const std::vector<Image>& images, MeshData& made) {
    const auto forImages = [&made](const auto& call) {
        for (Material& material : made.materials) {
            call(material.diffuseImage);
            call(material.normalMap.image);
            call(material.metalRoughness.image);
        }
    };
    Kept kept(images.size());
    forImages([&kept](int image) {
        if (image >= 0) {
            kept.use(static_cast<std::uint32_t>(image));
        }
    });
    kept.number();
    forImages([&kept](int& image) {
        if (image >= 0) {
            image = static_cast<int>(kept[static_cast<std::uint32_t>(image)]);
        }
    });
    made.images = kept.of(images);
}

/// Those that faces [first, end) are in.
std::vector<FaceGroup> groupsWithin(const std::vector<FaceGroup>& groups, const std::string& object,
                                    std::uint32_t first, std::uint32_t end) {
    std::vector<FaceGroup> made;
    const FaceGroup* goesOn = nullptr;
    for (const FaceGroup& group : groups) {
        if (group.kind == FaceGroup::Kind::Group && group.firstFace <= first) {
            goesOn = &group;
        }
    }
    if (!object.empty()) {
        made.push_back({FaceGroup::Kind::Object, object, 0});
    }
    if (goesOn != nullptr) {
        made.push_back({FaceGroup::Kind::Group, goesOn->name, 0});
    }
    for (const FaceGroup& group : groups) {
        if (group.kind == FaceGroup::Kind::Group && group.firstFace > first && group.firstFace < end) {
            made.push_back({FaceGroup::Kind::Group, group.name, group.firstFace - first});
        }
    }
    return made;
}

std::vector<std::uint32_t> part(const std::vector<std::uint32_t>& all, std::uint32_t first,
                                std::uint32_t end) {
    return all.empty() ? all : std::vector<std::uint32_t>(all.begin() + first, all.begin() + end);
}

}  // namespace

std::size_t objectCount(const MeshData& mesh) {
    return objectRuns(mesh).size();
}

MeshObjects::MeshObjects(const MeshData& mesh) : m_mesh(mesh) {
    for (const Run& run : objectRuns(mesh)) {
        m_objects.push_back(
            {run.name != nullptr ? *run.name : std::string(), run.firstFace, run.endFace, {}, {}, {}});
    }
    if (!m_objects.empty()) {
        findVertices();
    }
}

void MeshObjects::findVertices() {
    std::vector<std::uint32_t> first(m_mesh.vertexCount(), kNoIndex);  // object that has a face there
    std::vector<std::uint32_t> last(m_mesh.vertexCount(), kNoIndex);   // that has taken it
    const auto take = [this, &last](std::uint32_t object, std::uint32_t vertex) {
        if (last[vertex] != object) {
            last[vertex] = object;
            m_objects[object].vertices.push_back(vertex);
        }
    };
    for (std::uint32_t object = 0; object < m_objects.size(); ++object) {
        const Object& faces = m_objects[object];
        for (std::uint32_t c = m_mesh.faceStarts[faces.firstFace]; c < m_mesh.faceStarts[faces.endFace];
             ++c) {
            const std::uint32_t vertex = m_mesh.cornerVertices[c];
            first[vertex] = std::min(first[vertex], object);
            take(object, vertex);
        }
    }
    const auto objectAt = [&first](std::uint32_t vertex) {
        return first[vertex] == kNoIndex ? 0 : first[vertex];
    };
    for (std::uint32_t line = 0; line < m_mesh.lines.size(); ++line) {
        const std::uint32_t object = m_mesh.lines[line].empty() ? 0 : objectAt(m_mesh.lines[line].front());
        m_objects[object].lines.push_back(line);
        for (const std::uint32_t vertex : m_mesh.lines[line]) {
            m_objects[object].vertices.push_back(vertex);
            last[vertex] = object;
        }
    }
    for (const std::uint32_t point : m_mesh.points) {
        const std::uint32_t object = objectAt(point);
        m_objects[object].points.push_back(point);
        m_objects[object].vertices.push_back(point);
        last[point] = object;
    }
    for (std::uint32_t vertex = 0; vertex < last.size(); ++vertex) {
        if (last[vertex] == kNoIndex) {
            m_objects.front().vertices.push_back(vertex);
        }
    }
    for (Object& object : m_objects) {
        std::sort(object.vertices.begin(), object.vertices.end());
        object.vertices.erase(std::unique(object.vertices.begin(), object.vertices.end()),
                              object.vertices.end());
    }
}

MeshData MeshObjects::only(std::size_t index) const {
    const Object& object = m_objects[index];
    MeshData made;
    made.name = object.name.empty() ? m_mesh.name : object.name;
    made.placement = m_mesh.placement;
    made.materialLibraries = m_mesh.materialLibraries;
    made.pictureFiles = m_mesh.pictureFiles;

    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    numbers.reserve(object.vertices.size());
    for (const std::uint32_t vertex : object.vertices) {
        numbers.emplace(vertex, static_cast<std::uint32_t>(numbers.size()));
        made.positions.push_back(m_mesh.positions[vertex]);
        made.sourceVertices.push_back(m_mesh.isAsRead() ? vertex : m_mesh.sourceVertices[vertex]);
        if (!m_mesh.filePositions.empty()) {
            made.filePositions.push_back(m_mesh.filePositions[vertex]);
        }
        if (!m_mesh.colours.empty()) {
            made.colours.push_back(m_mesh.colours[vertex]);
        }
    }
    const auto renumber = [&numbers](std::vector<std::uint32_t> vertices) {
        std::transform(vertices.begin(), vertices.end(), vertices.begin(),
                       [&numbers](std::uint32_t vertex) { return numbers.at(vertex); });
        return vertices;
    };

    const std::uint32_t firstCorner = m_mesh.faceStarts[object.firstFace];
    const std::uint32_t endCorner = m_mesh.faceStarts[object.endFace];
    made.faceStarts = part(m_mesh.faceStarts, object.firstFace, object.endFace + 1);
    for (std::uint32_t& start : made.faceStarts) {
        start -= firstCorner;
    }
    made.cornerVertices = renumber(part(m_mesh.cornerVertices, firstCorner, endCorner));
    takeUsed(m_mesh.cornerTexcoords, firstCorner, endCorner, m_mesh.texcoords, made.cornerTexcoords,
             made.texcoords);
    takeUsed(m_mesh.cornerNormals, firstCorner, endCorner, m_mesh.normals, made.cornerNormals, made.normals);
    takeUsed(m_mesh.faceMaterials, object.firstFace, object.endFace, m_mesh.materials, made.faceMaterials,
             made.materials);
    takeUsedImages(m_mesh.images, made);
    made.faceSmoothing = part(m_mesh.faceSmoothing, object.firstFace, object.endFace);
    made.groups = groupsWithin(m_mesh.groups, object.name, object.firstFace, object.endFace);

    for (const std::uint32_t line : object.lines) {
        made.lines.push_back(renumber(m_mesh.lines[line]));
    }
    made.points = renumber(object.points);
    return made;
}

}  // namespace hitscope
