// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "deform/fingerprint.h"
#include "deform/reference.h"
#include "document/capture.h"
#include "document/document_json.h"
#include "document/open_document.h"
#include "document_support.h"
#include "io_support.h"
#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope::test {

constexpr const char* kObj =
    "v 0.1 0 0\nv 1 0.3 0\nv 1 1 0.7\nv 0 1 0.2\nv 0.5 0.5 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 "
    "1\n";

/// Hits all over the targets, as shots make them.
inline void shoot(Session& session, int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    for (int i = 0; i < count; ++i) {
        const auto& target = session.targets()[static_cast<std::size_t>(i) % session.targets().size()];
        Hit hit = exampleHit(target->id.value, 0.0f);
        const Bounds bounds = target->shape.render->bounds;
        hit.point = bounds.centre() + 0.5f * bounds.size() * glm::vec3(any(random), any(random), any(random));
        hit.direction = glm::normalize(glm::vec3(any(random), any(random), any(random) + 2.0f));
        hit.constants = session.settings().constantsOn(*target);
        hit.enabled = i % 5 != 4;
        QVERIFY(session.hits().add(hit).ok());
    }
}

/// What the reference makes of each target.
inline std::vector<std::uint64_t> referenceFingerprints(const Session& session) {
    std::vector<std::uint64_t> prints;
    for (const auto& target : session.targets()) {
        ReferenceDeformation reference(*target->shape.render);
        reference.apply(session.hits().history().hitsOn(target->id));
        Fingerprint print;
        for (const DynamicVertex& vertex : reference.vertices()) {
            print.add(vertex.position);
            print.add(vertex.normal);
        }
        prints.push_back(print.value());
    }
    return prints;
}

inline std::uint64_t hitsFingerprint(const Session& session) {
    std::vector<TargetId> ids;
    for (const auto& target : session.targets()) {
        ids.push_back(target->id);
    }
    return hitscope::hitsFingerprint(session.hits().history().hits(), ids);
}

inline CapturedView someView() {
    const SessionDocument example = exampleDocument();
    CapturedView view{example.cameras, {}};
    view.display.flat = true;
    view.display.cut.on = true;
    return view;
}

inline Result<PreparedSession> prepared(const QByteArray& bytes, const MeshPlaces& places = {}) {
    const Result<SessionDocument> document = readDocument(bytes);
    return document ? prepareSession(document.value(), places) : Result<PreparedSession>(document.error());
}

}  // namespace hitscope::test
