// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels whose first samples are alike get no more, where the CPU draws: the picture is as good as with all
// samples.
#include <QTest>
#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <numeric>
#include <vector>

#include "gl/context.h"
#include "refined_scene.h"
#include "render/refined/marked_tiles.h"
#include "render/seen/visible_runs.h"
#include "support/baseline.h"
#include "support/test_program.h"

namespace hitscope::refined_settled_test {

using namespace test;

namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 180;

}  // namespace

class RefinedSettledTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_refined.open(); }
    void cleanup() { QCOMPARE(m_refined.gl.errors(), QStringList()); }
    void cleanupTestCase() { m_refined.close(); }
    void asGoodAsWithAllSamples_data();
    void asGoodAsWithAllSamples();
    void whatChangesIsSeenAgain();
    void shadowsAreKeptForTheCameraAlone();
    void neitherTransparentNorGpu();
    void tiles_data();
    void tiles();
    void tilesAroundParts();
    void trianglesElsewhereAreLeftOut();
    void hidesWhatIsBehindAllPixels();
    void hiddenTrianglesAreLeftOut();

private:
    struct Refined {
        QImage image;
        bool settled = false;
        int tiles = 0;  ///< of 8 x 8 pixels, in which samples are still drawn
    };
    [[nodiscard]] Refined refined(const Frame& frame, RefinedPicture& picture, int samples);
    [[nodiscard]] Frame frame(const DisplayOptions& options) const {
        return m_refined.frame(kWidth, kHeight, options);
    }
    [[nodiscard]] static bool isSoftware() { return ::hitscope::gl::rendererInfo().isSoftware(); }

    RefinedScene m_refined;
};

RefinedSettledTest::Refined RefinedSettledTest::refined(const Frame& frame, RefinedPicture& picture,
                                                        int samples) {
    while (picture.samples() < samples) {
        if (!m_refined.renderer->refine(frame, *m_refined.pipeline, picture).ok()) {
            QTest::qFail("nothing is refined", __FILE__, __LINE__);
            return {};
        }
    }
    Refined result{m_refined.shown(frame, picture)};
    if (const render::MarkedTiles* unsettled = picture.unsettled()) {
        result.settled = true;
        for (int y = 0; y < kHeight; y += 8) {
            for (int x = 0; x < kWidth; x += 8) {
                result.tiles += unsettled->any({x, y, 8, 8}) ? 1 : 0;
            }
        }
    }
    return result;
}

void RefinedSettledTest::asGoodAsWithAllSamples_data() {
    QTest::addColumn<DisplayOptions>("options");
    QTest::newRow("shadows") << DisplayOptions{.shadows = true};
    QTest::newRow("no shadows") << DisplayOptions{.shadows = false};
    QTest::newRow("environment") << DisplayOptions{.environment = true};
    QTest::newRow("wireframe over") << DisplayOptions{.wireframe = WireframeMode::Over, .shadows = true};
    QTest::newRow("wireframe") << DisplayOptions{.wireframe = WireframeMode::Only};
}

void RefinedSettledTest::asGoodAsWithAllSamples() {
    QFETCH(DisplayOptions, options);
    const Frame view = frame(options);
    RefinedPicture settling(RefinedPicture::Extent::WhereItStillVaries);
    QVERIFY(!refined(view, settling, RefinedPicture::kJudged - 1).settled);
    const Refined few = refined(view, settling, RefinedPicture::kUsualSamples);
    QCOMPARE(few.settled, isSoftware());
    if (few.settled && options.wireframe == WireframeMode::Off) {
        constexpr int kAll = (kWidth / 8) * ((kHeight + 7) / 8);
        QVERIFY2(few.tiles > 20 && few.tiles < 3 * kAll / 4, qPrintable(QString::number(few.tiles)));
    }
    RefinedPicture all;
    const QImage many = refined(view, all, RefinedPicture::kUsualSamples).image;
    const QImage reference = refined(view, all, RefinedPicture::kMostSamples).image;
    const double fewOff = meanDifference(few.image, reference);
    const double manyOff = meanDifference(many, reference);
    constexpr int kMuch = 12;  // levels
    const int fewMuch = differing(few.image, reference, kMuch);
    const int manyMuch = differing(many, reference, kMuch);
    const QString found = QStringLiteral("%1 %2, %3 %4").arg(fewOff).arg(manyOff).arg(fewMuch).arg(manyMuch);
    QVERIFY2(fewOff < manyOff + 0.12, qPrintable(found));
    QVERIFY2(fewMuch <= manyMuch + 4, qPrintable(found));
}

/// Of another picture nothing is settled.
void RefinedSettledTest::whatChangesIsSeenAgain() {
    RefinedPicture picture(RefinedPicture::Extent::WhereItStillVaries);
    (void)refined(frame({.shadows = true}), picture, 16);
    picture.clear();
    const Frame other = frame({.environment = true});
    const QImage again = refined(other, picture, 16).image;
    RefinedPicture alone(RefinedPicture::Extent::WhereItStillVaries);
    QCOMPARE(differing(again, refined(other, alone, 16).image, 0), 0);
}

/// Shadow maps stay while the camera moves; what moves or is changed casts others.
void RefinedSettledTest::shadowsAreKeptForTheCameraAlone() {
    Frame turned = frame({.shadows = true});
    turned.camera.orbit(0.4f, 0.2f);
    std::vector<DrawItem> items(turned.targets.begin(), turned.targets.end());
    items[0].model = glm::translate(items[0].model, glm::vec3(0.8f, 0.6f, 0.0f));
    Frame moved = turned;
    moved.targets = items;
    Frame lit = turned;
    lit.lights.directional.direction = glm::vec3(0.7f, -1.0f, 0.2f);
    Frame changed = turned;  // as after a hit
    changed.meshRevision = 2;
    changed.options.beforeAfter.exaggeration = 3.0f;
    RefinedPicture picture(RefinedPicture::Extent::WhereItStillVaries);
    (void)refined(frame({.shadows = true}), picture, 16);
    for (const Frame& next : {turned, moved, lit, changed}) {
        picture.clear();
        const QImage again = refined(next, picture, 16).image;
        auto fresh = Renderer::create();
        QVERIFY(fresh.ok());
        RefinedPicture alone(RefinedPicture::Extent::WhereItStillVaries);
        while (alone.samples() < 16) {
            QVERIFY(fresh.value()->refine(next, *m_refined.pipeline, alone).ok());
        }
        QCOMPARE(differing(again, m_refined.shown(next, alone), 0), 0);
    }
}

void RefinedSettledTest::neitherTransparentNorGpu() {
    RefinedPicture picture(RefinedPicture::Extent::WhereItStillVaries);
    const Refined transparent = refined(frame({.transparent = true}), picture, 16);
    QVERIFY(!transparent.settled);
    QCOMPARE(qAlpha(transparent.image.pixel(0, 0)), 0);
}

void RefinedSettledTest::tiles_data() {
    QTest::addColumn<int>("x");  // of the only mark, in an area that starts at (5, 3)
    QTest::addColumn<int>("y");
    QTest::newRow("first") << 0 << 0;
    QTest::newRow("last") << 36 << 20;
    QTest::newRow("between") << 17 << 9;
}

void RefinedSettledTest::tiles() {
    QFETCH(int, x);
    QFETCH(int, y);
    const PixelArea area{5, 3, 37, 21};
    std::vector<std::uint8_t> marks(37 * 21, 0);
    QVERIFY(!render::MarkedTiles(area, marks).any({0, 0, 100, 100}));
    marks[static_cast<std::size_t>(y * area.width + x)] = 1;
    const render::MarkedTiles marked(area, marks);
    const int column = area.x + x;
    const int row = area.y + y;
    QVERIFY(marked.any({column, row, 1, 1}));
    QVERIFY(marked.any({-10, -10, 100, 100}));
    QVERIFY(!marked.any({-10, -10, 200, 13}));  // below the area
    QVERIFY(!marked.any({column, row, 0, 1}));
    // Beside the tile.
    const int left = area.x + x / 8 * 8;
    const int low = area.y + y / 8 * 8;
    QVERIFY(!marked.any({left - 8, low, 8, 8}));
    QVERIFY(!marked.any({left + 8, low, 8, 8}));
    QVERIFY(!marked.any({left, low - 8, 8, 8}));
    QVERIFY(!marked.any({left, low + 8, 8, 8}));
}

void RefinedSettledTest::tilesAroundParts() {
    const std::vector<PixelArea> parts{{5, 3, 10, 20}, {6, 4, 2, 2}, {40, 3, 1, 1}, {}, {5, 40, 36, 1}};
    const render::MarkedTiles tiles = render::MarkedTiles::around(parts);
    const std::vector<PixelArea> rectangles = tiles.rectangles();
    std::size_t pixels = 0;
    for (const PixelArea& rectangle : rectangles) {
        pixels += static_cast<std::size_t>(rectangle.width) * static_cast<std::size_t>(rectangle.height);
    }
    QCOMPARE(tiles.pixels(), pixels);  // which would be more if they overlapped and nothing were left out
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 60; ++x) {
            const auto holds = [x, y](const PixelArea& area) {
                return !intersected(area, PixelArea{x, y, 1, 1}).empty();
            };
            const bool isDrawn = std::any_of(rectangles.begin(), rectangles.end(), holds);
            QCOMPARE(tiles.any({x, y, 1, 1}), isDrawn);
            QVERIFY(isDrawn || std::none_of(parts.begin(), parts.end(), holds));
        }
    }
    QCOMPARE(rectangles.size(), std::size_t{4});
    QVERIFY(!tiles.any({30, 12, 8, 20}));
    QVERIFY(render::MarkedTiles::around({}).rectangles().empty());
}

void RefinedSettledTest::trianglesElsewhereAreLeftOut() {
    const Frame view = frame({});
    const DrawItem& item = view.targets[0];
    const float aspect = static_cast<float>(kWidth) / static_cast<float>(kHeight);
    const std::uint32_t all = item.buffers->triangleIndexCount();
    const auto seenIn = [&](const render::MarkedTiles* tiles) {
        render::Sight sight(view.camera.projection(aspect) * view.camera.view() * item.model, {});
        sight.limitTo({tiles, {kWidth, kHeight}});
        const auto runs = render::visibleRuns(item, view, *m_refined.pipeline, sight,
                                              item.buffers->triangleRuns(), {0, all});
        return runs ? countOf(*runs) : all;
    };
    const PixelArea whole{0, 0, kWidth, kHeight};
    std::vector<std::uint8_t> marks(std::size_t{kWidth} * kHeight, 0);
    QCOMPARE(seenIn(nullptr), std::size_t{all});
    const render::MarkedTiles none(whole, marks);
    QCOMPARE(seenIn(&none), std::size_t{0});
    marks[std::size_t{kWidth} * (kHeight / 2) + kWidth / 2] = 1;
    const render::MarkedTiles middle(whole, marks);
    const std::size_t few = seenIn(&middle);
    QVERIFY2(few > 0 && few < all / 4, qPrintable(QString::number(few)));
}

void RefinedSettledTest::hidesWhatIsBehindAllPixels() {
    constexpr int kColumns = 37;
    constexpr int kRows = 21;
    std::vector<float> depths(kColumns * kRows, 0.25f);
    depths[kColumns * 12 + 17] = 0.75f;
    const render::FrontDepths front({0, 0, kColumns, kRows}, depths);
    QVERIFY(front.hide({0, 0, 8, 8}, 0.5f));
    QVERIFY(!front.hide({0, 0, 8, 8}, 0.25f));
    QVERIFY(!front.hide({0, 0, 8, 8}, 0.2f));
    QVERIFY(!front.hide({17, 12, 1, 1}, 0.5f));
    QVERIFY(!front.hide({0, 0, kColumns, kRows}, 0.5f));
    QVERIFY(front.hide({0, 0, kColumns, kRows}, 0.8f));
    QVERIFY(front.hide({30, 16, 100, 100}, 0.5f));  // what is outside of the picture is not seen
    QVERIFY(!front.hide({5, 5, 0, 3}, 0.5f));
}

/// The sphere's back, and nothing that any sample shows.
void RefinedSettledTest::hiddenTrianglesAreLeftOut() {
    const Frame view = frame({.shadows = false});
    RefinedPicture settling(RefinedPicture::Extent::WhereItStillVaries);
    RefinedPicture all;
    const QImage few = refined(view, settling, RefinedPicture::kJudged - 1).image;
    // Between pixels a sample may see a little further round an edge.
    constexpr int kRoundEdges = 4;
    QVERIFY(differing(few, refined(view, all, RefinedPicture::kJudged - 1).image, 0) <= kRoundEdges);
    QCOMPARE(all.front(), nullptr);
    if (!isSoftware()) {
        return;
    }
    QVERIFY(settling.front() != nullptr);
    const DrawItem& item = view.targets[0];
    const float aspect = static_cast<float>(kWidth) / static_cast<float>(kHeight);
    render::Sight sight(view.camera.projection(aspect) * view.camera.view() * item.model, {});
    sight.hideBehind(settling.front(), {kWidth, kHeight});
    const std::uint32_t indices = item.buffers->triangleIndexCount();
    const auto runs = render::visibleRuns(item, view, *m_refined.pipeline, sight,
                                          item.buffers->triangleRuns(), {0, indices});
    QVERIFY(runs.has_value());
    const std::size_t seen = countOf(*runs);
    QVERIFY2(seen > indices / 2 && seen < 9 * indices / 10,
             qPrintable(QStringLiteral("%1 of %2").arg(seen).arg(indices)));
}

HITSCOPE_TEST(RefinedSettledTest, QCoreApplication)

}  // namespace hitscope::refined_settled_test

#include "refined_settled_test.moc"
