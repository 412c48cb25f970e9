// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/merge_targets.h"

#include <QFileInfo>
#include <algorithm>
#include <unordered_set>

#include "core/give_up.h"
#include "io/writers/world_frame.h"
#include "mesh/corner_normals.h"
#include "mesh/same_bits.h"

namespace hitscope {
namespace {

std::uint32_t shifted(std::uint32_t index, std::size_t by) {
    return index == kNoIndex ? kNoIndex : static_cast<std::uint32_t>(index + by);
}

QString folderOf(const PlacedTarget& target) {
    return target.sourcePath.isEmpty() ? QString() : QFileInfo(target.sourcePath).absolutePath();
}

/// Which of the optional things any of the targets has: the others get what stands for none.
struct Has {
    bool texcoords = false;
    bool cornerNormals = false;
    bool normals = false;
    bool materials = false;
    bool smoothing = false;
    bool colours = false;
    bool groups = false;
    bool hits = true;
    bool oneFolder = true;

    explicit Has(std::span<const PlacedTarget> targets) {
        for (const PlacedTarget& target : targets) {
            const MeshData& mesh = *target.mesh;
            texcoords = texcoords || !mesh.cornerTexcoords.empty();
            cornerNormals = cornerNormals || !mesh.cornerNormals.empty();
            normals = normals || !target.normals.empty();
            materials = materials || !mesh.faceMaterials.empty();
            smoothing = smoothing || !mesh.faceSmoothing.empty();
            colours = colours || !mesh.colours.empty();
            groups = groups || !mesh.groups.empty();
            hits = hits && !target.hits.empty();
            oneFolder = oneFolder && folderOf(target) == folderOf(targets.front());
        }
    }
};

class Merger {
public:
    explicit Merger(std::span<const PlacedTarget> targets) : m_targets(targets), m_has(targets) {}

    MergedTargets merge();

private:
    void makeRoom();
    void addVertices(const PlacedTarget& target);
    void addFaces(const PlacedTarget& target);
    void addNormals(const PlacedTarget& target);
    void addGroups(const PlacedTarget& target);
    void addMaterials(const PlacedTarget& target);
    void addLines(const MeshData& mesh);
    void addSteps(const PlacedTarget& target);
    [[nodiscard]] std::string freeName(const std::string& name);

    std::span<const PlacedTarget> m_targets;
    Has m_has;
    MergedTargets m_merged;
    MeshData& m_mesh = m_merged.mesh;
    std::unordered_set<std::string> m_names;
    std::size_t m_firstVertex = 0;  ///< of the target being added
    std::size_t m_firstFace = 0;
};

void Merger::addVertices(const PlacedTarget& target) {
    const MeshData& mesh = *target.mesh;
    const WorldFrame frame(target.transform);
    m_firstVertex = m_mesh.positions.size();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        mayGiveUp(v);
        const glm::vec3 original = frame.position(mesh.positions[v]);
        const bool isMoved = !sameBits(mesh.positions[v], target.positions[v]);
        m_mesh.positions.push_back(original);
        m_merged.positions.push_back(isMoved ? frame.position(target.positions[v]) : original);
    }
    if (std::ranges::any_of(m_targets, [](const PlacedTarget& one) { return !one.mesh->isAsRead(); })) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            mayGiveUp(v);
            m_mesh.sourceVertices.push_back(mesh.isAsRead() ? static_cast<std::uint32_t>(v)
                                                            : mesh.sourceVertices[v]);
        }
    }
    for (std::size_t v = 0; m_has.colours && v < mesh.positions.size(); ++v) {
        mayGiveUp(v);
        m_mesh.colours.push_back(mesh.colours.empty() ? glm::vec3(1.0f) : mesh.colours[v]);
    }
    if (m_has.hits) {
        m_merged.hits.insert(m_merged.hits.end(), target.hits.begin(), target.hits.end());
    }
}

void Merger::addFaces(const PlacedTarget& target) {
    const MeshData& mesh = *target.mesh;
    const std::size_t corners = mesh.cornerVertices.size();
    m_firstFace = m_mesh.faceCount();
    const std::size_t firstCorner = m_mesh.cornerVertices.size();
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        mayGiveUp(f);
        m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(firstCorner + mesh.faceStarts[f + 1]));
        if (m_has.materials) {
            const std::uint32_t own = mesh.faceMaterials.empty() ? kNoIndex : mesh.faceMaterials[f];
            m_mesh.faceMaterials.push_back(shifted(own, m_mesh.materials.size()));
        }
        if (m_has.smoothing) {
            m_mesh.faceSmoothing.push_back(mesh.faceSmoothing.empty() ? 1 : mesh.faceSmoothing[f]);
        }
    }
    for (std::size_t c = 0; c < corners; ++c) {
        mayGiveUp(c);
        m_mesh.cornerVertices.push_back(shifted(mesh.cornerVertices[c], m_firstVertex));
        if (m_has.texcoords) {
            const std::uint32_t own = mesh.cornerTexcoords.empty() ? kNoIndex : mesh.cornerTexcoords[c];
            m_mesh.cornerTexcoords.push_back(shifted(own, m_mesh.texcoords.size()));
        }
        if (m_has.cornerNormals) {
            const std::uint32_t own = mesh.cornerNormals.empty() ? kNoIndex : mesh.cornerNormals[c];
            m_mesh.cornerNormals.push_back(shifted(own, m_mesh.normals.size()));
        }
    }
    m_mesh.texcoords.insert(m_mesh.texcoords.end(), mesh.texcoords.begin(), mesh.texcoords.end());
}

void Merger::addNormals(const PlacedTarget& target) {
    const WorldFrame frame(target.transform);
    for (const glm::vec3& normal : target.mesh->normals) {
        mayGiveUp(m_mesh.normals.size());
        m_mesh.normals.push_back(frame.normal(normal));
    }
    if (m_has.normals && target.normals.empty()) {
        for (const glm::vec3& normal : cornerNormals(*target.mesh, kCreaseAngle)) {
            m_merged.normals.push_back(frame.normal(normal));
        }
    }
    for (const glm::vec3& normal : target.normals) {
        mayGiveUp(m_merged.normals.size());
        m_merged.normals.push_back(frame.normal(normal));
    }
}

std::string Merger::freeName(const std::string& name) {
    std::string free = name.empty() ? "target" : name;
    for (int n = 2; !m_names.insert(free).second; ++n) {
        free = name + "_" + std::to_string(n);
    }
    return free;
}

/// A group goes on until the next one: a target without any ends the one before.
void Merger::addGroups(const PlacedTarget& target) {
    const std::string name = freeName(target.name.empty() ? target.mesh->name : target.name);
    const auto first = static_cast<std::uint32_t>(m_firstFace);
    m_mesh.groups.push_back({FaceGroup::Kind::Object, name, first});
    const std::vector<FaceGroup>& groups = target.mesh->groups;
    if (m_has.groups && (groups.empty() || groups.front().firstFace > 0)) {
        m_mesh.groups.push_back({FaceGroup::Kind::Group, name, first});
    }
    for (const FaceGroup& group : groups) {
        m_mesh.groups.push_back({FaceGroup::Kind::Group, group.name, first + group.firstFace});
    }
}

/// Without a folder for all, pictures are those that were read, by their index.
void Merger::addMaterials(const PlacedTarget& target) {
    const auto shift = [first = static_cast<int>(m_mesh.images.size())](int& image) {
        image = image < 0 ? image : image + first;
    };
    for (Material material : target.mesh->materials) {
        shift(material.diffuseImage);
        shift(material.normalMap.image);
        shift(material.metalRoughness.image);
        m_mesh.materials.push_back(std::move(material));
    }
    m_mesh.images.insert(m_mesh.images.end(), target.mesh->images.begin(), target.mesh->images.end());
    for (const std::string& picture : target.mesh->pictureFiles) {
        const bool isKnown = std::find(m_mesh.pictureFiles.begin(), m_mesh.pictureFiles.end(), picture) !=
                             m_mesh.pictureFiles.end();
        if (m_has.oneFolder && !isKnown) {
            m_mesh.pictureFiles.push_back(picture);
        }
    }
}

void Merger::addLines(const MeshData& mesh) {
    for (std::vector<std::uint32_t> line : mesh.lines) {
        for (std::uint32_t& vertex : line) {
            vertex = shifted(vertex, m_firstVertex);
        }
        m_mesh.lines.push_back(std::move(line));
    }
    for (const std::uint32_t vertex : mesh.points) {
        m_mesh.points.push_back(shifted(vertex, m_firstVertex));
    }
}

void Merger::addSteps(const PlacedTarget& target) {
    const WorldFrame frame(target.transform);
    for (std::size_t s = 0; s < target.steps.size(); ++s) {
        if (s == m_merged.steps.size()) {
            m_merged.steps.push_back({target.steps[s].name, {}});
        }
        std::vector<MovedVertex>& all = m_merged.steps[s].moved;
        all.reserve(all.size() + target.steps[s].moved.size());
        for (const MovedVertex& moved : target.steps[s].moved) {
            mayGiveUp(all.size());
            all.push_back({shifted(moved.vertex, m_firstVertex), frame.position(moved.position)});
        }
    }
}

/// Large arrays are not to be copied while they grow.
void Merger::makeRoom() {
    std::size_t vertices = 0;
    std::size_t corners = 0;
    for (const PlacedTarget& target : m_targets) {
        vertices += target.mesh->positions.size();
        corners += target.mesh->cornerVertices.size();
    }
    m_mesh.positions.reserve(vertices);
    m_merged.positions.reserve(vertices);
    m_mesh.cornerVertices.reserve(corners);
    m_mesh.cornerTexcoords.reserve(m_has.texcoords ? corners : 0);
    m_mesh.cornerNormals.reserve(m_has.cornerNormals ? corners : 0);
    m_merged.normals.reserve(m_has.normals ? corners : 0);
}

MergedTargets Merger::merge() {
    m_mesh.name = m_targets.size() == 1 ? m_targets.front().mesh->name : "targets";
    makeRoom();
    m_mesh.faceStarts.push_back(0);
    for (const PlacedTarget& target : m_targets) {
        addVertices(target);
        addFaces(target);
        addNormals(target);
        addGroups(target);
        addMaterials(target);
        addLines(*target.mesh);
        addSteps(target);
    }
    if (m_has.oneFolder && !m_targets.empty()) {
        m_merged.sourceFolder = folderOf(m_targets.front());
    }
    return std::move(m_merged);
}

}  // namespace

MeshExport MergedTargets::what() const {
    MeshExport what;
    what.mesh = &mesh;
    what.positions = positions;
    what.normals = normals;
    what.hits = hits;
    what.steps = steps;
    what.sourceFolder = sourceFolder;
    return what;
}

MergedTargets placeTarget(const PlacedTarget& target) {
    const WorldFrame frame(target.transform);
    MergedTargets one;
    one.mesh = *target.mesh;
    one.mesh.placement = Placement();
    one.mesh.filePositions = {};
    one.positions.resize(target.positions.size());
    for (std::size_t v = 0; v < target.positions.size(); ++v) {
        mayGiveUp(v);
        const glm::vec3& original = target.mesh->positions[v];
        one.mesh.positions[v] = frame.position(original);
        one.positions[v] = sameBits(original, target.positions[v]) ? one.mesh.positions[v]
                                                                   : frame.position(target.positions[v]);
    }
    for (glm::vec3& normal : one.mesh.normals) {
        normal = frame.normal(normal);
    }
    one.normals.assign(target.normals.begin(), target.normals.end());
    for (glm::vec3& normal : one.normals) {
        mayGiveUp(static_cast<std::size_t>(&normal - one.normals.data()));
        normal = frame.normal(normal);
    }
    one.hits.assign(target.hits.begin(), target.hits.end());
    one.steps.assign(target.steps.begin(), target.steps.end());
    for (MorphStep& step : one.steps) {
        for (MovedVertex& moved : step.moved) {
            moved.position = frame.position(moved.position);
        }
    }
    one.sourceFolder = folderOf(target);
    return one;
}

Result<MergedTargets> mergeTargets(std::span<const PlacedTarget> targets) {
    std::uint64_t vertices = 0;
    std::uint64_t corners = 0;
    for (const PlacedTarget& target : targets) {
        vertices += target.mesh->positions.size();
        corners += target.mesh->cornerVertices.size();
        const bool fits =
            target.positions.size() == target.mesh->positions.size() &&
            (target.normals.empty() || target.normals.size() == target.mesh->cornerVertices.size()) &&
            (target.hits.empty() || target.hits.size() == target.mesh->positions.size());
        if (!fits) {
            return Error{
                "The deformed mesh and its original do not have the same vertices.", target.name, {}};
        }
    }
    if (vertices >= kNoIndex || corners >= kNoIndex) {
        return Error{"Together the targets have more vertices or face corners than can be counted.",
                     {},
                     "Write each target to a file of its own."};
    }
    return Merger(targets).merge();
}

}  // namespace hitscope
