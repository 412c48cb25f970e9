// SPDX-License-Identifier: GPL-3.0-or-later
// What comes before a picture, in parts, and what a picture leaves to the refined one after it.
#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/refined_view.h"
#include "scene/scene_gpu.h"
#include "scene_draw_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_prepare_test {

using namespace test;

class ScenePrepareTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void init() {
        m_session = std::make_unique<Session>();
        m_session->loadScene({{}, twoCubes(), 0.0f});
        auto created = SceneGpu::create(*m_session);
        QVERIFY(created);
        m_gpu = std::move(created).value();
        static_cast<void>(draw());  // makes the pipeline
    }
    void cleanup() {
        m_wireframe = WireframeMode::Off;
        m_normals = NormalMode::True;
        m_gpu.reset();
        m_session.reset();
        QCOMPARE(m_gl.errors(), QStringList());
    }
    void shadowsAreDrawnBeforeThePicture();
    void hitsAreAppliedBeforeThePicture();
    void whatComesBetweenIsDrawnToo();
    void shadowsFollowTriangles();
    void programsAreBuiltBeforeThePicture();
    void theNextIsRefined();

private:
    [[nodiscard]] SceneGpu::View view() const {
        SceneGpu::View view = smallView(*m_session, true);
        view.options.vertexColours = true;
        view.options.wireframe = m_wireframe;
        view.options.normals = m_normals;
        return view;
    }
    [[nodiscard]] Image draw() { return drawn(*m_gpu, view()); }
    /// Calls until nothing is left, and one to know.
    [[nodiscard]] int prepare() {
        constexpr int kMost = 20;
        int calls = 0;
        for (bool isLeft = true; isLeft && calls < kMost; ++calls) {
            const Result<bool> prepared = m_gpu->prepare(view());
            isLeft = prepared && !prepared.value();
        }
        return calls;
    }
    void loadSphere() {
        std::vector<TargetPlan> one(1, planPrimitive({PrimitiveKind::UvSphere, 32, 3.0f}));
        m_session->loadScene({{}, std::move(one), 0.0f});
    }
    [[nodiscard]] Status hitFront(float z) {
        Hit hit;
        hit.target = m_session->targets()[0]->id;
        hit.point = {0.0f, 0.0f, z};
        hit.direction = {0.0f, 0.0f, -1.0f};
        return m_session->hits().add(hit);
    }
    /// Without parts.
    [[nodiscard]] Image drawnByAnother() {
        const auto other = SceneGpu::create(*m_session);
        return other && other.value()->sync() ? drawn(*other.value(), view()) : Image{};
    }

    GlFixture m_gl;
    WireframeMode m_wireframe = WireframeMode::Off;
    NormalMode m_normals = NormalMode::True;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;
};

/// Of a scene that is new, too: the picture then draws no shadows, and is the same.
void ScenePrepareTest::shadowsAreDrawnBeforeThePicture() {
    loadSphere();
    Image whole;
    const GLuint all = primitivesOf([&] { whole = draw(); });
    if (all == 0) {
        QSKIP("this renderer does not count what it draws");
    }
    loadSphere();
    QVERIFY(prepare() >= 4);  // the target, a framebuffer, programs, shadows
    Image rest;
    const GLuint fewer = primitivesOf([&] { rest = draw(); });
    QVERIFY2(fewer > 0 && fewer < all, qPrintable(QStringLiteral("%1 of %2").arg(fewer).arg(all)));
    QVERIFY(rest.pixels == whole.pixels);
}

void ScenePrepareTest::hitsAreAppliedBeforeThePicture() {
    loadSphere();
    static_cast<void>(prepare());
    const Image whole = draw();
    QVERIFY(hitFront(1.5f));
    QCOMPARE(prepare(), 3);  // the hit, its shadows
    QVERIFY(draw().pixels != whole.pixels);
    for (int pictures = 0; m_gpu->isReadBackPending() && pictures < 100; ++pictures) {
        QVERIFY(prepare() < 10);
        static_cast<void>(draw());
    }
    QVERIFY(!m_gpu->isReadBackPending());
    QVERIFY(draw().pixels == drawnByAnother().pixels);
}

/// Between two parts, events may change anything.
void ScenePrepareTest::whatComesBetweenIsDrawnToo() {
    m_normals = NormalMode::Paper;  // the picture need not wait for others
    loadSphere();
    static_cast<void>(prepare());
    const Image whole = draw();
    QVERIFY(hitFront(1.5f));
    QVERIFY(m_gpu->prepare(view()));
    QVERIFY(hitFront(1.2f));
    const Image both = draw();
    QVERIFY(both.pixels != whole.pixels);
    QVERIFY(m_gpu->sync().ok());
    QVERIFY(draw().pixels == both.pixels);
    QVERIFY(drawnByAnother().pixels == both.pixels);
}

/// Which may reach far beyond their vertex that a hit moves.
void ScenePrepareTest::shadowsFollowTriangles() {
    std::vector<TargetPlan> one(1, planPrimitive({PrimitiveKind::UvSphere, 6, 3.0f}));
    m_session->loadScene({{}, std::move(one), 0.0f});
    const Image whole = draw();
    const std::span<const glm::vec3> places = m_session->targets()[0]->deformed.positions();
    Hit hit;
    hit.target = m_session->targets()[0]->id;
    hit.constants = {.maxDistance = 0.1f, .power = 1.0f, .maxMagnitude = 0.6f};
    for (const glm::vec3& side :
         {glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(0.0f, 0.0f, 1.0f)}) {
        hit.point =
            *std::max_element(places.begin(), places.end(), [&side](const glm::vec3& a, const glm::vec3& b) {
                return glm::dot(a, side) < glm::dot(b, side);
            });
        hit.direction = side;
        QVERIFY(m_session->hits().add(hit).ok());
        QVERIFY(m_gpu->sync().ok());
        QVERIFY(draw().pixels == drawnByAnother().pixels);
        m_session->undo();
        QVERIFY(m_gpu->sync().ok());
        QVERIFY(draw().pixels == whole.pixels);
        m_session->redo();
        QVERIFY(m_gpu->sync().ok());
        QVERIFY(draw().pixels == drawnByAnother().pixels);
        m_session->undo();
        QVERIFY(m_gpu->sync().ok());
    }
}

/// Each in a part of its own, and none is left for the picture.
void ScenePrepareTest::programsAreBuiltBeforeThePicture() {
    QVERIFY(prepare() > 1);
    QCOMPARE(prepare(), 1);
    std::vector<TargetPlan> coloured = twoCubes();
    MeshData mesh = *coloured[0].shape.mesh;
    mesh.colours.assign(mesh.positions.size(), glm::vec3(1.0f, 0.0f, 0.0f));
    coloured[0].shape = prepareMesh(std::move(mesh));
    m_session->loadScene({{}, twoCubes(), 0.0f});
    const int known = prepare();
    m_session->loadScene({{}, std::move(coloured), 0.0f});
    m_wireframe = WireframeMode::Over;
    const int fresh = prepare();
    QVERIFY2(fresh > known && fresh < 20, qPrintable(QStringLiteral("%1, %2").arg(known).arg(fresh)));
    QCOMPARE(prepare(), 1);
    QVERIFY(draw().pixels == drawnByAnother().pixels);
}

/// A picture that is refined next is the same one, and is the refined picture's beginning: neither that nor
/// the same picture again draws the targets once more.
void ScenePrepareTest::theNextIsRefined() {
    RefinedView refined;
    Image picture;
    const auto draw = [&](bool isAtRest) {
        SceneGpu::View shown = view();
        shown.options.floor = false;
        shown.options.shadows = false;
        shown.isAtRest = isAtRest;
        picture = drawn(*m_gpu, shown, &refined);
    };
    const auto refine = [&] {
        SceneGpu::View shown = view();
        shown.options.floor = false;
        shown.options.shadows = false;
        QVERIFY(m_gpu->refine(shown, refined).ok());
    };
    const GLuint all = primitivesOf([&] { draw(false); });
    if (all == 0) {
        QSKIP("this renderer does not count what it draws");
    }
    const Image plain = picture;
    QVERIFY(!refined.hasPicture());
    QVERIFY(primitivesOf([&] { draw(true); }) >= all);
    QVERIFY(refined.isPlain());
    QVERIFY(picture.pixels == plain.pixels);
    QVERIFY(primitivesOf([&] { draw(true); }) < all / 4);
    QVERIFY(picture.pixels == plain.pixels);
    QVERIFY(primitivesOf(refine) < all / 4);
    QVERIFY(!refined.isPlain());
    QCOMPARE(refined.samples(), 0);
    QVERIFY(primitivesOf(refine) >= all / 2);
    QCOMPARE(refined.samples(), 1);
    // Too few samples to be shown: the plain picture stays.
    QVERIFY(primitivesOf([&] { draw(true); }) < all / 4);
    QVERIFY(picture.pixels == plain.pixels);
    QVERIFY(!refined.wasShown());
    QCOMPARE(refined.samples(), 1);
    QVERIFY(hitFront(2.0f));
    QVERIFY(m_gpu->sync().ok());  // normals have come, too
    draw(true);
    QVERIFY(refined.isPlain());
    const Image dented = picture;
    QVERIFY(dented.pixels != plain.pixels);
    draw(false);
    QVERIFY(picture.pixels == dented.pixels);
}

HITSCOPE_TEST(ScenePrepareTest, QCoreApplication)

}  // namespace hitscope::scene_prepare_test

#include "scene_prepare_test.moc"
