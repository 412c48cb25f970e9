// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/dent_owners.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "deform/cluster_reach.h"
#include "deform/deform.h"

namespace hitscope {

namespace {

/// What the hits of one dent did to a vertex.
struct DentShare {
    std::uint32_t dent = kNoIndex;
    glm::vec3 moved{0.0f};
    float nearest = std::numeric_limits<float>::max();  ///< metres: of its hits, when they struck
};

struct SharedVertex {
    glm::vec3 position{0.0f};
    std::vector<DentShare> shares;

    void strike(const Hit& hit, std::uint32_t dent) {
        const std::optional<Contribution> contribution = contributionTo(position, hit);
        if (!contribution) {
            return;
        }
        auto share = std::find_if(shares.begin(), shares.end(),
                                  [dent](const DentShare& one) { return one.dent == dent; });
        if (share == shares.end()) {
            share = shares.insert(shares.end(), DentShare{dent});
        }
        const glm::vec3 after = position + contribution->displacement;
        share->moved += after - position;
        share->nearest = std::min(share->nearest, contribution->distance);
        position = after;
    }

    [[nodiscard]] std::uint32_t owner() const {
        constexpr float kAsFar = 1.0e-4f;  // of the way: the cap is reached by rounded numbers
        const DentShare* best = nullptr;
        float most = 0.0f;
        for (const DentShare& share : shares) {
            const float way = glm::length(share.moved);
            const bool isAsFar = best != nullptr && std::abs(way - most) <= kAsFar * most;
            if (way > 0.0f && (best == nullptr || (isAsFar ? share.nearest < best->nearest : way > most))) {
                best = &share;
                most = std::max(way, isAsFar ? most : 0.0f);
            }
        }
        return best != nullptr ? best->dent : kNoIndex;
    }
};

}  // namespace

std::vector<std::uint32_t> dentsOfHits(std::span<const Hit> hits) {
    std::vector<std::uint32_t> dents(hits.size());
    // By place along an axis, so that only neighbours are compared.
    std::vector<std::uint32_t> order(hits.size());
    for (std::uint32_t i = 0; i < hits.size(); ++i) {
        dents[i] = order[i] = i;
    }
    const auto rootOf = [&dents](std::uint32_t hit) {
        while (dents[hit] != hit) {
            hit = dents[hit] = dents[dents[hit]];
        }
        return hit;
    };
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        const auto [first, second] = std::minmax({rootOf(a), rootOf(b)});
        dents[second] = first;
    };
    std::stable_sort(order.begin(), order.end(),
                     [hits](std::uint32_t a, std::uint32_t b) { return hits[a].point.x < hits[b].point.x; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Hit& hit = hits[order[i]];
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const Hit& other = hits[order[k]];
            if (other.point.x - hit.point.x > kOnePlace * hit.constants.maxDistance) {
                break;
            }
            const float reach = std::min(hit.constants.maxDistance, other.constants.maxDistance);
            if (hit.target == other.target && glm::distance(hit.point, other.point) <= kOnePlace * reach) {
                join(order[i], order[k]);
            }
        }
    }
    std::map<std::uint32_t, std::uint32_t> strokes;  // number -> its first hit
    for (std::uint32_t i = 0; i < hits.size(); ++i) {
        if (hits[i].group.kind == HitGroupKind::Stroke) {
            join(strokes.try_emplace(hits[i].group.number, i).first->second, i);
        }
    }
    for (std::uint32_t i = 0; i < hits.size(); ++i) {
        dents[i] = rootOf(i);
    }
    return dents;
}

std::vector<std::uint32_t> dentOwners(const RenderMesh& mesh, std::span<const std::uint32_t> vertices,
                                      std::span<const Hit> hits, std::span<const std::uint32_t> dents,
                                      const std::function<bool()>& isStopped) {
    std::vector<SharedVertex> shared(vertices.size());
    std::vector<std::vector<std::uint32_t>> inCluster(mesh.clusters.size());  // indices of `shared`
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        const std::uint32_t vertex = mesh.renderVerticesOf(vertices[i]).front();
        shared[i].position = mesh.vertices[vertex].position;
        inCluster[vertex / kClusterVertices].push_back(i);
    }
    ClusterReach reach(mesh);
    std::vector<std::uint32_t> reached;
    for (std::size_t hit = 0; hit < hits.size(); ++hit) {
        if (isStopped && isStopped()) {
            return {};
        }
        reached.clear();
        reach.advance(hits[hit], reached);
        for (const std::uint32_t cluster : reached) {
            for (const std::uint32_t i : inCluster[cluster]) {
                shared[i].strike(hits[hit], dents[hit]);
            }
        }
    }
    std::vector<std::uint32_t> owners(vertices.size());
    std::transform(shared.begin(), shared.end(), owners.begin(),
                   [](const SharedVertex& vertex) { return vertex.owner(); });
    return owners;
}

}  // namespace hitscope
