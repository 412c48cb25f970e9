// SPDX-License-Identifier: GPL-3.0-or-later
// What of the session's targets is in the picture: hidden ones are not, and a cover is on those it can be on.
#include <epoxy/gl.h>

#include <QTest>
#include <array>
#include <climits>
#include <cstdlib>
#include <functional>

#include "gl/render_target.h"
#include "mesh/geodesic_sphere.h"
#include "mesh/panel_texture.h"
#include "pipeline/deformation_pipeline.h"
#include "scene/reapplication.h"
#include "scene/scene_gpu.h"
#include "scene_draw_support.h"
#include "session/primitive_target.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_draw_test {

using namespace test;

namespace {

/// Pixels of a half (0: left, 1: right) that clearly differ.
int differing(const Image& a, const Image& b, int half) {
    constexpr auto kBytes = std::size_t{4} * kSmallWidth * kSmallHeight;
    if (a.pixels.size() != kBytes || b.pixels.size() != kBytes) {
        return INT_MAX / 2;  // nothing was drawn; halves are added
    }
    int count = 0;
    for (int y = 0; y < kSmallHeight; ++y) {
        for (int x = half * kSmallWidth / 2; x < (half + 1) * kSmallWidth / 2; ++x) {
            const std::size_t i = std::size_t{4} * static_cast<std::size_t>(y * kSmallWidth + x);
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
        session.loadScene({{}, twoCubes(), 0.0f});
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
        std::vector<TargetPlan> bare = twoCubes();
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
        std::vector<TargetPlan> coloured = twoCubes();
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
        session.loadScene({{}, twoCubes(), 0.0f});
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        const Image full = draw(session, *gpu.value());
        const Image half = draw(session, *gpu.value(), true, {.scale = 0.5f});
        const int differs = differing(full, half, 0) + differing(full, half, 1);
        QVERIFY2(differs > 50 && differs < kSmallWidth * kSmallHeight / 20,
                 qPrintable(QString::number(differs)));
        QVERIFY(draw(session, *gpu.value()).pixels == full.pixels);
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
        QVERIFY2(differs > 20 && differs < kSmallWidth * kSmallHeight / 10,
                 qPrintable(QString::number(differs)));
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
        if (whyUnavailable(pipeline)) {
            QSKIP("this driver has no such pipeline");
        }
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
            QVERIFY(gpu.value()->sync().ok());
            picture = draw(session, *gpu.value());
        };
        const auto isAsDrawnAnew = [&] {
            const auto other = SceneGpu::create(session);
            return other && other.value()->sync().ok() && !picture.pixels.empty() &&
                   draw(session, *other.value()).pixels == picture.pixels;
        };
        const GLuint all = primitivesOf(drawNow);
        if (all == 0) {
            QSKIP("this renderer does not count what it draws");
        }
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
    /// From the front, however little of the scene is visible.
    [[nodiscard]] SceneGpu::View viewOf(const Session& session, bool colours = true,
                                        const PictureDetail& detail = {}) const {
        SceneGpu::View view = smallView(session, m_floor);
        view.detail = detail;
        if (m_isNarrow) {
            view.camera.setFieldOfView(Camera::kNarrowest);
        }
        view.options.vertexColours = colours;
        return view;
    }
    Image draw(const Session& session, SceneGpu& gpu, bool colours = true,
               const PictureDetail& detail = {}) const {
        return drawn(gpu, viewOf(session, colours, detail));
    }

    GlFixture m_gl;
    bool m_floor = false;
    bool m_isNarrow = false;  // the picture shows little
};

HITSCOPE_TEST(SceneDrawTest, QCoreApplication)

}  // namespace hitscope::scene_draw_test

#include "scene_draw_test.moc"
