// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of targets that a cutting plane opens.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render/pick_pass.h"
#include "render/picking_trial.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::cut_test {

using namespace test;

namespace {

constexpr int kSide = 160;  // pixels
constexpr float kRadius = 2.5f;

CuttingPlane acrossX(float offset) {
    CuttingPlane cut;
    cut.on = true;
    cut.offset = offset;
    return cut;
}

SectionCurve circle(float x) {
    SectionCurve curve;
    curve.closed = true;
    const float radius = std::sqrt(kRadius * kRadius - x * x);
    for (int i = 0; i < 90; ++i) {
        const float angle = static_cast<float>(i) * 0.0698132f;
        curve.points.emplace_back(x, radius * std::cos(angle), radius * std::sin(angle));
    }
    return curve;
}

}  // namespace

class CutTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void cleanupTestCase();
    void offIsAsBefore();
    void halfOfASphereIsMissing_data();
    void halfOfASphereIsMissing();
    void everyWayToDrawIsCut_data();
    void everyWayToDrawIsCut();
    void pipelinesAgree();
    void shadowsStayWhole();
    void fillingClosesWhatIsCut();
    void picksWhatIsSeen();
    void sectionLinesAreDrawn();
    void thePaneIsDrawn();
    void nothingStaysBehind();

private:
    /// The sphere about the origin, from the front, parallel: x to the right, its outline in the picture.
    [[nodiscard]] Frame frame() const {
        Frame made = frameOf(*m_scene, kSide, kSide);
        made.camera.setPivot(glm::vec3(0.0f), 0.0f, 0.0f, 12.0f);
        made.camera.setProjection(Projection::Orthographic);
        made.options.normals = NormalMode::Paper;
        made.options.floor = false;
        return made;
    }
    [[nodiscard]] QImage draw(const Frame& shown, DeformationPipeline& pipeline) {
        return picture(*m_renderer, shown, pipeline);
    }
    /// Where there is nothing but background.
    [[nodiscard]] QImage empty(Frame shown) {
        shown.targets = {};
        const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
        return draw(shown, *pipeline);
    }
    /// Pixels from the middle, of a world x.
    [[nodiscard]] int column(float x) const {
        const Frame shown = frame();
        return kSide / 2 + static_cast<int>(std::lround(x * kSide / shown.camera.heightAt(1.0f)));
    }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<TestScene> m_scene;
    std::vector<Hit> m_hits = dents({1}, 8);
};

void CutTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
    if (!m_renderer) {
        return;
    }
    m_scene = std::make_unique<TestScene>();
    m_scene->add(*m_renderer, makeUvSphere(48, 32, kRadius), glm::vec3(0.0f));
}

void CutTest::cleanup() {
    QCOMPARE(m_gl.errors(), QStringList());
}

void CutTest::cleanupTestCase() {
    m_scene.reset();
    m_renderer.reset();
}

void CutTest::offIsAsBefore() {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, m_hits);
    for (const WireframeMode wireframe : {WireframeMode::Off, WireframeMode::Over, WireframeMode::Only}) {
        Frame plain = frame();
        plain.options.wireframe = wireframe;
        plain.options.needles = true;
        plain.options.dots = true;
        Frame off = plain;
        off.options.cut = acrossX(0.0f);
        off.options.cut.fill = true;
        Frame on = off;
        off.options.cut.on = false;
        off.section = std::make_shared<SectionLines>(SectionLines{{circle(0.0f)}, {circle(0.0f)}});
        off.showsCutPlane = true;
        const QImage before = draw(plain, *pipeline);
        QVERIFY(differing(before, draw(on, *pipeline)) > 1000);
        QCOMPARE(differing(before, draw(off, *pipeline)), 0);
    }
}

void CutTest::halfOfASphereIsMissing_data() {
    QTest::addColumn<int>("kind");
    for (const PipelineTraits& traits : allPipelines()) {
        QTest::newRow(traits.key.data()) << static_cast<int>(traits.kind);
    }
}

void CutTest::halfOfASphereIsMissing() {
    QFETCH(int, kind);
    if (const auto why = whyUnavailable(static_cast<PipelineKind>(kind))) {
        QSKIP(why->c_str());
    }
    const auto pipeline = m_scene->pipeline(static_cast<PipelineKind>(kind), m_hits);
    const QImage nothing = empty(frame());
    for (const float offset : {0.0f, 0.8f, -1.1f}) {
        for (const bool flipped : {false, true}) {
            Frame cut = frame();
            cut.options.cut = acrossX(offset);
            cut.options.cut.flipped = flipped;
            const QImage shown = draw(cut, *pipeline);
            const int at = column(offset);
            const QRect left(0, 0, at - 1, kSide);
            const QRect right(at + 1, 0, kSide - at - 1, kSide);
            const QRect gone = flipped ? left : right;
            const QRect there = flipped ? right : left;
            QCOMPARE(differing(shown.copy(gone), nothing.copy(gone)), 0);
            QVERIFY(differing(shown.copy(there), nothing.copy(there), 8) > 700);
        }
    }
}

void CutTest::everyWayToDrawIsCut_data() {
    QTest::addColumn<DisplayOptions>("options");
    const auto row = [](const char* name, auto&& change) {
        DisplayOptions options{.normals = NormalMode::Paper, .floor = false};
        change(options);
        QTest::newRow(name) << options;
    };
    row("over", [](DisplayOptions& o) { o.wireframe = WireframeMode::Over; });
    row("only", [](DisplayOptions& o) { o.wireframe = WireframeMode::Only; });
    row("flat", [](DisplayOptions& o) { o.flat = true; });
    row("dots", [](DisplayOptions& o) { o.dots = true; });
    row("back faces", [](DisplayOptions& o) { o.backFaces = true; });
    row("ghost wire", [](DisplayOptions& o) { o.beforeAfter.ghost = GhostMode::Wire; });
    row("ghost translucent", [](DisplayOptions& o) { o.beforeAfter.ghost = GhostMode::Translucent; });
    row("wipe", [](DisplayOptions& o) { o.beforeAfter.wipe = true; });
    row("exaggerated", [](DisplayOptions& o) { o.beforeAfter.exaggeration = 2.0f; });
    row("filled", [](DisplayOptions& o) { o.cut.fill = true; });
}

void CutTest::everyWayToDrawIsCut() {
    QFETCH(DisplayOptions, options);
    const auto pipeline = m_scene->pipeline(PipelineKind::UniformArray, m_hits);
    for (const int height : {kSide, 4 * kSide}) {  // lines of a pixel, and wide ones
        Frame cut = frame();
        cut.width = cut.height = height;
        const bool fill = options.cut.fill;
        cut.options = options;
        cut.options.cut = acrossX(0.3f);
        cut.options.cut.fill = fill;
        const QImage shown = draw(cut, *pipeline);
        const QImage nothing = empty(cut);
        const int at = height / kSide * (column(0.3f) - kSide / 2) + height / 2;
        const int past = at + 4 * height / kSide;  // dots and lines have a width
        const QRect right(past, 0, height - past, height);
        QCOMPARE(differing(shown.copy(right), nothing.copy(right)), 0);
        const QRect left(0, 0, at, height);
        QVERIFY(differing(shown.copy(left), nothing.copy(left), 4) > 800);
    }
}

void CutTest::pipelinesAgree() {
    Frame cut = frame();
    cut.options.cut = acrossX(0.2f);
    cut.options.wireframe = WireframeMode::Over;
    const auto feedback = m_scene->pipeline(PipelineKind::TransformFeedback, m_hits);
    const QImage first = draw(cut, *feedback);
    for (const PipelineTraits& traits : allPipelines()) {
        if (!whyUnavailable(traits.kind)) {
            const auto other = m_scene->pipeline(traits.kind, m_hits);
            QCOMPARE(differing(first, draw(cut, *other)), 0);
        }
    }
}

void CutTest::shadowsStayWhole() {
    // On the floor, where all of the sphere is hidden: its shadow and nothing else.
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    Frame cut = frameOf(*m_scene, kSide, kSide);
    cut.options.shadows = true;
    cut.camera.orbit(0.0f, 0.5f);
    cut.options.cut = acrossX(-100.0f);
    const QImage shadowed = draw(cut, *pipeline);
    cut.options.shadows = false;
    QVERIFY(differing(shadowed, draw(cut, *pipeline), 24) > 500);
}

void CutTest::fillingClosesWhatIsCut() {
    // Looking into the half from its open side: all one sees of it is filling.
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    Frame cut = frame();
    cut.camera.setPivot(glm::vec3(0.0f), 1.5707963f, 0.0f, 12.0f);
    for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
        cut.camera.setProjection(projection);
        cut.options.cut = acrossX(0.0f);
        const QImage open = draw(cut, *pipeline);
        cut.options.cut.fill = true;
        const QImage filled = draw(cut, *pipeline);
        QVERIFY(differing(open, filled, 8) > 2500);
        int greys = 0;
        for (int y = 60; y < 100; ++y) {
            for (int x = 60; x < 100; ++x) {
                const QColor colour(filled.pixel(x, y));
                greys += colour.blue() > colour.red() && colour.lightness() > 70 ? 1 : 0;
            }
        }
        QCOMPARE(greys, 1600);
        // From outside nothing is filled.
        cut.options.cut.flipped = true;
        const QImage outside = draw(cut, *pipeline);
        cut.options.cut.fill = false;
        QCOMPARE(differing(outside, draw(cut, *pipeline)), 0);
        cut.options.cut.flipped = false;
    }
}

void CutTest::picksWhatIsSeen() {
    const PipelineKind kind =
        whyUnavailable(PipelineKind::Compute) ? PipelineKind::TransformFeedback : PipelineKind::Compute;
    const auto pipeline = m_scene->pipeline(kind, m_hits);
    Frame cut = frame();
    cut.options.cut = acrossX(0.3f);
    PickPass pass;
    pass.setWay(tryPicking().byGeometry);
    const PixelArea all{0, 0, kSide, kSide};
    DeformationPipeline* shown = pipeline.get();
    const auto count = [&](PickElements elements, int from, int to) {
        const bool drawn = pass.draw(cut, *shown, all, elements).ok();
        const std::vector<PickedElement> picked = pass.read();
        int found = 0;
        for (int y = 0; drawn && y < kSide; ++y) {
            for (int x = from; x < to; ++x) {
                found +=
                    picked[std::size_t{kSide} * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)]
                            .target
                        ? 1
                        : 0;
            }
        }
        return found;
    };
    const int at = column(0.3f);
    for (const PickElements elements : {PickElements::Triangles, PickElements::Points}) {
        QVERIFY(count(elements, 0, at) > 150);
        QCOMPARE(count(elements, at + 1, kSide), 0);
        cut.options.cut.on = false;
        QVERIFY(count(elements, at + 1, kSide) > 100);
        cut.options.cut.on = true;
    }
    // Nothing of the inside is seen where the cut is filled.
    const auto whole = m_scene->pipeline(kind, {});
    shown = whole.get();
    cut.camera.setPivot(glm::vec3(0.0f), 1.5707963f, 0.0f, 12.0f);
    QVERIFY(count(PickElements::Triangles, 60, 100) > 2000);
    cut.options.cut.fill = true;
    QVERIFY(count(PickElements::Triangles, 60, 100) < 50);  // slivers at the rim, seen edge on
}

void CutTest::sectionLinesAreDrawn() {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    Frame cut = frame();
    cut.camera.setPivot(glm::vec3(0.0f), 1.5707963f, 0.0f, 12.0f);
    cut.options.cut = acrossX(0.3f);
    const QImage without = draw(cut, *pipeline);
    cut.section = std::make_shared<SectionLines>(SectionLines{{circle(0.3f)}, {circle(0.3f)}});
    cut.options.cut.originalLine = cut.options.cut.deformedLine = false;
    QCOMPARE(differing(without, draw(cut, *pipeline)), 0);
    cut.options.cut.deformedLine = true;
    const QImage deformed = draw(cut, *pipeline);
    // Orange, all around: at a circle's distance from the middle.
    const auto radius = std::sqrt(kRadius * kRadius - 0.09f) * kSide / cut.camera.heightAt(1.0f);
    for (int i = 0; i < 36; ++i) {
        const float angle = static_cast<float>(i) * 0.1745329f;
        const QPoint place(static_cast<int>(0.5f * kSide + radius * std::cos(angle)),
                           static_cast<int>(0.5f * kSide + radius * std::sin(angle)));
        int found = 0;
        for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
                const QColor colour(deformed.pixel(place + QPoint(x, y)));
                found += colour.red() > colour.blue() + 100 ? 1 : 0;
            }
        }
        QVERIFY2(found > 0, qPrintable(QString::number(i)));
    }
    cut.options.cut.deformedLine = false;
    cut.options.cut.originalLine = true;
    const int dashed = differing(without, draw(cut, *pipeline), 24);
    const int whole = differing(without, deformed, 24);
    QVERIFY2(dashed > 40 && dashed < whole, qPrintable(QStringLiteral("%1 of %2").arg(dashed).arg(whole)));
}

void CutTest::thePaneIsDrawn() {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    Frame cut = frame();
    cut.camera.setPivot(glm::vec3(0.0f), 1.0f, 0.3f, 12.0f);
    cut.options.cut = acrossX(0.3f);
    const QImage without = draw(cut, *pipeline);
    cut.showsCutPlane = true;
    QVERIFY(differing(without, draw(cut, *pipeline), 8) > 3000);
}

void CutTest::nothingStaysBehind() {
    // A frame without a plane after one with it: state does not leak.
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, m_hits);
    const QImage before = draw(frame(), *pipeline);
    Frame cut = frame();
    cut.options.cut = acrossX(0.0f);
    static_cast<void>(draw(cut, *pipeline));
    QVERIFY(glIsEnabled(GL_CLIP_DISTANCE0) == GL_FALSE);
    QCOMPARE(differing(before, draw(frame(), *pipeline)), 0);
}

HITSCOPE_TEST(CutTest, QCoreApplication)

}  // namespace hitscope::cut_test

#include "cut_test.moc"
