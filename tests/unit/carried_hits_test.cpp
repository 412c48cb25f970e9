// SPDX-License-Identifier: GPL-3.0-or-later
// Hits on a mesh whose file has changed.
#include <QTest>
#include <glm/gtc/quaternion.hpp>

#include "deform/carried_hits.h"
#include "deform/reference.h"
#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::carried_hits_test {

namespace {

CarriedHits::Shape shapeOf(const MeshData& mesh) {
    return {std::make_shared<const MeshData>(mesh),
            std::make_shared<const RenderMesh>(buildRenderMesh(mesh))};
}

template <class Move>
MeshData moved(MeshData mesh, const Move& move) {
    for (glm::vec3& position : mesh.positions) {
        position = move(position);
    }
    mesh.normals.clear();
    mesh.cornerNormals.clear();
    return mesh;
}

glm::vec3 centreOf(const RenderMesh& mesh, std::size_t triangle) {
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < 3; ++i) {
        sum += mesh.vertices[mesh.triangles[3 * triangle + i]].position / 3.0f;
    }
    return sum;
}

/// On many triangles, a little above each, as after a dent or two.
std::vector<Hit> hitsOn(const RenderMesh& mesh) {
    std::vector<Hit> hits;
    for (std::size_t triangle = 0; triangle < mesh.triangleFaces.size(); triangle += 7) {
        Hit hit;
        hit.target = TargetId{1};
        hit.triangle = static_cast<std::uint32_t>(triangle);
        hit.normal = glm::normalize(centreOf(mesh, triangle));
        hit.point = centreOf(mesh, triangle) + 0.05f * hit.normal;
        hit.direction = glm::normalize(glm::vec3(0.3f, 0.1f, 0.0f) - hit.normal);
        hit.constants = {0.6f, 0.05f, 0.2f};
        hits.push_back(checkedHit(hit).value());
    }
    return hits;
}

/// Of each file vertex, after the hits.
std::vector<glm::vec3> dented(const CarriedHits::Shape& shape, const std::vector<Hit>& hits) {
    ReferenceDeformation reference(*shape.render);
    reference.apply(hits);
    std::vector<glm::vec3> positions(shape.mesh->vertexCount());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i] =
            reference.vertices()[shape.render->renderVerticesOf(static_cast<std::uint32_t>(i)).front()]
                .position;
    }
    return positions;
}

float farthest(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
    float most = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, glm::distance(a[i], b[i]));
    }
    return most;
}

}  // namespace

class CarriedHitsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Saved anew, with nothing changed.
    void sameMesh() {
        const CarriedHits::Shape before = shapeOf(makeUvSphere(24, 12, 1.0f));
        const CarriedHits carried(before, shapeOf(*before.mesh));
        QVERIFY(carried.isByVertex());
        const std::vector<Hit> hits = hitsOn(*before.render);
        QVERIFY(hits.size() > 50);
        for (const Hit& hit : hits) {
            QVERIFY(carried.carried(hit) == hit);
        }
    }

    /// Moved, turned and scaled as a whole, as by another setting of an exporter: the dents do the same.
    void goesAlongWithTheMesh() {
        const CarriedHits::Shape before = shapeOf(makeUvSphere(24, 12, 1.0f));
        const glm::quat turn = glm::angleAxis(1.5707963f, glm::vec3(1.0f, 0.0f, 0.0f));
        const auto move = [&](const glm::vec3& p) { return turn * p + glm::vec3(10.0f, -3.0f, 2.0f); };
        const CarriedHits::Shape after = shapeOf(moved(*before.mesh, move));
        const CarriedHits carried(before, after);
        QVERIFY(carried.isByVertex());
        const std::vector<Hit> hits = hitsOn(*before.render);
        std::vector<Hit> others;
        for (const Hit& hit : hits) {
            others.push_back(carried.carried(hit));
            QVERIFY(glm::distance(others.back().point, move(hit.point)) < 1.0e-4f);
            QVERIFY(glm::distance(others.back().direction, turn * hit.direction) < 1.0e-4f);
            QVERIFY(glm::distance(others.back().normal, turn * hit.normal) < 1.0e-4f);
            // A quad may be cut the other way.
            QCOMPARE(after.render->triangleFaces[others.back().triangle],
                     before.render->triangleFaces[hit.triangle]);
        }
        // One alone: where many meet, rounding decides whether the next still reaches a vertex.
        const std::vector<Hit> one = {hits[20]};
        std::vector<glm::vec3> expected = dented(before, one);
        QVERIFY(farthest(expected, before.mesh->positions) > 0.01f);
        std::transform(expected.begin(), expected.end(), expected.begin(), move);
        QVERIFY(farthest(dented(after, {others[20]}), expected) < 1.0e-3f);
    }

    void growsWithTheMesh() {
        const CarriedHits::Shape before = shapeOf(makeUvSphere(24, 12, 1.0f));
        const CarriedHits::Shape after =
            shapeOf(moved(*before.mesh, [](const glm::vec3& p) { return 100.0f * p; }));
        const CarriedHits carried(before, after);
        for (const Hit& hit : hitsOn(*before.render)) {
            const Hit other = carried.carried(hit);
            QVERIFY(glm::distance(other.point, 100.0f * hit.point) < 0.01f);
            QVERIFY(other.direction == hit.direction);
            QVERIFY(other.constants == hit.constants);
        }
    }

    /// Only what was sculpted takes its hits along; the rest keeps every bit.
    void partOfTheMesh() {
        const CarriedHits::Shape before = shapeOf(makeUvSphere(24, 12, 1.0f));
        const CarriedHits::Shape after = shapeOf(moved(*before.mesh, [](const glm::vec3& p) {
            return p.x > 0.5f ? p + glm::vec3(2.0f, 0.0f, 0.0f) : p;
        }));
        const CarriedHits carried(before, after);
        int same = 0;
        int along = 0;
        for (const Hit& hit : hitsOn(*before.render)) {
            Hit other = carried.carried(hit);
            const float x = centreOf(*before.render, hit.triangle).x;
            if (x > 0.8f) {
                QVERIFY(glm::distance(other.point, hit.point + glm::vec3(2.0f, 0.0f, 0.0f)) < 1.0e-5f);
                QVERIFY(other.direction == hit.direction);
                ++along;
            } else if (x < 0.2f) {
                other.triangle = hit.triangle;
                QVERIFY(other == hit);
                ++same;
            }
        }
        QVERIFY(same > 10 && along > 2);
    }

    /// A triangle without an area has no axes; its hit goes where its centre goes.
    void flattenedTriangle() {
        const CarriedHits::Shape before = shapeOf(makeUvSphere(24, 12, 1.0f));
        const CarriedHits::Shape after =
            shapeOf(moved(*before.mesh, [](const glm::vec3&) { return glm::vec3(4.0f, 5.0f, 6.0f); }));
        const CarriedHits carried(before, after);
        for (const Hit& hit : hitsOn(*before.render)) {
            const Hit other = carried.carried(hit);
            QVERIFY(checkedHit(other).ok());
            QVERIFY(glm::distance(other.point, glm::vec3(4.0f, 5.0f, 6.0f)) < 0.2f);
        }
    }

    void otherVertices_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("finer") << 0;
        QTest::newRow("as many vertices, other faces") << 1;
        QTest::newRow("a face less") << 2;
    }
    void otherVertices() {
        QFETCH(int, kind);
        const CarriedHits::Shape before = shapeOf(makeUvSphere(24, 12, 1.0f));
        MeshData mesh =
            kind == 0 ? makeUvSphere(48, 24, 1.0f) : moved(*before.mesh, [](auto p) { return p; });
        if (kind == 1) {
            std::swap(mesh.cornerVertices[mesh.faceStarts[5]], mesh.cornerVertices[mesh.faceStarts[5] + 1]);
        } else if (kind == 2) {
            mesh.cornerVertices.resize(mesh.faceStarts[mesh.faceCount() - 1]);
            mesh.cornerTexcoords.clear();
            mesh.faceStarts.pop_back();
        }
        QVERIFY(validate(mesh).ok());
        const CarriedHits carried(before, shapeOf(mesh));
        QVERIFY(!carried.isByVertex());
        for (const Hit& hit : hitsOn(*before.render)) {
            Hit other = carried.carried(hit);
            QCOMPARE(other.triangle, kNoIndex);
            other.triangle = hit.triangle;
            QVERIFY(other == hit);
        }
    }

    /// As after another mesh took this one's place.
    void unknownTriangle() {
        const CarriedHits::Shape before = shapeOf(makeUvSphere(24, 12, 1.0f));
        const CarriedHits carried(before,
                                  shapeOf(moved(*before.mesh, [](const glm::vec3& p) { return 2.0f * p; })));
        for (const std::uint32_t triangle : {kNoIndex, 1'000'000u}) {
            Hit hit = hitsOn(*before.render).front();
            hit.triangle = triangle;
            const Hit other = carried.carried(hit);
            QCOMPARE(other.triangle, kNoIndex);
            QVERIFY(other.point == hit.point);
        }
    }
};

HITSCOPE_TEST(CarriedHitsTest, QCoreApplication)

}  // namespace hitscope::carried_hits_test

#include "carried_hits_test.moc"
