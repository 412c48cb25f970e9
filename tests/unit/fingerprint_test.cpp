// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <bit>
#include <functional>

#include "deform/fingerprint.h"
#include "deform/reference.h"
#include "mesh/primitives.h"
#include "support/test_program.h"
#include "unit/deform_support.h"

namespace hitscope::fingerprint_test {

using namespace test;

namespace {

constexpr TargetId kFirst{4};
constexpr TargetId kSecond{9};

std::uint64_t printOf(const std::vector<Hit>& hits) {
    return hitsFingerprint(hits, std::vector<TargetId>{kFirst, kSecond});
}

std::vector<Hit> someHits() {
    std::mt19937 random(5);
    std::vector<Hit> hits{randomHit(random, 1.0f), randomHit(random, 1.0f), randomHit(random, 1.0f)};
    for (Hit& hit : hits) {
        hit.target = kFirst;
        hit.time = 0.25;
    }
    return hits;
}

using Change = std::function<void(Hit&)>;

float nextBit(float value) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ 1u);
}

DeformedMesh deformedCube() {
    auto mesh = std::make_shared<const MeshData>(makeCube(1, 1.0f));
    return {mesh, std::make_shared<const RenderMesh>(buildRenderMesh(*mesh))};
}

/// Gives a file vertex this position, as a pipeline would: all its render vertices.
void put(DeformedMesh& mesh, std::uint32_t fileVertex, const glm::vec3& position) {
    std::vector<std::uint32_t> moved;
    for (const std::uint32_t r : mesh.render().renderVerticesOf(fileVertex)) {
        DynamicVertex vertex = mesh.vertices()[r];
        vertex.position = position;
        mesh.write(r, std::span(&vertex, 1), moved);
    }
}

}  // namespace

class FingerprintTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // FNV-1a's own vectors: of nothing, and of the bytes of "foobar", lowest first.
    void isFnv1a() {
        QCOMPARE(fingerprintText(Fingerprint().value()), std::string("cbf29ce484222325"));
        Fingerprint print;
        print.add(std::uint32_t{0x626f6f66});  // "foob"
        print.add(std::uint8_t{'a'});
        print.add(std::uint8_t{'r'});
        QCOMPARE(fingerprintText(print.value()), std::string("85944171f73967e8"));
        QCOMPARE(fingerprintText(0x1fu), std::string("000000000000001f"));
    }

    void everyNumberOfAHitCounts_data() {
        QTest::addColumn<Change>("change");
        const auto row = [](const char* name, const Change& change) { QTest::addRow("%s", name) << change; };
        row("power", [](Hit& hit) { hit.constants.power = nextBit(hit.constants.power); });
        row("max distance", [](Hit& hit) { hit.constants.maxDistance = nextBit(hit.constants.maxDistance); });
        row("max magnitude",
            [](Hit& hit) { hit.constants.maxMagnitude = nextBit(hit.constants.maxMagnitude); });
        row("enabled", [](Hit& hit) { hit.enabled = false; });
        row("target", [](Hit& hit) { hit.target = kSecond; });
        row("point", [](Hit& hit) { hit.point.z = nextBit(hit.point.z); });
        row("direction", [](Hit& hit) { hit.direction.x = nextBit(hit.direction.x); });
        row("normal", [](Hit& hit) { hit.normal.y = 1.0f; });
        row("time", [](Hit& hit) { hit.time = 0.5; });
        row("speed", [](Hit& hit) { hit.speed = 1.0f; });
        row("impulse", [](Hit& hit) { hit.impulse = 1.0f; });
        row("triangle", [](Hit& hit) { hit.triangle = 0; });
    }
    void everyNumberOfAHitCounts() {
        QFETCH(Change, change);
        std::vector<Hit> hits = someHits();
        const std::uint64_t before = printOf(hits);
        change(hits[1]);
        QVERIFY(printOf(hits) != before);
    }

    void orderAndNumberOfHitsCount() {
        const std::vector<Hit> hits = someHits();
        QVERIFY(printOf({hits[1], hits[0], hits[2]}) != printOf(hits));
        QVERIFY(printOf({hits[0], hits[1]}) != printOf(hits));
        QVERIFY(printOf({}) != Fingerprint().value());
    }

    // What deforms nothing, what JSON cannot keep, and how targets were numbered.
    void whatDoesNotCount() {
        std::vector<Hit> hits = someHits();
        hits[0].normal = {0.0f, 1.0f, 0.0f};
        const std::uint64_t before = printOf(hits);
        hits[0].pipeline = 3;
        hits[0].flight = {0.0f, 0.0f, 1.0f};
        hits[0].normal.x = -0.0f;
        QCOMPARE(printOf(hits), before);
        for (Hit& hit : hits) {
            hit.target = TargetId{70};
        }
        QCOMPARE(hitsFingerprint(hits, std::vector<TargetId>{TargetId{70}, TargetId{71}}), before);
    }

    void everyBitOfAPositionCounts() {
        DeformedMesh first = deformedCube();
        DeformedMesh second = deformedCube();
        const std::vector<const DeformedMesh*> both{&first, &second};
        const std::uint64_t before = positionsFingerprint(both);
        const glm::vec3 corner = second.positions()[6];
        put(second, 6, {corner.x, nextBit(corner.y), corner.z});
        QVERIFY(positionsFingerprint(both) != before);
        put(second, 6, corner);
        QCOMPARE(positionsFingerprint(both), before);
        put(first, 0, {0.0f, 1.0f, 2.0f});
        const std::uint64_t positive = positionsFingerprint(both);
        put(first, 0, {-0.0f, 1.0f, 2.0f});
        QVERIFY(positionsFingerprint(both) != positive);
        QVERIFY(positionsFingerprint(std::vector<const DeformedMesh*>{&second, &first}) !=
                positionsFingerprint(both));
    }

    // The reference goes to the clusters that a hit may reach, and leaves out none.
    void referenceIsEveryHitAtEveryVertex() {
        const RenderMesh mesh = buildRenderMesh(makeUvSphere(32, 16, 1.0f));
        std::mt19937 random(11);
        std::vector<Hit> hits;
        for (int i = 0; i < 80; ++i) {
            hits.push_back(randomHit(random, 1.1f));
        }
        ReferenceDeformation reference(mesh);
        reference.apply(hits);
        PageVector<DynamicVertex> everywhere = mesh.vertices;
        deformEverywhere(everywhere, hits);
        std::size_t moved = 0;
        for (std::size_t i = 0; i < everywhere.size(); ++i) {
            QVERIFY(everywhere[i].position == reference.vertices()[i].position);
            QVERIFY(everywhere[i].normal == reference.vertices()[i].normal);
            moved += everywhere[i].position != mesh.vertices[i].position ? 1 : 0;
        }
        QVERIFY(moved > everywhere.size() / 4);
    }
};

HITSCOPE_TEST(FingerprintTest, QCoreApplication)

}  // namespace hitscope::fingerprint_test

#include "fingerprint_test.moc"
