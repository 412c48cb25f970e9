// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of which only the part is drawn again where vertices have moved.
#include <QTest>
#include <algorithm>
#include <cstdlib>

#include "pipeline_rows.h"
#include "render/refined/refined_picture.h"
#include "scene/refined_view.h"
#include "scene/scene_gpu.h"
#include "scene_draw_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_patch_test {

using namespace test;

namespace {

/// softpipe rounds a few values otherwise where triangles come in another order.
bool isAlike(const Image& a, const Image& b) {
    return std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), b.pixels.end(),
                      [](int left, int right) { return std::abs(left - right) <= 1; });
}

}  // namespace

class ScenePatchTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        m_gl.open();
        if (!gl::rendererInfo().isSoftware()) {
            QSKIP("only software renderers patch pictures");
        }
    }
    void cleanup() {
        m_dent = 0.5f;
        m_refined.reset();
        m_gpu.reset();
        m_session.reset();
        QCOMPARE(m_gl.errors(), QStringList());
    }
    void isTheWholePicture_data() { addPipelines(); }
    void isTheWholePicture();
    void projectilesFlyOverIt();
    void shadowsFollow();
    void drawsLess();
    void othersAreDrawnAnew_data();
    void othersAreDrawnAnew();
    void isRefinedAsIfDrawnAnew();
    void aRefinedPictureStays();
    void onlyWhatDiffersIsRefinedAgain();
    void hurriedOnesAreRough();
    void roughOnesArePatched();

private:
    void open(int rings, PipelineKind kind = PipelineKind::TransformFeedback, float height = 0.0f) {
        m_session = std::make_unique<Session>();
        std::vector<TargetPlan> plans(2, planPrimitive({PrimitiveKind::UvSphere, rings, 12.0f}));
        plans[0].transform.position.y = height;
        plans[1].transform.position.x = 14.0f;
        m_session->loadScene({{}, std::move(plans), 0.0f});
        m_session->targets().select(m_session->targets()[0]->id);
        m_session->settings().setPipeline(kind);
        m_refined = std::make_unique<RefinedView>(RefinedView::Pixels::UntilSettled);
        auto created = SceneGpu::create(*m_session);
        QVERIFY(created);
        m_gpu = std::move(created).value();
        m_view = smallView(*m_session, true);
        m_view.isAtRest = true;
        QVERIFY(m_gpu->sync().ok());
    }
    /// With many triangles in a dent.
    void openLarge() {
        open(400);
        m_view.width *= 2;
        m_view.height *= 2;
        m_dent = 2.0f;
    }
    [[nodiscard]] Image draw() { return drawn(*m_gpu, m_view, m_refined.get()); }
    /// By one that has nothing to patch.
    [[nodiscard]] Image drawAnew() { return drawn(*m_gpu, m_view); }
    /// The same in full, with depths of as many bits.
    [[nodiscard]] Image drawAgain() {
        m_refined->forget();
        return draw();
    }
    [[nodiscard]] Status hit(const glm::vec3& point) {
        Hit hit;
        hit.target = m_session->targets()[0]->id;
        hit.point = point;
        hit.direction = -glm::normalize(point);
        hit.constants = {.maxDistance = m_dent, .power = 2.0f, .maxMagnitude = m_dent};
        return m_session->hits().add(hit);
    }
    /// Draws until all has been read back: first in part, and in the end what is drawn anew.
    void follow() {
        for (int pictures = 0; pictures < 100; ++pictures) {
            const Image patched = draw();
            QVERIFY(m_refined->wasPatched() || pictures > 0);  // it may not have arrived
            QVERIFY(m_refined->isWhole());
            if (!m_gpu->isReadBackPending()) {
                QVERIFY(patched.pixels == drawAnew().pixels);
                return;
            }
        }
        QFAIL("what was moved is not read back");
    }
    [[nodiscard]] Status refineOnce() {
        SceneGpu::View view = m_view;
        view.detail = {};
        return m_gpu->refine(view, *m_refined);
    }
    void refine(int samples) {
        for (int calls = 0; m_refined->samples() < samples && calls < 200; ++calls) {
            QVERIFY(refineOnce().ok());
        }
        QCOMPARE(m_refined->samples(), samples);
    }

    GlFixture m_gl;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;
    std::unique_ptr<RefinedView> m_refined;
    SceneGpu::View m_view;
    float m_dent = 0.5f;  // metres
};

/// After hits, their undo and their redo.
void ScenePatchTest::isTheWholePicture() {
    QFETCH(const int, kind);
    HITSCOPE_NEEDS_PIPELINE(kind);
    open(24, static_cast<PipelineKind>(kind));  // normals change far beside a hit
    const Image whole = draw();
    QVERIFY(m_refined->isPlain());
    QVERIFY(!m_refined->wasPatched());
    QVERIFY(hit({1.2f, 1.6f, 5.7f}).ok());
    follow();
    const Image dented = draw();
    QVERIFY(!m_refined->wasPatched());  // nothing has moved since
    QVERIFY(dented.pixels != whole.pixels);
    QVERIFY(hit({3.7f, 4.1f, 2.4f}).ok());  // its shadow falls on the other sphere
    follow();
    QVERIFY(hit({3.3f, 3.7f, 3.3f}).ok());
    follow();
    m_session->undo();
    follow();
    m_session->undo();
    follow();
    QVERIFY(draw().pixels == dented.pixels);
    m_session->redo();
    follow();
    m_session->undo();
    m_session->undo();
    follow();
    QVERIFY(draw().pixels == whole.pixels);
}

/// With their trails, before and behind what is there, and while their dents are made; then they are gone.
void ScenePatchTest::projectilesFlyOverIt() {
    open(48);
    const Image still = draw();
    const PhysicsWorld& physics = m_session->simulation().physics();
    const glm::vec3 eye = m_view.camera.eye();
    const glm::vec3 target = m_session->targets()[0]->worldBounds().centre();
    m_session->simulation().fire(
        ScheduledShot{0.0, {eye, glm::normalize(target - eye)}, m_session->settings().projectile()});
    QCOMPARE(physics.projectileCount(), std::size_t{1});
    m_view.isAtRest = false;
    m_view.projectilesFly = true;
    m_view.detail.scale = 0.5f;  // what is kept has all pixels
    int seen = 0;
    for (int frame = 0; frame < 40; ++frame) {
        m_session->simulation().advance(1.0 / 60.0);
        QVERIFY(m_gpu->sync().ok());
        const Image picture = draw();
        QVERIFY(m_refined->wasPatched());
        seen += picture.pixels != still.pixels ? 1 : 0;
        SceneGpu::View full = m_view;
        full.detail = {};
        QVERIFY(picture.pixels == drawn(*m_gpu, full).pixels);
    }
    QVERIFY2(seen > 5, qPrintable(QString::number(seen)));
    for (int second = 0; second < 60 && physics.projectileCount() > 0; ++second) {
        m_session->simulation().advance(1.0);
    }
    m_view.projectilesFly = false;
    m_view.detail = {};
    QVERIFY(!m_session->hits().history().hits().empty());
    m_session->hits().clear();
    QVERIFY(m_gpu->sync().ok());
    QVERIFY(draw().pixels == still.pixels);
    QVERIFY(m_refined->wasPatched());
}

/// Where they fall, far from what casts them.
void ScenePatchTest::shadowsFollow() {
    open(48, PipelineKind::TransformFeedback, 10.0f);
    const Image whole = draw();
    m_dent = 3.0f;
    for (const glm::vec3& rim : {glm::vec3(5.1f, 3.2f, 0.1f), glm::vec3(0.0f, -2.9f, 5.2f)}) {
        QVERIFY(hit(rim).ok());
        follow();
        m_session->undo();
        follow();
        QVERIFY(draw().pixels == whole.pixels);
    }
}

void ScenePatchTest::drawsLess() {
    open(200);
    m_view.options.shadows = false;
    static_cast<void>(draw());
    const GLuint all = primitivesOf([this] { static_cast<void>(drawAnew()); });
    if (all == 0) {
        QSKIP("this renderer does not count what it draws");
    }
    QVERIFY(hit({1.2f, 1.6f, 5.7f}).ok());
    const GLuint fewer = primitivesOf([this] { static_cast<void>(draw()); });
    QVERIFY(m_refined->wasPatched());
    QVERIFY2(fewer < all / 2, qPrintable(QStringLiteral("%1 of %2").arg(fewer).arg(all)));
}

/// What shows moved vertices elsewhere than on the surface, or shows more than them.
void ScenePatchTest::othersAreDrawnAnew_data() {
    QTest::addColumn<QString>("what");
    for (const char* what : {"needles", "dots", "ghost", "wipe", "exaggeration", "cut", "transparent",
                             "lines", "camera", "light", "change"}) {
        QTest::addRow("%s", what) << what;
    }
}

void ScenePatchTest::othersAreDrawnAnew() {
    QFETCH(const QString, what);
    open(32);
    DisplayOptions& options = m_view.options;
    options.needles = what == "needles";
    options.dots = what == "dots";
    options.beforeAfter.ghost = what == "ghost" ? GhostMode::Wire : GhostMode::Off;
    options.beforeAfter.wipe = what == "wipe";
    options.beforeAfter.exaggeration = what == "exaggeration" ? 2.0f : 1.0f;
    options.cut.on = what == "cut";
    options.transparent = what == "transparent";
    options.wireframe = what == "lines" ? WireframeMode::Only : WireframeMode::Off;
    options.change.on = what == "change";
    static_cast<void>(draw());
    QVERIFY(m_refined->hasPicture());
    QVERIFY(hit({1.2f, 1.6f, 5.7f}).ok());
    QVERIFY(m_gpu->sync().ok());  // normals have come, too
    if (what == "camera") {
        m_view.camera.orbit(0.1f, 0.0f);
    } else if (what == "light") {
        Lights lights = m_session->settings().lights();
        lights.directional.direction.x += 0.2f;
        m_session->settings().setLights(lights);
    }
    m_view.detail.coarse = true;  // the refiner draws it in full
    const Image picture = draw();
    QVERIFY(!m_refined->wasPatched());
    QVERIFY(!m_refined->hasPicture());
    QVERIFY(picture.pixels == drawAnew().pixels);
}

/// Where the dent was before it was undone, too.
void ScenePatchTest::isRefinedAsIfDrawnAnew() {
    open(32);
    QVERIFY(hit({1.2f, 5.7f, 1.6f}).ok());
    QVERIFY(m_gpu->sync().ok());
    static_cast<void>(draw());
    for (const bool isUndone : {true, false}) {
        isUndone ? m_session->undo() : m_session->redo();
        follow();
        refine(RefinedPicture::kUsualSamples);
        const Image patched = draw();
        QVERIFY(m_refined->wasShown());
        m_refined->forget();
        refine(RefinedPicture::kUsualSamples);
        QVERIFY(draw().pixels == patched.pixels);
        m_refined->forget();
        static_cast<void>(draw());
    }
}

/// Beside the dent there is no other picture than before.
void ScenePatchTest::aRefinedPictureStays() {
    open(32);
    static_cast<void>(draw());
    refine(RefinedPicture::kUsualSamples);
    const Image refined = draw();
    QVERIFY(m_refined->wasShown());
    QVERIFY(hit({-4.8f, 3.2f, 1.6f}).ok());
    QVERIFY(m_gpu->sync().ok());  // normals have come, too
    const Image patched = draw();
    QVERIFY(m_refined->wasPatched());
    QCOMPARE(m_refined->samples(), 0);
    const Image plain = drawAnew();
    std::size_t isRefined = 0;
    std::size_t isPlain = 0;
    std::size_t isNeither = 0;
    for (std::size_t i = 0; i < patched.pixels.size(); ++i) {
        const int value = patched.pixels[i];
        // The sum is rounded once when it is shown, and once when it is kept.
        (std::abs(value - refined.pixels[i]) <= 1 ? isRefined
         : value == plain.pixels[i]               ? isPlain
                                                  : isNeither)++;
    }
    QCOMPARE(isNeither, std::size_t{0});
    QVERIFY(isPlain > 0 && isRefined > 8 * patched.pixels.size() / 10);
}

/// With its soft shadows and occlusion, and both dents where the second comes before the first is refined.
void ScenePatchTest::onlyWhatDiffersIsRefinedAgain() {
    open(200);
    static_cast<void>(draw());
    const GLuint all = primitivesOf([this] { refine(RefinedPicture::kUsualSamples); });
    static_cast<void>(draw());
    const std::vector<std::vector<glm::vec3>> dents{
        {{-4.8f, 3.2f, 1.6f}}, {{1.2f, 5.6f, 1.8f}, {3.7f, 4.1f, 2.4f}}, {{}}};
    for (const std::vector<glm::vec3>& places : dents) {
        GLuint some = 0;
        for (const glm::vec3& place : places) {
            const bool isUndone = place == glm::vec3(0.0f);
            isUndone ? m_session->undo() : static_cast<void>(hit(place));
            QVERIFY(m_gpu->sync().ok());
            static_cast<void>(draw());
            QVERIFY(m_refined->wasPatched());
            const Image patched = draw();
            some += primitivesOf([this] { refine(2); });
            QVERIFY(draw().pixels == patched.pixels);
        }
        some += primitivesOf([this] { refine(RefinedPicture::kUsualSamples); });
        QVERIFY2(4 * some < 3 * all || all == 0, qPrintable(QStringLiteral("%1 of %2").arg(some).arg(all)));
        const Image again = draw();
        QVERIFY(m_refined->wasShown());
        static_cast<void>(drawAgain());
        refine(RefinedPicture::kUsualSamples);
        QVERIFY(isAlike(again, draw()));  // a sum is rounded once when it is shown, and once when it is kept
    }
}

/// And refining begins with all triangles there.
void ScenePatchTest::hurriedOnesAreRough() {
    openLarge();
    static_cast<void>(draw());
    for (const bool isUndone : {false, true}) {
        if (isUndone) {
            m_session->undo();
        } else {
            QVERIFY(hit({1.2f, 5.7f, 1.6f}).ok());
        }
        m_view.detail.coarse = true;
        static_cast<void>(draw());
        QVERIFY(m_refined->wasPatched());
        QVERIFY(m_refined->isRough() && m_refined->hasPicture());
        QVERIFY(m_gpu->sync().ok());
        const Image rough = draw();
        QVERIFY(m_refined->isRough());
        int parts = 0;
        for (; !m_refined->isWhole() && parts < 50; ++parts) {
            QVERIFY(refineOnce().ok());
        }
        QVERIFY2(parts > 1 && parts < 20, qPrintable(QString::number(parts)));
        QCOMPARE(m_refined->samples(), 0);
        const Image whole = draw();
        QVERIFY(m_refined->wasShown());
        m_view.detail = {};
        QVERIFY(isAlike(whole, drawAgain()));
        QVERIFY(whole.pixels != rough.pixels);
    }
}

/// Another hit may come before all triangles are there, and a picture that has to have them all.
void ScenePatchTest::roughOnesArePatched() {
    openLarge();
    static_cast<void>(draw());
    m_view.detail.coarse = true;
    QVERIFY(hit({1.2f, 5.7f, 1.6f}).ok());
    QVERIFY(m_gpu->sync().ok());
    const Image rough = draw();
    for (int part = 0; part < 4; ++part) {  // shadows, and some of the picture
        QVERIFY(refineOnce().ok());
    }
    QVERIFY(m_refined->isRough() && draw().pixels == rough.pixels);
    QVERIFY(hit({-3.0f, 3.0f, 4.2f}).ok());
    QVERIFY(m_gpu->sync().ok());
    static_cast<void>(draw());
    QVERIFY(m_refined->wasPatched() && m_refined->hasPicture() && m_refined->isRough());
    m_view.detail = {};
    const Image whole = draw();
    QVERIFY(m_refined->wasPatched() && m_refined->isWhole());
    QVERIFY(isAlike(whole, drawAgain()));
}

HITSCOPE_TEST(ScenePatchTest, QCoreApplication)

}  // namespace hitscope::scene_patch_test

#include "scene_patch_test.moc"
