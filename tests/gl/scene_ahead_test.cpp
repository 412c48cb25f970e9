// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that are drawn ahead of being shown: the same as others, wherever they are kept.
#include <QTest>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "render/refined/refined_picture.h"
#include "scene/refined_view.h"
#include "scene/scene_gpu.h"
#include "scene_draw_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_ahead_test {

using namespace test;

class SceneAheadTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void init() {
        m_session = std::make_unique<Session>();
        m_session->loadScene({{}, twoCubes(), 0.0f});
        m_refined = std::make_unique<RefinedView>(RefinedView::Pixels::UntilSettled);
        auto created = SceneGpu::create(*m_session);
        QVERIFY(created);
        m_gpu = std::move(created).value();
        m_view = smallView(*m_session, true);
        m_view.isAtRest = true;
        QVERIFY(m_gpu->sync().ok());
    }
    void cleanup() {
        m_refined.reset();
        m_gpu.reset();
        m_session.reset();
        QCOMPARE(m_gl.errors(), QStringList());
    }
    void areTheSame_data();
    void areTheSame();
    void hitsAreInThem();
    void samplesAreInThem();
    void goWithTheirRefinedPicture();

private:
    [[nodiscard]] Image drawAhead() {
        const Result<bool> begun = m_gpu->drawAhead(m_view, m_refined.get());
        return begun && begun.value() ? readAhead() : Image{};
    }
    /// In the order of other images; nothing: there is none to read.
    [[nodiscard]] Image readAhead() {
        Image image;
        std::tie(image.width, image.height) = m_gpu->aheadSize();
        image.pixels.resize(4 * static_cast<std::size_t>(image.width) *
                            static_cast<std::size_t>(image.height));
        if (!m_gpu->readAhead(image.pixels.data(), m_refined.get())) {
            return {};
        }
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
            std::swap(image.pixels[i], image.pixels[i + 2]);
        }
        return image;
    }
    /// softpipe rounds a few values otherwise.
    [[nodiscard]] bool isAlike(const Image& a, const Image& b) {
        return !a.pixels.empty() && a.width == b.width &&
               std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), b.pixels.end(),
                          [](int left, int right) { return std::abs(left - right) <= 1; });
    }

    GlFixture m_gl;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<RefinedView> m_refined;
    std::unique_ptr<SceneGpu> m_gpu;
    SceneGpu::View m_view;
};

void SceneAheadTest::areTheSame_data() {
    QTest::addColumn<bool>("isAtRest");
    QTest::addColumn<bool>("hasCrosshair");
    QTest::addColumn<bool>("hasRefined");
    QTest::newRow("at rest") << true << false << true;
    QTest::newRow("at rest, something over it") << true << true << true;
    QTest::newRow("not at rest") << false << false << true;
    QTest::newRow("never refined") << true << false << false;
}

void SceneAheadTest::areTheSame() {
    QFETCH(bool, isAtRest);
    QFETCH(bool, hasCrosshair);
    QFETCH(bool, hasRefined);
    m_view.isAtRest = isAtRest;
    m_view.options.crosshair = hasCrosshair;
    if (!hasRefined) {
        m_refined.reset();
    }
    const Image expected = drawn(*m_gpu, m_view);
    QVERIFY(isAlike(drawAhead(), expected));
    QVERIFY(isAlike(drawAhead(), expected));
    m_view.options.crosshair = !hasCrosshair;
    const Image other = drawn(*m_gpu, m_view);
    QVERIFY(other.pixels != expected.pixels);
    QVERIFY(isAlike(drawAhead(), other));
    m_view.options.crosshair = hasCrosshair;
    QVERIFY(isAlike(drawAhead(), expected));
}

void SceneAheadTest::hitsAreInThem() {
    const Image whole = drawAhead();
    Hit hit;
    hit.target = m_session->targets()[0]->id;
    hit.point = m_session->targets()[0]->worldBounds().max;
    hit.direction = {-1.0f, -1.0f, -1.0f};
    hit.constants.maxDistance = 1.0f;
    QVERIFY(m_session->hits().add(hit).ok());
    const Image dented = drawAhead();
    QVERIFY(dented.pixels != whole.pixels);
    QVERIFY(isAlike(dented, drawn(*m_gpu, m_view)));
}

void SceneAheadTest::samplesAreInThem() {
    const Image plain = drawAhead();
    for (int i = 0; m_refined->samples() < RefinedView::kFewestShown && i < 100; ++i) {
        QVERIFY(m_gpu->refine(m_view, *m_refined).ok());
    }
    QVERIFY(m_refined->samples() >= RefinedView::kFewestShown);
    const Image refined = drawAhead();
    QVERIFY(refined.pixels != plain.pixels);
    QVERIFY(isAlike(refined, drawn(*m_gpu, m_view, m_refined.get())));
}

/// Which may be forgotten before what was drawn is shown.
void SceneAheadTest::goWithTheirRefinedPicture() {
    QVERIFY(m_gpu->drawAhead(m_view, m_refined.get()).value());
    if (m_refined->picture().plainFramebuffer() == 0) {
        QSKIP("it was not drawn there");
    }
    m_refined.reset();
    QVERIFY(readAhead().pixels.empty());
    m_refined = std::make_unique<RefinedView>();
    QVERIFY(isAlike(drawAhead(), drawn(*m_gpu, m_view)));
}

HITSCOPE_TEST(SceneAheadTest, QCoreApplication)

}  // namespace hitscope::scene_ahead_test

#include "scene_ahead_test.moc"
