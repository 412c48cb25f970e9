// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/dent_preview.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <tuple>

#include "deform/reference.h"
#include "mesh/primitives.h"
#include "session/session.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::dent_preview_test {

namespace {

std::vector<Bounds> boxesOf(const RenderMesh& mesh, std::span<const DynamicVertex> vertices) {
    std::vector<Bounds> boxes;
    for (const Cluster& cluster : mesh.clusters) {
        Bounds box;
        for (const DynamicVertex& vertex : vertices.subspan(cluster.first, cluster.count)) {
            box.add(vertex.position);
        }
        boxes.push_back(box);
    }
    return boxes;
}

/// What a hit did, told from the vertices before and after it.
struct Made {
    std::set<std::uint32_t> fileVertices;
    float depth = 0.0f;
};

Made difference(const RenderMesh& mesh, std::span<const DynamicVertex> before,
                std::span<const DynamicVertex> after) {
    Made made;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].position != after[i].position) {
            made.fileVertices.insert(mesh.fileVertices[i]);
            made.depth = std::max(made.depth, glm::distance(before[i].position, after[i].position));
        }
    }
    return made;
}

}  // namespace

/// What is foretold of a dent is what then happens.
class DentPreviewTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void foretellsWhatAHitDoes() {
        Session session;
        loadTeapot(session);
        const Target& teapot = *session.targets().front();
        const RenderMesh& mesh = teapot.deformed.render();
        ReferenceDeformation reference(mesh);
        const Bounds bounds = teapot.worldBounds();
        int hits = 0;
        for (int i = 0; i < 60; ++i) {
            // Around it, and again and again into the same places.
            const float turn = 0.7f * static_cast<float>(i % 12);
            const glm::vec3 eye = bounds.centre() + 9.0f * glm::vec3(std::cos(turn), 0.3f, std::sin(turn));
            const Ray ray{eye, glm::normalize(bounds.centre() - eye)};
            const std::optional<Hit> hit = session.simulation().predictedHit(ray, true);
            QVERIFY(hit.has_value());
            const std::vector<DynamicVertex> before(reference.vertices().begin(), reference.vertices().end());
            const auto reach =
                clustersNear(mesh, boxesOf(mesh, before), hit->point, hit->constants.maxDistance);
            QVERIFY(vertexCount(reach) < mesh.vertices.size());
            const auto near = session.simulation().physics().trianglesNear(teapot.id, hit->point,
                                                                           hit->constants.maxDistance);
            const DentPreview preview = previewDent(mesh, before, reach, near, *hit);

            QVERIFY(session.simulation().hitscan(ray));
            const Hit& made = session.hits().history().hits().back();
            QVERIFY(made == *hit);
            for (const VertexRange& range : reference.apply({&made, 1})) {
                test::readBackOf(session).take(teapot.id, range.first,
                                               reference.vertices().subspan(range.first, range.count));
            }
            test::readBackOf(session).finish();
            const Made done = difference(mesh, before, reference.vertices());
            QCOMPARE(preview.affectedVertices, done.fileVertices.size());
            QCOMPARE(preview.depth, done.depth);
            QVERIFY(preview.affectedVertices > 0);
            // The ghost: whole triangles, with every place that a vertex came to.
            QCOMPARE(preview.dent.size() % 3, std::size_t{0});
            const auto less = [](const glm::vec3& a, const glm::vec3& b) {
                return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
            };
            const std::set<glm::vec3, decltype(less)> shown(preview.dent.begin(), preview.dent.end(), less);
            for (std::size_t v = 0; v < before.size(); ++v) {
                if (before[v].position != reference.vertices()[v].position) {
                    QVERIFY(shown.contains(reference.vertices()[v].position));
                }
            }
            ++hits;
        }
        QCOMPARE(hits, 60);
    }

    void outOfReachNothingHappens() {
        const RenderMesh mesh = buildRenderMesh(makeHighPolySphere(2.5f));
        Hit hit;
        hit.point = {0, 9, 0};
        const auto boxes = boxesOf(mesh, mesh.vertices);
        QVERIFY(clustersNear(mesh, boxes, hit.point, hit.constants.maxDistance).empty());
        const VertexRange all{0, static_cast<std::uint32_t>(mesh.vertices.size())};
        const std::uint32_t triangle = 0;
        const DentPreview preview = previewDent(mesh, mesh.vertices, {&all, 1}, {&triangle, 1}, hit);
        QCOMPARE(preview.affectedVertices, std::size_t{0});
        QVERIFY(preview.dent.empty());
    }
};

HITSCOPE_TEST(DentPreviewTest, QCoreApplication)

}  // namespace hitscope::dent_preview_test

#include "dent_preview_test.moc"
