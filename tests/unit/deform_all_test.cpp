// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deform_all.h"

#include <QTest>
#include <cmath>
#include <cstring>
#include <limits>

#include "deform_support.h"
#include "support/test_program.h"

namespace hitscope::deform_all_test {

using namespace test;

namespace {

constexpr float kHuge = std::numeric_limits<float>::max();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

/// Numbers at which an operation may go either way.
float hardNumber(std::mt19937& random) {
    constexpr float kHard[] = {0.0f, -0.0f, 1e-45f, -1e-39f, 1e-20f, 9e-21f, 1e-11f,    9e-12f,   0.05f,
                               0.5f, 0.3f,  -0.5f,  1.0f,    -kHuge, kHuge,  kInfinity, kNoNumber};
    return kHard[random() % std::size(kHard)];
}

glm::vec3 vectorOf(std::mt19937& random, float extent, bool isHard) {
    glm::vec3 v = randomPoint(random, extent);
    for (glm::length_t i = 0; isHard && i < 3; ++i) {
        v[i] = random() % 3 == 0 ? hardNumber(random) : v[i];
    }
    return v;
}

std::vector<DynamicVertex> verticesOf(std::mt19937& random, std::size_t count, float extent, bool isHard) {
    std::vector<DynamicVertex> vertices(count);
    for (DynamicVertex& vertex : vertices) {
        vertex = {vectorOf(random, extent, isHard), glm::normalize(randomPoint(random, 1.0f))};
        if (isHard) {
            vertex.normal = vectorOf(random, 1.0f, true);
        }
    }
    return vertices;
}

/// All bits, but of what is no number: which NaN comes of two is the processor's affair.
bool areSame(float a, float b) {
    return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

bool areSame(const DynamicVertex& a, const DynamicVertex& b) {
    bool same = true;
    for (glm::length_t i = 0; i < 3; ++i) {
        same = same && areSame(a.position[i], b.position[i]) && areSame(a.normal[i], b.normal[i]);
    }
    return same;
}

/// Returns how many were reached, or nothing: one came out otherwise than one by one.
std::optional<int> reachedIfSame(std::vector<DynamicVertex> vertices, const Hit& hit) {
    std::vector<DynamicVertex> oneByOne = vertices;
    const DentShape dent = dentShapeOf(hit);
    deformAll(vertices, dent);
    int reached = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        reached += deform(oneByOne[i].position, oneByOne[i].normal, dent) ? 1 : 0;
        if (!areSame(vertices[i], oneByOne[i])) {
            return std::nullopt;
        }
    }
    return reached;
}

}  // namespace

class DeformAllTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void isDeformOfEach_data() {
        QTest::addColumn<bool>("isHard");
        QTest::newRow("usual numbers") << false;
        QTest::newRow("hard numbers") << true;
    }
    void isDeformOfEach() {
        QFETCH(bool, isHard);
        std::mt19937 random(11);
        int reached = 0;
        for (int i = 0; i < 3000; ++i) {
            const Hit hit = randomHit(random, 0.5f);
            const std::optional<int> many =
                reachedIfSame(verticesOf(random, static_cast<std::size_t>(i % 70), 0.6f, isHard), hit);
            QVERIFY(many.has_value());
            reached += *many;
        }
        QVERIFY(reached > 10000);
    }

    void isDeformAtTheRimAndAtTheHit() {
        std::mt19937 random(12);
        for (int i = 0; i < 300; ++i) {
            Hit hit = randomHit(random, 0.5f);
            std::vector<DynamicVertex> vertices;
            for (int k = 0; k < 64; ++k) {
                // Within some units in the last place of the rim, of the hit's point, or of where the cap
                // ends.
                const float r = k % 4 == 0   ? 0.0f
                                : k % 4 == 1 ? hit.constants.maxDistance
                                : k % 4 == 2 ? hit.constants.power / hit.constants.maxMagnitude
                                             : 1e-11f;
                const glm::vec3 away = glm::normalize(randomPoint(random, 1.0f));
                vertices.push_back({hit.point + r * away, k % 8 < 4 ? -hit.direction * 0.3f : away});
            }
            QVERIFY(reachedIfSame(vertices, hit).has_value());
        }
    }

    void isDeformOfComponentsThatCountAsNone() {
        Hit hit;
        hit.direction = {0.0f, 0.0f, 1.0f};
        std::vector<DynamicVertex> vertices;
        for (const float x : {1e-20f, std::nextafter(1e-20f, 0.0f), -1e-20f, 0.0f}) {
            vertices.push_back({{0.1f, 0.0f, 0.0f}, {x, 0.5f, 0.0f}});
        }
        QCOMPARE(reachedIfSame(vertices, hit), std::optional(4));
        deformAll(vertices, dentShapeOf(hit));
        QVERIFY(vertices[0].normal.x > 0.0f);
        QCOMPARE(vertices[1].normal.x, 0.0f);
    }

    void otherFormsGoOneByOne() {
        std::mt19937 random(13);
        Hit hit = randomHit(random, 0.2f);
        hit.form.profile = DentProfile::Wendland;
        const std::optional<int> many = reachedIfSame(verticesOf(random, 67, 0.3f, false), hit);
        QVERIFY(many.has_value() && *many > 10);
    }
};

HITSCOPE_TEST(DeformAllTest, QCoreApplication)

}  // namespace hitscope::deform_all_test

#include "deform_all_test.moc"
