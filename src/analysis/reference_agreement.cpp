// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/reference_agreement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>

#include "deform/fingerprint.h"
#include "deform/reference.h"
#include "mesh/same_bits.h"

namespace hitscope {

namespace {

std::map<TargetId, std::vector<Hit>> appliedByTarget(const Session& session) {
    const std::span<const Hit> history = session.hits().history().hits();
    std::map<TargetId, std::vector<Hit>> hits;
    for (std::size_t i = 0; i < history.size(); ++i) {
        if (session.hits().isApplied(i)) {
            hits[history[i].target].push_back(history[i]);
        }
    }
    return hits;
}

std::vector<DynamicVertex> deformed(const RenderMesh& mesh, std::span<const Hit> hits,
                                    ReferenceMethod method) {
    if (method == ReferenceMethod::Everywhere) {
        std::vector<DynamicVertex> vertices(mesh.vertices.begin(), mesh.vertices.end());
        deformEverywhere(vertices, hits);
        return vertices;
    }
    ReferenceDeformation reference(mesh);
    reference.apply(hits);
    return {reference.vertices().begin(), reference.vertices().end()};
}

void compare(const DeformedMesh& mesh, std::span<const DynamicVertex> should, ReferenceAgreement& agreement) {
    const std::span<const DynamicVertex> are = mesh.vertices();
    for (std::uint32_t v = 0; v < mesh.original().vertexCount(); ++v) {
        bool isElsewhere = false;
        bool isTurned = false;
        for (const std::uint32_t r : mesh.render().renderVerticesOf(v)) {
            isTurned = isTurned || !sameBits(are[r].normal, should[r].normal);
            if (!sameBits(are[r].position, should[r].position)) {
                isElsewhere = true;
                const double distance =
                    glm::distance(glm::dvec3(are[r].position), glm::dvec3(should[r].position));
                agreement.largest = std::isfinite(distance) ? std::max(agreement.largest, distance)
                                                            : std::numeric_limits<double>::infinity();
            }
        }
        agreement.different += isElsewhere ? 1 : 0;
        agreement.differentNormal += isTurned && !isElsewhere ? 1 : 0;
    }
    agreement.vertices += mesh.original().vertexCount();
}

}  // namespace

ReferenceAgreement agreementWithReference(const Session& session, ReferenceMethod method) {
    const std::map<TargetId, std::vector<Hit>> hits = appliedByTarget(session);
    ReferenceAgreement agreement;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const auto own = hits.find(target->id);
        const std::span<const Hit> applied = own != hits.end() ? std::span(own->second) : std::span<Hit>();
        compare(target->deformed, deformed(target->deformed.render(), applied, method), agreement);
    }
    return agreement;
}

std::uint64_t hitsFingerprint(const Session& session) {
    std::vector<TargetId> targets;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        targets.push_back(target->id);
    }
    return hitsFingerprint(session.hits().history().hits(), targets);
}

std::uint64_t positionsFingerprint(const Session& session) {
    std::vector<const DeformedMesh*> targets;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        targets.push_back(&target->deformed);
    }
    return positionsFingerprint(targets);
}

}  // namespace hitscope
