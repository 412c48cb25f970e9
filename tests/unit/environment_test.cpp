// SPDX-License-Identifier: GPL-3.0-or-later
// The studio that lights a scene, as numbers.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "support/test_program.h"
#include "view/environment.h"

namespace hitscope::environment_test {

namespace {

constexpr int kDirections = 20000;

glm::vec3 directionOf(int i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / kDirections;
    const float across = std::sqrt(std::max(1.0f - y * y, 0.0f));
    const float turn = 2.3999632f * static_cast<float>(i);
    return {across * std::cos(turn), y, across * std::sin(turn)};
}

}  // namespace

class EnvironmentTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The spherical harmonics against the integral that they stand for.
    void diffuseIsTheLightAround() {
        for (const glm::vec3& given : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(1, 0, 0),
                                       glm::vec3(-0.5f, 0.8f, 0.45f), glm::vec3(0.3f, -0.2f, -0.9f)}) {
            const glm::vec3 normal = glm::normalize(given);
            glm::vec3 sum(0.0f);
            for (int i = 0; i < kDirections; ++i) {
                const glm::vec3 d = directionOf(i);
                sum += std::max(glm::dot(d, normal), 0.0f) * environmentLight(d, 0.0f);
            }
            const glm::vec3 integral = 4.0f / kDirections * sum;
            const glm::vec3 found = environmentDiffuse(normal);
            // Order 2 is known to be off by some percent of the brightest.
            QVERIFY2(glm::distance(integral, found) < 0.16f,
                     qPrintable(QStringLiteral("%1, %2").arg(integral.g).arg(found.g)));
        }
    }

    /// Blurred, the lights lose in height what they gain in width.
    void roughnessSpreadsLight() {
        const glm::vec3 key = -environmentKeyDirection();
        float before = environmentLight(key, 0.0f).g;
        for (const float roughness : {0.3f, 0.5f, 0.8f, 1.0f}) {
            const float now = environmentLight(key, roughness).g;
            QVERIFY(now < before);
            before = now;
        }
        const auto total = [](float roughness) {
            float sum = 0.0f;
            for (int i = 0; i < kDirections; ++i) {
                sum += environmentLight(directionOf(i), roughness).g / kDirections;
            }
            return sum;
        };
        QVERIFY(std::abs(total(0.6f) - total(0.0f)) < 0.12f * total(0.0f));
    }

    void tableGoesOnAcrossItsEdges() {
        const EnvironmentTable table = makeEnvironmentTable();
        constexpr int kSide = EnvironmentTable::kSide;
        QCOMPARE(table.texels.size(), std::size_t{EnvironmentTable::kLayers} * kSide * kSide);
        for (int layer = 0; layer < EnvironmentTable::kLayers; ++layer) {
            const auto at = [&](int row, int column) {
                return table.texels[static_cast<std::size_t>((layer * kSide + row) * kSide + column)];
            };
            for (int i = 1; i <= EnvironmentTable::kInner; ++i) {
                // What lies beyond an edge is on the other half of the same edge.
                QVERIFY(glm::distance(at(0, i), at(1, kSide - 1 - i)) < 1.0e-4f);
                QVERIFY(glm::distance(at(i, kSide - 1), at(kSide - 1 - i, kSide - 2)) < 1.0e-4f);
            }
            for (const glm::vec3& texel : table.texels) {
                QVERIFY(std::min({texel.r, texel.g, texel.b}) >= 0.0f && texel.g < 60.0f);
            }
        }
    }

    void matcapIsALitBall() {
        const Image image = makeMatcap(64);
        QCOMPARE(image.pixels.size(), std::size_t{4} * 64 * 64);
        const auto green = [&](int x, int y) {
            return int{image.pixels[std::size_t{4} * static_cast<std::size_t>(64 * y + x) + 1]};
        };
        // The key light is at the upper left; below is the ground.
        QVERIFY(green(22, 18) > green(32, 54) + 40);
        QVERIFY(green(22, 18) > green(46, 48));
        QVERIFY(green(32, 32) > 60);
    }
};

HITSCOPE_TEST(EnvironmentTest, QCoreApplication)

}  // namespace hitscope::environment_test

#include "environment_test.moc"
