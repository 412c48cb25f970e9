// SPDX-License-Identifier: GPL-3.0-or-later
// What of the session's targets is in the picture: hidden ones are not, and a cover is on those it can be on.
#include <epoxy/gl.h>

#include <QTest>
#include <array>
#include <cstdlib>
#include <functional>

#include "gl/render_target.h"
#include "mesh/geodesic_sphere.h"
#include "mesh/panel_texture.h"
#include "scene/reapplication.h"
#include "scene/refined_view.h"
#include "scene/scene_gpu.h"
#include "session/primitive_target.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_draw_test {

namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 120;

/// Pixels of a half (0: left, 1: right) that clearly differ.
int differing(const Image& a, const Image& b, int half) {
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = half * kWidth / 2; x < (half + 1) * kWidth / 2; ++x) {
            const std::size_t i = std::size_t{4} * static_cast<std::size_t>(y * kWidth + x);
            int off = 0;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                off += std::abs(a.pixels[i + channel] - b.pixels[i + channel]);
            }
            count += off > 12 ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

class SceneDrawTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() {
        m_floor = false;
        QCOMPARE(m_gl.errors(), QStringList());
    }

    void hiddenTargetsAreNotDrawn() {
        Session session;
        session.loadScene({{}, plans(), 0.0f});
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        const Image both = draw(session, *gpu.value());
        const TargetId right = session.targets()[1]->id;
        session.targets().setVisible(std::array{right}, false);
        const Image one = draw(session, *gpu.value());
        QVERIFY(differing(both, one, 1) > 500);
        session.undo();
        QVERIFY(draw(session, *gpu.value()).pixels == both.pixels);
    }

    void coverIsOnTargetsWithTextureCoordinates() {
        Session session;
        std::vector<TargetPlan> bare = plans();
        MeshData mesh = *bare[1].shape.mesh;
        mesh.texcoords.clear();
        mesh.cornerTexcoords.clear();
        bare[1].shape = prepareMesh(std::move(mesh));
        session.loadScene({{}, std::move(bare), 0.0f});
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        const Image plain = draw(session, *gpu.value());
        session.settings().setCoverTexture(std::make_shared<const Image>(makePanelTexture(128)));
        const Image covered = draw(session, *gpu.value());
        QVERIFY(differing(plain, covered, 0) > 500);
        QCOMPARE(differing(plain, covered, 1), 0);
        session.settings().setCoverTexture(std::make_shared<const Image>(makePanelTexture(128, 5)));
        QVERIFY(differing(covered, draw(session, *gpu.value()), 0) > 500);
        session.settings().setCoverTexture(nullptr);
        QVERIFY(draw(session, *gpu.value()).pixels == plain.pixels);
    }

    void coloursStayWithOtherBuffers() {
        Session session;
        std::vector<TargetPlan> coloured = plans();
        MeshData mesh = *coloured[1].shape.mesh;
        mesh.colours.assign(mesh.positions.size(), glm::vec3(1.0f, 0.0f, 0.0f));
        coloured[1].shape = prepareMesh(std::move(mesh));
        session.loadScene({{}, std::move(coloured), 0.0f});
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        const Image shown = draw(session, *gpu.value());
        const Image plain = draw(session, *gpu.value(), false);
        QCOMPARE(differing(plain, shown, 0), 0);
        QVERIFY(differing(plain, shown, 1) > 500);
        // So many hits are applied again beside the picture, into buffers of their own.
        Hit beside;
        beside.target = session.targets()[0]->id;
        beside.point = glm::vec3(100.0f);
        beside.direction = glm::vec3(0, 0, 1);
        const std::vector<Hit> hits(Reapplication::kWorthSlicing + 1, beside);
        QVERIFY(session.hits().add(hits));
        QVERIFY(gpu.value()->sync().ok());
        session.settings().setPipeline(PipelineKind::Reference);
        static_cast<void>(draw(session, *gpu.value()));
        QVERIFY(session.tasks().current() != nullptr);
        while (session.tasks().current() != nullptr) {
            static_cast<void>(draw(session, *gpu.value()));
        }
        const Image again = draw(session, *gpu.value());
        const Image againPlain = draw(session, *gpu.value(), false);
        QCOMPARE(differing(againPlain, again, 0), 0);
        QVERIFY(differing(againPlain, again, 1) > 500);
    }

    /// Pictures that move may be drawn smaller: they fill the same place, and differ at edges alone.
    void smallerPicturesAreEnlarged() {
        Session session;
        session.loadScene({{}, plans(), 0.0f});
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        const Image full = draw(session, *gpu.value());
        const Image half = draw(session, *gpu.value(), true, {.scale = 0.5f});
        const int differs = differing(full, half, 0) + differing(full, half, 1);
        QVERIFY2(differs > 50 && differs < kWidth * kHeight / 20, qPrintable(QString::number(differs)));
        QVERIFY(draw(session, *gpu.value()).pixels == full.pixels);
    }

    /// A picture that is refined next is the same one, and is the refined picture's beginning: neither that
    /// nor the same picture again draws the targets once more.
    void theNextIsRefined() {
        Session session;
        session.loadScene({{}, plans(), 0.0f});
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        RefinedView refined;
        Image picture;
        const auto draw = [&](bool isRefinedNext) {
            SceneGpu::View view = viewOf(session);
            view.isRefinedNext = isRefinedNext;
            const gl::RenderTarget into(kWidth, kHeight);
            QVERIFY(gpu.value()->draw(view, into.framebuffer(), &refined).ok());
            picture = into.read();
        };
        const GLuint all = primitivesOf([&] { draw(false); });
        const Image plain = picture;
        QVERIFY(!refined.hasPicture());
        QVERIFY(primitivesOf([&] { draw(true); }) >= all);
        QVERIFY(refined.isPlain());
        QVERIFY(picture.pixels == plain.pixels);
        QVERIFY(primitivesOf([&] { draw(true); }) < all / 4);
        QVERIFY(picture.pixels == plain.pixels);
        const auto refine = [&] { QVERIFY(gpu.value()->refine(viewOf(session), refined).ok()); };
        QVERIFY(primitivesOf(refine) < all / 4);
        QVERIFY(!refined.isPlain());
        QCOMPARE(refined.samples(), 0);
        QVERIFY(primitivesOf(refine) >= all / 2);
        QCOMPARE(refined.samples(), 1);
        // Too few samples to be shown, and where the plain picture was there are these.
        draw(true);
        QVERIFY(picture.pixels == plain.pixels);
        QCOMPARE(refined.samples(), 1);
        Hit hit;
        hit.target = session.targets()[0]->id;
        hit.point = glm::vec3(0.0f, 0.0f, 2.0f);
        hit.direction = glm::vec3(0.0f, 0.0f, -1.0f);
        QVERIFY(session.hits().add(hit).ok());
        QVERIFY(gpu.value()->sync().ok());  // normals have come, too
        draw(true);
        QVERIFY(refined.isPlain());
        const Image dented = picture;
        QVERIFY(dented.pixels != plain.pixels);
        draw(false);
        QVERIFY(picture.pixels == dented.pixels);
    }

    /// With fewer triangles a sphere looks much the same, dents included, and afterwards all are there again,
    /// in its shadow too.
    void coarse() {
        Session session;
        std::vector<TargetPlan> large(1, planMesh(prepareMesh(makeGeodesicSphere(90, 2.0f)), TargetSource()));
        session.loadScene({{}, std::move(large), 0.0f});
        const auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        m_floor = true;  // for its shadow
        const Image round = draw(session, *gpu.value());
        Hit hit;
        hit.target = session.targets().front()->id;
        hit.direction = Camera().forward();
        hit.point = -2.0f * hit.direction;
        hit.constants = {1.0f, 0.5f, 0.7f};
        QVERIFY(session.hits().add(hit).ok());
        QVERIFY(gpu.value()->sync().ok());
        const Image coarse = draw(session, *gpu.value(), true, {.coarse = true});
        const Image full = draw(session, *gpu.value());
        const auto other = SceneGpu::create(session);
        QVERIFY(other && other.value()->sync().ok());
        QVERIFY(draw(session, *other.value()).pixels == full.pixels);
        const int differs = differing(full, coarse, 0);
        QVERIFY2(differs > 20 && differs < kWidth * kHeight / 10, qPrintable(QString::number(differs)));
        QVERIFY(3 * differs < 2 * differing(full, round, 0));  // the dent is there
        QVERIFY(!gpu.value()->wasCoarse());
        m_floor = false;
        (void)draw(session, *gpu.value(), true, {.coarse = true});
        QVERIFY(gpu.value()->wasCoarse());
    }

    /// Where little of it is in the picture, all triangles of that are drawn, on renderers that would not be
    /// held up more by looking for them.
    void coarseOfLittle() {
        if (!gl::rendererInfo().isSoftware()) {
            QSKIP("A GPU draws the coarse shape.");
        }
        Session session;
        std::vector<TargetPlan> large(1, planMesh(prepareMesh(makeGeodesicSphere(90, 2.0f)), TargetSource()));
        session.loadScene({{}, std::move(large), 0.0f});
        const auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        m_isNarrow = true;
        const Image full = draw(session, *gpu.value());
        const Image coarse = draw(session, *gpu.value(), true, {.coarse = true});
        m_isNarrow = false;
        QVERIFY(!gpu.value()->wasCoarse());
        QVERIFY(full.pixels == coarse.pixels);
    }

    /// Of a scene that is new, too: the picture then draws no shadows, and is the same.
    void shadowsAreDrawnBeforeThePicture() {
        Session session;
        session.loadScene({{}, plans(), 0.0f});
        const auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        m_floor = true;
        static_cast<void>(draw(session, *gpu.value()));
        const auto loadOther = [&session] {
            std::vector<TargetPlan> one(1, planPrimitive({PrimitiveKind::UvSphere, 32, 3.0f}));
            session.loadScene({{}, std::move(one), 0.0f});
        };
        loadOther();
        Image whole;
        const GLuint all = primitivesOf([&] { whole = draw(session, *gpu.value()); });
        loadOther();
        const auto partsOf = [&] {
            int parts = 0;
            for (bool isLeft = true; isLeft && parts < 10; ++parts) {
                const Result<bool> prepared = gpu.value()->prepare(viewOf(session));
                isLeft = prepared && !prepared.value();
            }
            return parts;
        };
        QCOMPARE(partsOf(), 4);  // the target, a framebuffer, shadows, and that nothing is left
        Image rest;
        const GLuint fewer = primitivesOf([&] { rest = draw(session, *gpu.value()); });
        QVERIFY2(fewer > 0 && fewer < all, qPrintable(QStringLiteral("%1 of %2").arg(fewer).arg(all)));
        QVERIFY(rest.pixels == whole.pixels);
        Hit hit;
        hit.target = session.targets()[0]->id;
        hit.point = {0.0f, 0.0f, 1.5f};
        hit.direction = {0.0f, 0.0f, -1.0f};
        QVERIFY(session.hits().add(hit).ok());
        QCOMPARE(partsOf(), 3);  // the hit, its shadows
        const Image dented = draw(session, *gpu.value());
        QVERIFY(dented.pixels != whole.pixels);
        for (int pictures = 0; gpu.value()->isReadBackPending() && pictures < 100; ++pictures) {
            QVERIFY(partsOf() < 10);
            static_cast<void>(draw(session, *gpu.value()));
        }
        QVERIFY(!gpu.value()->isReadBackPending());
        const auto other = SceneGpu::create(session);
        QVERIFY(other && other.value()->sync().ok());
        QVERIFY(draw(session, *gpu.value()).pixels == draw(session, *other.value()).pixels);
    }

    void shadowsFollowDents_data() {
        QTest::addColumn<PipelineKind>("pipeline");
        for (const PipelineTraits& traits : allPipelines()) {
            QTest::newRow(traits.key.data()) << traits.kind;
        }
    }
    /// Only the part of the shadow map that a dent is in is drawn anew, and the picture is that of a scene
    /// which has been drawn for the first time.
    void shadowsFollowDents() {
        QFETCH(const PipelineKind, pipeline);
        Session session;
        std::vector<TargetPlan> balls(2, planMesh(prepareMesh(makeGeodesicSphere(24, 2.0f)), TargetSource()));
        balls[1].transform.position = {5.0f, 1.0f, 0.0f};
        session.loadScene({{}, std::move(balls), 0.0f});
        session.settings().setPipeline(pipeline);
        const auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        m_floor = true;
        Image picture;
        const auto drawNow = [&] {
            picture = gpu.value()->sync().ok() ? draw(session, *gpu.value()) : Image{};
        };
        const auto isAsDrawnAnew = [&] {
            const auto other = SceneGpu::create(session);
            return other && other.value()->sync().ok() &&
                   draw(session, *other.value()).pixels == picture.pixels;
        };
        const GLuint all = primitivesOf(drawNow);
        const GLuint withoutShadows = primitivesOf(drawNow);
        QVERIFY(withoutShadows > 0 && withoutShadows < all);
        const Image before = picture;
        Hit hit;
        hit.direction = {0.0f, -1.0f, 0.0f};
        for (int i = 0; i < 6; ++i) {
            hit.target = session.targets()[static_cast<std::size_t>(i % 2)]->id;
            const float angle = 0.4f * static_cast<float>(i);
            hit.point = 2.0f * glm::vec3(std::sin(angle), std::cos(angle), 0.0f);
            QVERIFY(session.hits().add(hit).ok());
            const GLuint drawn = primitivesOf(drawNow);
            QVERIFY2(drawn > withoutShadows && 2 * (drawn - withoutShadows) < all - withoutShadows,
                     qPrintable(QStringLiteral("%1; %2 to %3").arg(drawn).arg(withoutShadows).arg(all)));
            QVERIFY(isAsDrawnAnew());
        }
        QVERIFY(picture.pixels != before.pixels);
        session.hits().setEnabled(std::vector<std::size_t>{1}, false);
        drawNow();
        QVERIFY(isAsDrawnAnew());
        session.undo();
        session.undo();
        drawNow();
        QVERIFY(isAsDrawnAnew());
        session.hits().clear();
        drawNow();
        QVERIFY(isAsDrawnAnew());
    }

private:
    /// Triangles and lines that were drawn meanwhile.
    static GLuint primitivesOf(const std::function<void()>& act) {
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_PRIMITIVES_GENERATED, query);
        act();
        glEndQuery(GL_PRIMITIVES_GENERATED);
        GLuint primitives = 0;
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &primitives);
        glDeleteQueries(1, &query);
        return primitives;
    }

    /// Two cubes side by side, far enough apart that neither shades the other.
    static std::vector<TargetPlan> plans() {
        std::vector<TargetPlan> made(2, planPrimitive({PrimitiveKind::Cube, 4, 4.0f}));
        made[0].transform.position.x = -5.0f;
        made[1].transform.position.x = 5.0f;
        return made;
    }

    /// From the front, however little of the scene is visible.
    [[nodiscard]] SceneGpu::View viewOf(const Session& session, bool colours = true,
                                        const PictureDetail& detail = {}) const {
        SceneGpu::View view;
        view.width = kWidth;
        view.height = kHeight;
        view.detail = detail;
        Bounds bounds;
        for (const auto& target : session.targets()) {
            bounds.add(target->worldBounds());
        }
        view.camera.frame(bounds, 2.0f);
        if (m_isNarrow) {
            view.camera.setFieldOfView(Camera::kNarrowest);
        }
        view.options.floor = m_floor;
        view.options.shadows = m_floor;
        view.options.vertexColours = colours;
        return view;
    }
    Image draw(const Session& session, SceneGpu& gpu, bool colours = true,
               const PictureDetail& detail = {}) const {
        const gl::RenderTarget into(kWidth, kHeight);
        const Status drawn = gpu.draw(viewOf(session, colours, detail), into.framebuffer());
        return drawn.ok() ? into.read() : Image{};
    }

    test::GlFixture m_gl;
    bool m_floor = false;
    bool m_isNarrow = false;  // the picture shows little
};

HITSCOPE_TEST(SceneDrawTest, QCoreApplication)

}  // namespace hitscope::scene_draw_test

#include "scene_draw_test.moc"
