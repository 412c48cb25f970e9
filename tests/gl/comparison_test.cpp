// SPDX-License-Identifier: GPL-3.0-or-later
// Two pipelines beside each other: what the comparison says of them, and the two pictures.
#include "session/comparison.h"

#include <QElapsedTimer>
#include <QtTest>
#include <array>

#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "session/comparison_text.h"
#include "session/demo_shots.h"
#include "session/scene_gpu.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

using namespace hitscope;

namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 90;

}  // namespace

class ComparisonTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() {
        m_scene.reset();
        QCOMPARE(m_gl.errors(), QStringList());
    }

    void pipelinesAgreeAfter300Hits_data() {
        QTest::addColumn<int>("other");
        QTest::addRow("uniform array") << static_cast<int>(PipelineKind::UniformArray);
        QTest::addRow("reference") << static_cast<int>(PipelineKind::Reference);
    }
    void pipelinesAgreeAfter300Hits() {
        QFETCH(int, other);
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        comparison.setOther(static_cast<PipelineKind>(other));
        shootAll(session, demoShots(session, 300, 7));
        QVERIFY(session.history().size() > 200);
        QVERIFY(settled());
        QVERIFY(reports(comparison, session.targets()[0]->deformed.statistics().changedVertices));
        QVERIFY(comparison.report().vertices > 100);
        QCOMPARE(comparison.report().largest, 0.0);
        QCOMPARE(comparison.report().rootMeanSquare, 0.0);
        QVERIFY(comparisonText(comparison).contains(QStringLiteral("largest difference 0 m, RMS 0 m")));
        session.undo();
        session.removeHit(3);
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        session.clearHits();
        QVERIFY(settled());
        QVERIFY(reports(comparison, 0));
    }

    /// What B has is made to differ, as a faulty pipeline's would.
    void differencesAreMeasured() {
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        comparison.setOther(PipelineKind::Reference);
        QVERIFY(settled());
        std::vector<DynamicVertex> wrong(comparison.vertices(session.targets()[0]->id).begin(),
                                         comparison.vertices(session.targets()[0]->id).end());
        wrong.resize(2);
        wrong[0].position.x += 0.25f;
        wrong[1].position.y -= 0.5f;
        comparison.take(session.targets()[0]->id, 0, wrong);
        comparison.finishReadBack();
        comparison.settle(0);
        QCOMPARE(comparison.report().vertices, std::size_t{2});
        QVERIFY(std::abs(comparison.report().largest - 0.5) < 1e-6);
        QVERIFY(std::abs(comparison.report().rootMeanSquare - std::sqrt((0.0625 + 0.25) / 2)) < 1e-6);
    }

    void sideBySideAreTheSamePicture() {
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        shootAll(session, demoShots(session, 20, 3));
        m_view.options.sideBySide = true;
        const QImage alone = picture();
        comparison.setOther(PipelineKind::UniformArray);
        QVERIFY(settled());
        const QImage both = picture();
        const QImage left = both.copy(0, 0, kWidth / 2, kHeight);
        QCOMPARE(left, both.copy(kWidth / 2, 0, kWidth / 2, kHeight));
        QVERIFY(left != alone.copy(0, 0, kWidth / 2, kHeight));
        comparison.setOther(std::nullopt);
        QVERIFY(settled());
        QCOMPARE(picture(), alone);
    }

    void followsTargetsThatComeAndGo() {
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        comparison.setOther(PipelineKind::UniformArrayCulled);
        shootAll(session, demoShots(session, 20, 3));
        QVERIFY(settled());
        const TargetId first = session.targets()[0]->id;
        session.duplicateTargets(std::array{first});
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        session.removeTargets(std::array{first});
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        session.loadMesh(makeLowPolyCube());
        shootAll(session, demoShots(session, 10, 3));
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        QCOMPARE(comparison.report().vertices, session.targets()[0]->deformed.statistics().changedVertices);
    }

private:
    void open(Session& session, Comparison& comparison) {
        session.loadMesh(makeHighPolySphere());
        auto made = SceneGpu::create(session);
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
        m_scene = std::move(made).value();
        m_view = {};
        m_view.width = kWidth;
        m_view.height = kHeight;
        m_view.comparison = &comparison;
        m_view.camera.frame(session.sceneBounds(), 0.5f * kWidth / kHeight);
    }

    QImage picture() {
        const gl::RenderTarget target(kWidth, kHeight);
        if (!m_scene->draw(m_view, target.framebuffer())) {
            return {};
        }
        const Image image = target.read();
        return QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
    }

    /// Draws until everything has come back.
    /// The report follows in slices of the event loop's time.
    bool reports(const Comparison& comparison, std::size_t vertices) {
        QElapsedTimer waited;
        waited.start();
        while (comparison.report().vertices != vertices && waited.elapsed() < 30'000) {
            QTest::qWait(5);
            if (picture().isNull()) {
                return false;
            }
        }
        return comparison.report().vertices == vertices;
    }

    bool settled() {
        for (int frame = 0; frame < 200; ++frame) {
            if (picture().isNull()) {
                return false;
            }
            if (!m_scene->isReadBackPending() && frame > 1) {
                return true;
            }
        }
        return false;
    }

    test::GlFixture m_gl;
    std::unique_ptr<SceneGpu> m_scene;
    SceneGpu::View m_view;
};

HITSCOPE_TEST(ComparisonTest, QCoreApplication)
#include "comparison_test.moc"
