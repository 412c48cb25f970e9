// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/gltf_morphs.h"

#include <algorithm>

#include "core/finite.h"
#include "core/give_up.h"
#include "io/writers/file_positions.h"

namespace hitscope {
namespace {

/// File vertices of which a corner's normal turned.
std::vector<bool> turnedVertices(const MeshExport& what, std::span<const glm::vec3> originals) {
    std::vector<bool> turned(what.mesh->positions.size());
    for (std::size_t c = 0; c < what.normals.size(); ++c) {
        mayGiveUp(c);
        if (!sameBits(what.normals[c], originals[c])) {
            turned[what.mesh->cornerVertices[c]] = true;
        }
    }
    return turned;
}

/// For each vertex the last step that moved it or, where none did, one that moved a vertex of its faces;
/// kNoIndex: none.
std::vector<std::uint32_t> lastSteps(const MeshData& mesh, const std::vector<MorphTarget>& steps) {
    std::vector<std::uint32_t> own(mesh.positions.size(), kNoIndex);
    for (std::uint32_t s = 0; s < steps.size(); ++s) {
        for (const MorphDelta& delta : steps[s].deltas) {
            mayGiveUp(delta.vertex);
            own[delta.vertex] = s;
        }
    }
    std::vector<std::uint32_t> last = own;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        mayGiveUp(f);
        std::uint32_t latest = kNoIndex;
        for (const std::uint32_t vertex : mesh.face(f)) {
            const bool isLater = own[vertex] != kNoIndex && (latest == kNoIndex || own[vertex] > latest);
            latest = isLater ? own[vertex] : latest;
        }
        for (const std::uint32_t vertex : mesh.face(f)) {
            const bool isRim = own[vertex] == kNoIndex && latest != kNoIndex;
            last[vertex] =
                isRim && (last[vertex] == kNoIndex || latest > last[vertex]) ? latest : last[vertex];
        }
    }
    return last;
}

void sortByVertex(MorphTarget& target) {
    sortWatched(target.deltas.begin(), target.deltas.end(),
                [](const MorphDelta& a, const MorphDelta& b) { return a.vertex < b.vertex; });
}

/// The part of how normals turn that each step has: by how far it moves a vertex.
void shareTurning(const MeshData& mesh, const MorphTarget& deformed, std::vector<MorphTarget>& steps) {
    const std::vector<std::uint32_t> last = lastSteps(mesh, steps);
    std::vector<float> ways(mesh.positions.size());
    for (const MorphTarget& step : steps) {
        for (const MorphDelta& delta : step.deltas) {
            mayGiveUp(delta.vertex);
            ways[delta.vertex] += glm::length(delta.moved);
        }
    }
    for (MorphTarget& step : steps) {
        for (MorphDelta& delta : step.deltas) {
            mayGiveUp(delta.vertex);
            const float way = ways[delta.vertex];
            delta.turned = way > 0.0f ? glm::length(delta.moved) / way : 0.0f;
        }
    }
    const auto lastStep = static_cast<std::uint32_t>(steps.size() - 1);
    for (const MorphDelta& delta : deformed.deltas) {
        mayGiveUp(delta.vertex);
        if (!(ways[delta.vertex] > 0.0f)) {
            const std::uint32_t at = last[delta.vertex] == kNoIndex ? lastStep : last[delta.vertex];
            steps[at].deltas.push_back({delta.vertex, glm::vec3(0.0f), 1.0f});
        }
    }
    std::for_each(steps.begin(), steps.end(), sortByVertex);
}

/// A glTF vertex and which delta it has.
struct Entry {
    std::uint32_t slot;
    std::uint32_t delta;
};

/// Index of a vertex's delta; kNoIndex: it has none.
std::uint32_t deltaOf(const MorphTarget& target, std::uint32_t vertex) {
    const auto found =
        std::lower_bound(target.deltas.begin(), target.deltas.end(), vertex,
                         [](const MorphDelta& delta, std::uint32_t v) { return delta.vertex < v; });
    const bool has = found != target.deltas.end() && found->vertex == vertex;
    return has ? static_cast<std::uint32_t>(found - target.deltas.begin()) : kNoIndex;
}

/// At the cost of the primitive or of the target, whichever is smaller: there may be many of both.
std::vector<Entry> entriesOf(const GltfPrimitive& primitive, const MorphTarget& target) {
    std::vector<Entry> entries;
    if (primitive.fileVertices.size() < target.deltas.size()) {
        for (std::uint32_t slot = 0; slot < primitive.fileVertices.size(); ++slot) {
            mayGiveUp(slot);
            const std::uint32_t delta = deltaOf(target, primitive.fileVertices[slot]);
            if (delta != kNoIndex) {
                entries.push_back({slot, delta});
            }
        }
        return entries;
    }
    std::vector<std::uint32_t> slots;
    for (std::uint32_t d = 0; d < target.deltas.size(); ++d) {
        mayGiveUp(d);
        slots.clear();
        primitive.findVertices(target.deltas[d].vertex, slots);
        for (const std::uint32_t slot : slots) {
            entries.push_back({slot, d});
        }
    }
    sortWatched(entries.begin(), entries.end(),
                [](const Entry& a, const Entry& b) { return a.slot < b.slot; });
    return entries;
}

/// The deltas of a primitive, position or normal.
class Deltas {
public:
    Deltas(const GltfPrimitive& primitive, const MorphTarget& target, const MeshExport& what,
           std::span<const glm::vec3> originals)
        : m_primitive(primitive), m_target(target), m_what(what), m_originals(originals) {}

    [[nodiscard]] glm::vec3 position(const Entry& entry) const { return m_target.deltas[entry.delta].moved; }
    [[nodiscard]] glm::vec3 normal(const Entry& entry) const {
        const std::uint32_t corner = m_primitive.corners[entry.slot];
        if (corner == kNoIndex) {
            return glm::vec3(0.0f);
        }
        const glm::vec3 turned = unitNormal(m_what.normals[corner]) - unitNormal(m_originals[corner]);
        return m_target.deltas[entry.delta].turned * turned;
    }

private:
    const GltfPrimitive& m_primitive;
    const MorphTarget& m_target;
    const MeshExport& m_what;
    std::span<const glm::vec3> m_originals;
};

using Entries = std::shared_ptr<const std::vector<Entry>>;
using DeltaOf = std::function<glm::vec3(const Entry&)>;

int addSparse(GltfDocument& document, std::size_t count, const Entries& entries, int indices,
              const DeltaOf& delta, QJsonObject more) {
    const std::size_t size = entries->size();
    const int values = document.addView(
        size, sizeof(glm::vec3), gltf::kNeither,
        [entries, delta](PieceWriter& out, std::size_t i) { out.plain(delta((*entries)[i])); });
    more[QStringLiteral("sparse")] = QJsonObject{
        {QStringLiteral("count"), static_cast<qint64>(size)},
        {QStringLiteral("indices"), QJsonObject{{QStringLiteral("bufferView"), indices},
                                                {QStringLiteral("componentType"), gltf::kUint32}}},
        {QStringLiteral("values"), QJsonObject{{QStringLiteral("bufferView"), values}}}};
    return document.addAccessor(-1, gltf::kFloat, "VEC3", count, more);
}

int addDense(GltfDocument& document, std::size_t count, const Entries& entries, const DeltaOf& delta,
             const QJsonObject& more) {
    const int view =
        document.addView(count, sizeof(glm::vec3), gltf::kVertices,
                         [entries, delta, next = std::size_t{0}](PieceWriter& out, std::size_t i) mutable {
                             next = i == 0 ? 0 : next;
                             const bool has = next < entries->size() && (*entries)[next].slot == i;
                             out.plain(has ? delta((*entries)[next]) : glm::vec3(0.0f));
                             next += has ? 1 : 0;
                         });
    return document.addAccessor(view, gltf::kFloat, "VEC3", count, more);
}

QJsonObject limitsOf(const std::vector<Entry>& entries, std::size_t count, const DeltaOf& delta) {
    const bool allMove = entries.size() == count;
    glm::vec3 least = allMove ? delta(entries.front()) : glm::vec3(0.0f);
    glm::vec3 most = least;
    for (const Entry& entry : entries) {
        mayGiveUp(entry.slot);
        const glm::vec3 value = delta(entry);
        least = glm::min(least, value);
        most = glm::max(most, value);
    }
    return {{QStringLiteral("min"), jsonOf(least)}, {QStringLiteral("max"), jsonOf(most)}};
}

}  // namespace

glm::vec3 unitNormal(const glm::vec3& normal) {
    const float length = glm::length(normal);
    return isFinite(normal) && length > 0.0f ? normal / length : glm::vec3(0.0f, 0.0f, 1.0f);
}

MorphTarget deformedTarget(const MeshExport& what, std::span<const glm::vec3> originalNormals) {
    const FilePositions positions(what);
    const std::vector<bool> turned = turnedVertices(what, originalNormals);
    MorphTarget target{"Deformed", {}};
    for (std::uint32_t v = 0; v < what.positions.size(); ++v) {
        mayGiveUp(v);
        if (positions.isMoved(v) || turned[v]) {
            const glm::dvec3 from(glm::vec3(positions.original(v)));
            const glm::dvec3 to(glm::vec3(positions.now(v)));
            target.deltas.push_back({v, glm::vec3(to - from), 1.0f});
        }
    }
    return target;
}

std::vector<MorphTarget> stepTargets(const MeshExport& what, const MorphTarget& deformed,
                                     const std::function<void(double)>& told) {
    std::vector<MorphTarget> targets;
    if (what.steps.empty() || deformed.deltas.empty()) {
        return targets;
    }
    const FilePositions positions(what);
    const MeshData& mesh = *what.mesh;
    PageVector<glm::vec3> at = mesh.positions;
    const auto add = [&](MorphTarget& target, std::uint32_t vertex, const glm::vec3& to) {
        if (!sameBits(at[vertex], to)) {
            const glm::dvec3 moved = (glm::dvec3(to) - glm::dvec3(at[vertex])) / mesh.placement.scale;
            target.deltas.push_back({vertex, glm::vec3(moved), 0.0f});
            at[vertex] = to;
        }
    };
    for (const MorphStep& step : what.steps) {
        MorphTarget& target = targets.emplace_back(MorphTarget{step.name, {}});
        for (const MovedVertex& moved : step.moved) {
            mayGiveUp(moved.vertex);
            add(target, moved.vertex, moved.position);
        }
        told(0.5 * static_cast<double>(targets.size()) / static_cast<double>(what.steps.size()));
    }
    // The steps are the reference's, the shape is the pipeline's: they may differ in last digits.
    std::vector<MorphDelta>& last = targets.back().deltas;
    sortByVertex(targets.back());
    const std::size_t known = last.size();
    for (std::uint32_t v = 0; v < at.size(); ++v) {
        mayGiveUp(v);
        if (sameBits(at[v], what.positions[v])) {
            continue;
        }
        const auto end = last.begin() + static_cast<std::ptrdiff_t>(known);
        const auto found =
            std::lower_bound(last.begin(), end, v,
                             [](const MorphDelta& d, std::uint32_t vertex) { return d.vertex < vertex; });
        const glm::vec3 rest((glm::dvec3(what.positions[v]) - glm::dvec3(at[v])) / mesh.placement.scale);
        if (found != end && found->vertex == v) {
            found->moved += rest;
        } else {
            last.push_back({v, rest, 0.0f});
        }
    }
    shareTurning(mesh, deformed, targets);
    return targets;
}

bool isReached(const GltfPrimitive& primitive, const MorphTarget& target) {
    if (primitive.fileVertices.size() < target.deltas.size()) {
        std::uint32_t slot = 0;
        return std::ranges::any_of(primitive.fileVertices, [&](std::uint32_t vertex) {
            mayGiveUp(slot++);
            return deltaOf(target, vertex) != kNoIndex;
        });
    }
    std::vector<std::uint32_t> slots;
    return std::ranges::any_of(target.deltas, [&](const MorphDelta& delta) {
        mayGiveUp(delta.vertex);
        primitive.findVertices(delta.vertex, slots);
        return !slots.empty();
    });
}

QJsonObject addMorph(GltfDocument& document, const GltfPrimitive& primitive, const MorphTarget& target,
                     const MeshExport& what, std::span<const glm::vec3> originalNormals) {
    std::vector<Entry> found = entriesOf(primitive, target);
    const bool isStill = found.empty();
    if (isStill) {
        found.push_back({0, 0});  // an accessor of nothing but zeros has one that says so
    }
    const auto entries = std::make_shared<const std::vector<Entry>>(std::move(found));
    const auto deltas = std::make_shared<const Deltas>(primitive, target, what, originalNormals);
    const DeltaOf position = [deltas, isStill](const Entry& entry) {
        return isStill ? glm::vec3(0.0f) : deltas->position(entry);
    };
    const DeltaOf normal = [deltas, isStill](const Entry& entry) {
        return isStill ? glm::vec3(0.0f) : deltas->normal(entry);
    };
    const std::size_t count = primitive.fileVertices.size();
    const QJsonObject limits = limitsOf(*entries, count, position);
    const bool hasNormals = !what.normals.empty() && primitive.kind == GltfPrimitive::Kind::Triangles;
    QJsonObject result;
    if (4 * entries->size() < 3 * count) {
        const int indices =
            document.addView(entries->size(), sizeof(std::uint32_t), gltf::kNeither,
                             [entries](PieceWriter& out, std::size_t i) { out.plain((*entries)[i].slot); });
        result[QStringLiteral("POSITION")] = addSparse(document, count, entries, indices, position, limits);
        if (hasNormals) {
            result[QStringLiteral("NORMAL")] = addSparse(document, count, entries, indices, normal, {});
        }
    } else {
        result[QStringLiteral("POSITION")] = addDense(document, count, entries, position, limits);
        if (hasNormals) {
            result[QStringLiteral("NORMAL")] = addDense(document, count, entries, normal, {});
        }
    }
    return result;
}

}  // namespace hitscope
