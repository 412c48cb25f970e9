// SPDX-License-Identifier: GPL-3.0-or-later
// The same shots at the same steps make the same hits, however frames fall between the steps and whatever
// pipeline draws: colliders follow the history, not what comes back from the GPU.
#include <QTest>
#include <cstring>
#include <random>

#include "deform/hit_history.h"
#include "gl/render_target.h"
#include "pipeline/deformation_pipeline.h"
#include "scene/scene_gpu.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::determinism_test {

namespace {

constexpr int kShots = 500;
constexpr int kFewShots = 100;
constexpr int kStepsBetween = 3;  // 80 shots a second: fresher dents than read-backs are
constexpr int kLanding = 120;     // steps
constexpr int kSlicesAFrame = 8;

/// How many steps the next frame takes.
using FrameLength = std::function<int(std::mt19937&)>;

class Run {
public:
    explicit Run(PipelineKind pipeline = PipelineKind::TransformFeedback) : m_target(32, 24, 1) {
        loadTeapot(m_session);
        m_session.settings().setPipeline(pipeline);
        ProjectileSettings settings = m_session.settings().projectile();
        settings.lifetime = 0.5f;
        settings.bouncesCount = true;
        m_session.settings().setProjectile(settings);
        auto gpu = SceneGpu::create(m_session);
        if (gpu) {
            m_gpu = std::move(gpu).value();
        }
        m_view.width = 32;
        m_view.height = 24;
        m_view.options.floor = false;
        // Past the target: hits are applied and read back, and nothing of it needs to be drawn.
        m_view.camera.setPivot(glm::vec3(0.0f, 0.0f, -1000.0f), 0.0f, 0.0f, 1.0f);
    }

    void shootAll(const FrameLength& frame, std::uint32_t seed, int count = kShots) {
        std::mt19937 frames(seed);
        std::mt19937 random(7);
        int shots = 0;
        int stepsInFrame = 0;
        for (int step = 0; step < count * kStepsBetween + kLanding; ++step) {
            if (shots < count && step % kStepsBetween == 0) {
                m_session.simulation().shoot(aim(random));
                ++shots;
            }
            m_session.simulation().stepOnce();
            if (m_scrubs && step % 5 == 0) {
                m_session.hits().show(m_session.hits().history().size() / 2);
            }
            if (--stepsInFrame <= 0) {
                stepsInFrame = frame(frames);
                m_failed = m_failed || !m_gpu->draw(m_view, m_target.framebuffer());
            }
        }
        m_failed = m_failed || !m_gpu->sync();
    }

    /// Shows the first half of the hits now and then.
    void scrubsWhileShooting(bool on) { m_scrubs = on; }

    /// 60 instant shots that are all due at once while others fly, `most` of them a frame at most.
    void shootAtOnce(int most) {
        std::mt19937 random(11);
        std::vector<ScheduledShot> shots;
        for (int i = 0; i < 90; ++i) {
            const bool isInstant = i % 3 != 0;
            shots.push_back(
                {isInstant ? 0.1 : i * 0.002, aim(random), m_session.settings().projectile(), isInstant});
        }
        m_session.simulation().schedule(shots);
        for (int slice = 0; m_session.simulation().isMoving(); ++slice) {
            int fired = 0;
            m_session.simulation().advance(4.0 / 240.0, [&fired, most] { return ++fired >= most; });
            if (slice % kSlicesAFrame == 0) {
                m_failed = m_failed || !m_gpu->draw(m_view, m_target.framebuffer());
            }
        }
        m_failed = m_failed || !m_gpu->sync();
    }

    [[nodiscard]] std::vector<DynamicVertex> vertices() const {
        const std::span<const DynamicVertex> all = m_session.targets().front()->deformed.vertices();
        return {all.begin(), all.end()};
    }
    [[nodiscard]] bool failed() const { return m_failed || !m_gpu; }
    [[nodiscard]] std::vector<Hit> hits() const {
        const std::span<const Hit> hits = m_session.hits().history().hits();
        return {hits.begin(), hits.end()};
    }

private:
    [[nodiscard]] Ray aim(std::mt19937& random) const {
        const Bounds bounds = m_session.targets().bounds();
        const glm::vec3 centre = 0.5f * (bounds.min + bounds.max);
        std::uniform_real_distribution<float> off(-0.25f, 0.25f);
        Ray ray;
        ray.origin = centre + glm::vec3(0.3f, 0.4f, 1.5f) * bounds.diagonal();
        ray.direction = glm::normalize(
            centre + glm::vec3(off(random), off(random), off(random)) * bounds.diagonal() - ray.origin);
        return ray;
    }

    Session m_session;
    gl::RenderTarget m_target;
    std::unique_ptr<SceneGpu> m_gpu;
    SceneGpu::View m_view;
    bool m_failed = false;
    bool m_scrubs = false;
};

}  // namespace

class DeterminismTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void theSameShotsMakeTheSameHitsHoweverFramesFall() {
        const std::array<FrameLength, 3> frames{
            [](std::mt19937&) { return 3; },
            [](std::mt19937&) { return 8; },
            [](std::mt19937& random) { return 1 + static_cast<int>(random() % 40); },
        };
        std::vector<std::vector<Hit>> histories;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            Run run;
            run.shootAll(frames[i], static_cast<std::uint32_t>(i));
            QVERIFY(!run.failed());
            histories.push_back(run.hits());
        }
        QVERIFY2(histories[0].size() > kShots / 2, qPrintable(QString::number(histories[0].size())));
        QCOMPARE(histories[1].size(), histories[0].size());
        QCOMPARE(histories[2].size(), histories[0].size());
        for (std::size_t i = 0; i < histories[0].size(); ++i) {
            QVERIFY2(histories[1][i] == histories[0][i], qPrintable(QString::number(i)));
            QVERIFY2(histories[2][i] == histories[0][i], qPrintable(QString::number(i)));
        }
    }

    void everyPipelineGetsTheSameHits() {
        const FrameLength frame = [](std::mt19937&) { return 8; };
        std::vector<Hit> expected;
        for (const PipelineTraits& pipeline : allPipelines()) {
            if (whyUnavailable(pipeline.kind)) {
                continue;
            }
            Run run(pipeline.kind);
            run.scrubsWhileShooting(pipeline.kind == PipelineKind::Reference);
            run.shootAll(frame, 3, kFewShots);
            QVERIFY(!run.failed());
            std::vector<Hit> hits = run.hits();
            for (Hit& hit : hits) {
                hit.pipeline = 0;  // who drew it is noted
            }
            expected = expected.empty() ? hits : expected;
            QVERIFY2(hits == expected, pipeline.name.data());
        }
        QVERIFY(expected.size() > kFewShots / 2);
    }

    void shotsFiredInSlicesMakeTheSameHits() {
        Run whole;
        whole.shootAtOnce(1000);
        QVERIFY(!whole.failed());
        QVERIFY(whole.hits().size() > 40);
        for (const int most : {1, 7}) {
            Run sliced;
            sliced.shootAtOnce(most);
            QVERIFY(!sliced.failed());
            QVERIFY(sliced.hits() == whole.hits());
            const std::vector<DynamicVertex> a = sliced.vertices();
            const std::vector<DynamicVertex> b = whole.vertices();
            QCOMPARE(a.size(), b.size());
            QVERIFY(std::memcmp(a.data(), b.data(), a.size() * sizeof(DynamicVertex)) == 0);
        }
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(DeterminismTest, QCoreApplication)

}  // namespace hitscope::determinism_test

#include "determinism_test.moc"
