// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on picking, and what it is good for.
#include "render/picking_trial.h"

#include <QTest>

#include "gl/picking_support.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::picking_trial_test {

using test::PickedScene;

namespace {

/// A driver that does not tell fragments their primitive, as pick.frag asks.
const gl::Defines kNoPrimitives = {{"uint(x)", "0u"}};

}  // namespace

class PickingTrialTest : public QObject, private PickedScene {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { start(); }
    void cleanup() { close(); }
    void cleanupTestCase() { m_context.reset(); }

    void thousandsOfPixelsAreCompared() {
        const PickingVerdict verdict = tryPicking();
        QCOMPARE(verdict.whyNot, std::string());
        QVERIFY2(verdict.isRight(), describe(verdict).c_str());
        QVERIFY(verdict.pixels > 15000);
    }

    void whatFragmentsAreNotToldComesFromGeometry() {
        const PickingVerdict verdict = tryPicking(kNoPrimitives);
        QVERIFY2(verdict.isRight(), describe(verdict).c_str());
        QVERIFY(verdict.byGeometry);
    }

    void whatIsWrongEitherWayIsSaid() {
        const PickingVerdict verdict = tryPicking({{"uvec2(t, e)", "uvec2(t, (e) % 4096u)"}});
        QVERIFY(!verdict.isRight());
        QVERIFY(verdict.whyNot.empty());
        QVERIFY(verdict.wrong > 100);
        QVERIFY(verdict.wrong < verdict.pixels);
    }

    void refusedProgramsAreSaid() {
        const PickingVerdict verdict = tryPicking({{"uvec2(t, e)", "nothing"}});
        QVERIFY(!verdict.isRight());
        QVERIFY(describe(verdict).starts_with("not compared: "));
    }

    // The same vertices, of surfaces, points and what a cutting plane leaves.
    void throughAGeometryShaderToo_data() {
        QTest::addColumn<bool>("wireframe");
        QTest::addColumn<bool>("cut");
        QTest::newRow("surfaces") << false << false;
        QTest::newRow("points") << true << false;
        QTest::newRow("cut") << false << true;
        QTest::newRow("points, cut") << true << true;
    }
    void throughAGeometryShaderToo() {
        QFETCH(const bool, wireframe);
        QFETCH(const bool, cut);
        if (tryPicking().byGeometry) {
            QSKIP("here nothing can be picked without one");
        }
        open(PipelineKind::UniformArrayCulled);
        SceneGpu::View view = viewOf(1.0f);
        view.options.wireframe = wireframe ? WireframeMode::Only : WireframeMode::Off;
        view.options.cut.on = cut;
        view.options.cut.fill = cut;
        int found = 0;
        for (int i = 0; i < 60; ++i) {
            const glm::vec2 at(120.5f + 7.0f * static_cast<float>(i), 200.5f + static_cast<float>(i));
            std::optional<VertexRef> picked[2];
            for (const bool byGeometry : {false, true}) {
                RendererVerdict verdict = m_session->readBack().verdict();
                verdict.picking = PickingVerdict{1, 0, byGeometry, {}};
                test::readBackOf(*m_session).setVerdict(verdict);
                const auto now = m_picker->pick(view, at);
                QVERIFY2(now.ok(), now.ok() ? "" : now.error().message().c_str());
                picked[byGeometry ? 1 : 0] = now.value();
            }
            QCOMPARE(picked[0], picked[1]);
            found += picked[0] ? 1 : 0;
        }
        QVERIFY2(found > 5, qPrintable(QString::number(found)));
    }

    void whatIsKnownToBeWrongIsNotGiven() {
        open(PipelineKind::Reference);
        const SceneGpu::View view = viewOf(1.0f);
        const glm::vec2 middle(0.5f * static_cast<float>(view.width), 0.5f * static_cast<float>(view.height));
        QVERIFY(m_picker->pick(view, middle).ok());
        QVERIFY(m_session->readBack().verdict().picking &&
                m_session->readBack().verdict().picking->isRight());
        RendererVerdict verdict = m_session->readBack().verdict();
        verdict.picking = PickingVerdict{1000, 7, false, {}};
        test::readBackOf(*m_session).setVerdict(verdict);
        const auto picked = m_picker->pick(view, middle);
        QVERIFY(!picked.ok());
        QVERIFY2(picked.error().what.find("7 of 1,000 pixels") != std::string::npos,
                 picked.error().what.c_str());
    }

    void everythingIsTriedOneAfterTheOther() {
        open(PipelineKind::Reference);
        QVERIFY(m_session->readBack().verdict().of(PipelineKind::Reference) != nullptr);
        int steps = 0;
        while (m_gpu->tryNext()) {
            QVERIFY(++steps < 10);
        }
        for (const PipelineTraits& traits : allPipelines()) {
            QVERIFY(m_session->readBack().verdict().of(traits.kind) != nullptr);
        }
        QVERIFY(m_session->readBack().verdict().picking.has_value());
        QVERIFY(!m_gpu->tryNext());
    }
};

HITSCOPE_TEST(PickingTrialTest, QCoreApplication)

}  // namespace hitscope::picking_trial_test

#include "picking_trial_test.moc"
