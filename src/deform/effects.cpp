// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/effects.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "core/give_up.h"
#include "core/offset.h"
#include "deform/deform.h"

namespace hitscope {

namespace {

constexpr std::size_t kClustersBetween = 512;  // looks whether to go on

/// Differs from whatever a hit may turn out to have done.
constexpr HitEffect kNotYet{kNoIndex, 0.0f, kNoIndex};

float distanceBetween(const glm::vec3& before, const glm::vec3& after) {
    const glm::dvec3 way = glm::dvec3(after) - glm::dvec3(before);
    return static_cast<float>(std::sqrt(glm::dot(way, way)));
}

/// Takes another vertex, or what was done to others, into account.
void add(HitEffect& effect, const HitEffect& more) {
    effect.affected += more.affected;
    if (more.greatest > effect.greatest ||
        (more.greatest == effect.greatest && more.deepest < effect.deepest)) {
        effect.greatest = more.greatest;
        effect.deepest = more.deepest;
    }
}

bool putAtTheEnd(std::span<const TargetHitsEdit> edits, std::size_t size) {
    return std::all_of(edits.begin(), edits.end(), [&size](const TargetHitsEdit& edit) {
        const bool isAppend = edit.before.empty() && edit.first == size;
        size += edit.after.size();
        return isAppend;
    });
}

}  // namespace

TargetEffects::TargetEffects(std::shared_ptr<const RenderMesh> mesh)
    : m_mesh(std::move(mesh)),
      m_vertices(*m_mesh),
      m_reach(*m_mesh),
      m_counts(m_mesh->fileVertexStarts.empty() ? 0 : m_mesh->fileVertexStarts.size() - 1) {}

/// A file vertex may have several render vertices, which hits move alike: one of them stands for it.
bool TargetEffects::isFirstOf(std::uint32_t renderVertex) const {
    const std::uint32_t fileVertex = m_mesh->fileVertices[renderVertex];
    return m_mesh->fileVertexRender[m_mesh->fileVertexStarts[fileVertex]] == renderVertex;
}

TargetEffects::Changes TargetEffects::follow(std::span<const TargetHitsEdit> edits, std::span<const Hit> hits,
                                             const std::atomic<bool>& stop) {
    Changes changes;
    const std::size_t before = m_effects.size();
    const bool appends = putAtTheEnd(edits, before);
    std::for_each(edits.begin(), edits.end(), [this](const TargetHitsEdit& edit) { splice(edit); });
    if (appends) {
        append(before, hits, stop, changes);
        return changes;
    }
    const std::vector<std::uint32_t> concerned =
        m_keepsParts ? concernedBy(edits) : std::vector<std::uint32_t>();
    if (!m_keepsParts || 2 * concerned.size() > m_mesh->clusters.size()) {
        startOver(hits, stop, changes);
    } else {
        redo(concerned, hits, stop, changes);
    }
    return changes;
}

/// The clusters where a hit put in or taken out may make a difference. Where the vertices have been so far is
/// enough to tell, however many edits there are: those in other clusters go the same way after each of them.
std::vector<std::uint32_t> TargetEffects::concernedBy(std::span<const TargetHitsEdit> edits) const {
    std::vector<Hit> changed;
    for (const TargetHitsEdit& edit : edits) {
        changed.insert(changed.end(), edit.before.begin(), edit.before.end());
        changed.insert(changed.end(), edit.after.begin(), edit.after.end());
    }
    return m_reach.everReached(changed);
}

void TargetEffects::splice(const TargetHitsEdit& edit) {
    const auto effects = m_effects.begin() + offset(edit.first);
    const auto gap = m_effects.erase(effects, effects + offset(edit.before.size()));
    m_effects.insert(gap, edit.after.size(), kNotYet);
    if (!m_keepsParts) {
        return;
    }
    const auto parts = m_parts.begin() + offset(edit.first);
    for (auto part = parts; part != parts + offset(edit.before.size()); ++part) {
        m_partCount -= part->size();
    }
    const auto partsGap = m_parts.erase(parts, parts + offset(edit.before.size()));
    m_parts.insert(partsGap, edit.after.size(), std::vector<Part>());
}

HitEffect TargetEffects::apply(const Hit& hit, std::uint32_t cluster) {
    HitEffect effect;
    const Cluster& run = m_mesh->clusters[cluster];
    const DentShape dent = dentShapeOf(hit);
    const std::span<DynamicVertex> vertices = m_vertices.cluster(cluster);
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        DynamicVertex& vertex = vertices[i - run.first];
        const glm::vec3 before = vertex.position;
        if (!deform(vertex.position, vertex.normal, dent) || vertex.position == before || !isFirstOf(i)) {
            continue;
        }
        const std::uint32_t fileVertex = m_mesh->fileVertices[i];
        ++m_counts[fileVertex];
        add(effect, {1, distanceBetween(before, vertex.position), fileVertex});
    }
    m_reach.placeCluster(cluster, vertices);
    return effect;
}

void TargetEffects::applyTo(std::span<const std::uint32_t> clusters, const Hit& hit, std::size_t index) {
    std::size_t done = 0;
    for (const std::uint32_t cluster : clusters) {
        mayGiveUp(done++, kClustersBetween);
        const HitEffect effect = apply(hit, cluster);
        if (effect.affected == 0) {
            continue;
        }
        add(m_effects[index], effect);
        if (m_keepsParts) {
            m_parts[index].push_back({cluster, effect});
            ++m_partCount;
        }
    }
    if (m_partCount > kMostParts) {
        forgetParts();
    }
}

void TargetEffects::forgetParts() {
    m_keepsParts = false;
    m_parts = {};
    m_partCount = 0;
}

void TargetEffects::append(std::size_t first, std::span<const Hit> hits, const std::atomic<bool>& stop,
                           Changes& changes) {
    std::vector<bool> marks(m_mesh->clusters.size(), false);
    std::vector<std::uint32_t> touched;
    std::vector<std::uint32_t> reached;
    for (std::size_t i = first; i < hits.size() && !stop; ++i) {
        reached.clear();
        m_reach.find(hits[i], reached);
        m_effects[i] = {};
        applyTo(reached, hits[i], i);
        for (const std::uint32_t cluster : reached) {
            if (!marks[cluster]) {
                marks[cluster] = true;
                touched.push_back(cluster);
            }
        }
        changes.hits.push_back(static_cast<std::uint32_t>(i));
    }
    addVertices(touched, changes);
}

void TargetEffects::startOver(std::span<const Hit> hits, const std::atomic<bool>& stop, Changes& changes) {
    m_vertices = VertexCopy(*m_mesh);
    m_reach.restart();
    m_counts.clear();
    m_keepsParts = true;
    m_parts.assign(m_effects.size(), {});
    m_partCount = 0;
    append(0, hits, stop, changes);
    changes.vertices.resize(m_counts.size());
    std::iota(changes.vertices.begin(), changes.vertices.end(), 0u);
}

void TargetEffects::restore(std::uint32_t cluster) {
    const Cluster& run = m_mesh->clusters[cluster];
    m_vertices.restore(cluster);
    for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        if (isFirstOf(i)) {
            m_counts[m_mesh->fileVertices[i]] = 0;
        }
    }
}

void TargetEffects::redo(std::span<const std::uint32_t> concerned, std::span<const Hit> hits,
                         const std::atomic<bool>& stop, Changes& changes) {
    std::vector<bool> marks(m_mesh->clusters.size(), false);
    for (const std::uint32_t cluster : concerned) {
        marks[cluster] = true;
        restore(cluster);
    }
    m_reach.restart(concerned);
    std::vector<std::uint32_t> reached;
    for (std::size_t i = 0; i < hits.size() && !stop; ++i) {
        const HitEffect before = std::exchange(m_effects[i], HitEffect{});
        if (m_keepsParts) {
            const std::size_t all = m_parts[i].size();
            std::erase_if(m_parts[i], [&marks](const Part& part) { return marks[part.cluster]; });
            m_partCount -= all - m_parts[i].size();
            for (const Part& part : m_parts[i]) {
                add(m_effects[i], part.effect);
            }
        }
        reached.clear();
        m_reach.findWithin(concerned, hits[i], reached);
        applyTo(reached, hits[i], i);
        if (!m_keepsParts) {  // they became too many: without them the rest cannot be told
            startOver(hits, stop, changes = {});
            return;
        }
        if (m_effects[i] != before) {
            changes.hits.push_back(static_cast<std::uint32_t>(i));
        }
    }
    addVertices(concerned, changes);
}

void TargetEffects::addVertices(std::span<const std::uint32_t> clusters, Changes& changes) const {
    for (const std::uint32_t cluster : clusters) {
        const Cluster& run = m_mesh->clusters[cluster];
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            if (isFirstOf(i)) {
                changes.vertices.push_back(m_mesh->fileVertices[i]);
            }
        }
    }
}

std::vector<std::uint32_t> TargetEffects::movedBy(std::size_t index, std::span<const Hit> hits) const {
    std::vector<bool> marks(m_mesh->clusters.size(), !m_keepsParts);
    if (m_keepsParts) {
        for (const Part& part : m_parts[index]) {
            marks[part.cluster] = true;
        }
    }
    std::vector<std::uint32_t> moved;
    for (std::uint32_t c = 0; c < marks.size(); ++c) {
        if (!marks[c]) {
            continue;
        }
        const Cluster& run = m_mesh->clusters[c];
        const auto original = m_mesh->vertices.begin() + run.first;
        std::vector<DynamicVertex> vertices(original, original + run.count);
        for (std::size_t i = 0; i <= index; ++i) {
            const auto isHere = [c](const Part& part) { return part.cluster == c; };
            if (m_keepsParts && std::none_of(m_parts[i].begin(), m_parts[i].end(), isHere)) {
                continue;  // it moved nothing here
            }
            const DentShape dent = dentShapeOf(hits[i]);
            for (std::uint32_t v = 0; v < run.count; ++v) {
                const glm::vec3 before = vertices[v].position;
                deform(vertices[v].position, vertices[v].normal, dent);
                if (i == index && vertices[v].position != before && isFirstOf(run.first + v)) {
                    moved.push_back(m_mesh->fileVertices[run.first + v]);
                }
            }
        }
    }
    std::sort(moved.begin(), moved.end());
    return moved;
}

}  // namespace hitscope
