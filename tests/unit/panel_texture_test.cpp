// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/panel_texture.h"
#include "support/test_program.h"

#include <QTest>
#include <cstdlib>
#include <functional>

namespace hitscope::panel_texture_test {

namespace {

int red(const Image& image, int x, int y) {
    return image.pixels[std::size_t{4} * static_cast<std::size_t>(y * image.width + x)];
}

/// Mean difference between neighbours in a column (or row) and the next, the one after the last being the
/// first.
double step(const Image& image, int line, bool across) {
    double sum = 0.0;
    const int next = (line + 1) % image.width;
    for (int i = 0; i < image.height; ++i) {
        sum += across ? std::abs(red(image, line, i) - red(image, next, i))
                      : std::abs(red(image, i, line) - red(image, i, next));
    }
    return sum / image.height;
}

}  // namespace

class PanelTextureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sameSizeAndSeedGiveTheSame() {
        const Image one = makePanelTexture(128, 3);
        QCOMPARE(one.width, 128);
        QCOMPARE(one.height, 128);
        QCOMPARE(one.pixels.size(), std::size_t{4} * 128 * 128);
        QVERIFY(one.pixels == makePanelTexture(128, 3).pixels);
        QVERIFY(one.pixels != makePanelTexture(128, 4).pixels);
        for (std::size_t i = 3; i < one.pixels.size(); i += 4) {
            QCOMPARE(one.pixels[i], std::uint8_t{255});
        }
    }

    void goesOnOverItsEdges() {
        for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
            const Image image = makePanelTexture(512, seed);
            for (const bool across : {true, false}) {
                double largest = 0.0;
                for (int line = 0; line < 511; ++line) {
                    largest = std::max(largest, step(image, line, across));
                }
                // A seam along the edge is as deep as any other, and no deeper.
                QVERIFY2(step(image, 511, across) <= 1.1 * largest, qPrintable(QString::number(seed)));
            }
            // Right across, where rows of panels do not begin: as smooth as anywhere.
            QVERIFY(step(image, 511, true) < 12.0);
        }
    }

    void hasDetailDownToThePixel() {
        const Image image = makePanelTexture(256);
        int alike = 0;
        for (int y = 0; y < 256; ++y) {
            for (int x = 0; x + 1 < 256; ++x) {
                alike += red(image, x, y) == red(image, x + 1, y) ? 1 : 0;
            }
        }
        QVERIFY(alike < 256 * 256 / 4);
    }

    void smallestIsAPictureToo() { QCOMPARE(makePanelTexture(4).pixels.size(), std::size_t{64}); }
};

HITSCOPE_TEST(PanelTextureTest, QCoreApplication)

}  // namespace hitscope::panel_texture_test

#include "panel_texture_test.moc"
