// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of vertices, as they lie on the GPU.
#include <QTest>
#include <cmath>

#include "pipeline/vertex_colours.h"
#include "support/test_program.h"

namespace hitscope::vertex_colours_test {

class VertexColoursTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void areLinear();
    void followTheFileVertices();
};

void VertexColoursTest::areLinear() {
    // All that eight bits can say, against the formula in double.
    for (int value = 0; value <= 255; ++value) {
        const glm::vec3 srgb(static_cast<float>(value) / 255.0f);
        const std::uint32_t first = 0;
        const LinearColour colour = linearColours(std::span(&srgb, 1), std::span(&first, 1)).at(0);
        const double s = value / 255.0;
        const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        QVERIFY(std::abs(colour[0] - 65535.0 * linear) <= 0.5);
        QCOMPARE(colour[1], colour[0]);
        QCOMPARE(colour[2], colour[0]);
    }
}

void VertexColoursTest::followTheFileVertices() {
    const std::vector<glm::vec3> srgb{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<std::uint32_t> fileVertices{2, 0, 0, 1};
    const std::vector<LinearColour> colours = linearColours(srgb, fileVertices);
    QCOMPARE(colours.size(), fileVertices.size());
    QCOMPARE(colours[0], (LinearColour{0, 0, 65535, 0}));
    QCOMPARE(colours[1], (LinearColour{65535, 0, 0, 0}));
    QCOMPARE(colours[2], colours[1]);
    QCOMPARE(colours[3], (LinearColour{0, 65535, 0, 0}));
}

HITSCOPE_TEST(VertexColoursTest, QCoreApplication)

}  // namespace hitscope::vertex_colours_test

#include "vertex_colours_test.moc"
