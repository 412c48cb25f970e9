// SPDX-License-Identifier: GPL-3.0-or-later
// Two pipelines beside each other: what the comparison says of them, and the two pictures.
#include "analysis/comparison.h"

#include <QElapsedTimer>
#include <QTest>
#include <array>

#include "analysis/comparison_text.h"
#include "analysis/hit_effects.h"
#include "gl/pipeline_rows.h"
#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "session/vertex_selection.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::comparison_test {

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
        HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        comparison.setOther(static_cast<PipelineKind>(other));
        shootAll(session, demoShots(session, 300, 7));
        QVERIFY(session.hits().history().size() > 200);
        QVERIFY(settled());
        QVERIFY(reports(comparison, session.targets()[0]->deformed.statistics().changedVertices));
        QVERIFY(comparison.report().vertices > 100);
        QCOMPARE(comparison.report().largest, 0.0);
        QCOMPARE(comparison.report().rootMeanSquare, 0.0);
        QVERIFY(comparisonText(comparison).startsWith(QStringLiteral("A and B are equal in all ")));
        session.undo();
        session.hits().remove(3);
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        session.hits().clear();
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

    void sideBySideAreTheSamePicture_data() {
        QTest::addColumn<DisplayOptions>("options");
        QTest::addColumn<bool>("selects");
        DisplayOptions options;
        QTest::newRow("plain") << options << false;
        QTest::newRow("vertices selected") << options << true;
        DisplayOptions bare;
        bare.wireframe = WireframeMode::Only;
        QTest::newRow("wireframe only") << bare << false;
        bare.wireframe = WireframeMode::Off;
        bare.transparent = true;
        QTest::newRow("transparent") << bare << false;
        options.change.on = true;
        options.change.quantity = ChangeQuantity::EdgeStretch;
        QTest::newRow("edge stretch") << options << false;
        options.change.quantity = ChangeQuantity::TrueNormalError;
        QTest::newRow("true-normal error") << options << false;
    }
    void sideBySideAreTheSamePicture() {
        QFETCH(DisplayOptions, options);
        QFETCH(bool, selects);
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        ChangeValues values(session);
        values.setQuantity(options.change.on ? std::optional(options.change.quantity) : std::nullopt);
        m_view.changeValues = &values;
        shootAll(session, demoShots(session, 20, 3));
        if (selects) {
            const Target& target = *session.targets()[0];
            QVERIFY(settled());
            const auto changed = target.deformed.onceChanged();
            session.selection().select(target.id, {changed.begin(), changed.end()},
                                       VertexSelection::Combine::Add);
        }
        m_view.options = options;
        m_view.options.sideBySide = true;
        QVERIFY(settled());
        values.finish();
        const QImage alone = picture();
        comparison.setOther(PipelineKind::UniformArray);
        QVERIFY(settled());
        QTRY_VERIFY_WITH_TIMEOUT(hasValues(comparison), kPatience);
        const QImage both = picture();
        const QImage left = both.copy(0, 0, kWidth / 2, kHeight);
        // A pixel's place in the framebuffer counts in the last bit of what is interpolated.
        QCOMPARE(test::differing(left, both.copy(kWidth / 2, 0, kWidth / 2, kHeight), 1), 0);
        QVERIFY(left != alone.copy(0, 0, kWidth / 2, kHeight));
        QCOMPARE(comparison.values() != nullptr,
                 options.change.on && options.change.quantity == ChangeQuantity::EdgeStretch);
        comparison.setOther(std::nullopt);
        QVERIFY(settled());
        QCOMPARE(picture(), alone);
    }

    /// B has the numbers of hits, too, when its buffers are made anew: for another pipeline, or again.
    void countsAreThoseOfEachB() {
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        HitEffects effects(session);
        ChangeValues values(session);
        values.setHitCounts([&effects](TargetId target) { return effects.counts(target); });
        values.setQuantity(ChangeQuantity::HitCount);
        m_view.changeValues = &values;
        m_view.options.sideBySide = true;
        m_view.options.change.on = true;
        m_view.options.change.quantity = ChangeQuantity::HitCount;
        shootAll(session, demoShots(session, 20, 3));
        QVERIFY(settled());
        effects.finish();
        values.touchAll(session.targets()[0]->id);
        values.finish();
        QVERIFY(values.summary().high > 0.0);
        const std::optional<PipelineKind> none;
        for (const auto other :
             {std::optional(PipelineKind::UniformArray), std::optional(PipelineKind::Reference), none,
              std::optional(PipelineKind::UniformArray)}) {
            comparison.setOther(other);
            QVERIFY(settled());
            const QImage both = picture();
            QVERIFY(!other || test::differing(both.copy(0, 0, kWidth / 2, kHeight),
                                              both.copy(kWidth / 2, 0, kWidth / 2, kHeight), 1) == 0);
        }
    }

    /// B's colours are those of its own shape.
    void stretchIsOfEachItsOwn() {
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        ChangeValues values(session);
        values.setQuantity(ChangeQuantity::EdgeStretch);
        m_view.changeValues = &values;
        m_view.options.sideBySide = true;
        m_view.options.change.on = true;
        m_view.options.change.quantity = ChangeQuantity::EdgeStretch;
        comparison.setOther(PipelineKind::Reference);
        QVERIFY(settled());
        const QImage alike = picture();
        const TargetId target = session.targets()[0]->id;
        std::vector<DynamicVertex> wrong(comparison.vertices(target).begin(),
                                         comparison.vertices(target).end());
        for (DynamicVertex& vertex : wrong) {
            vertex.position *= 1.5f;
        }
        comparison.take(target, 0, wrong);
        comparison.finishReadBack();
        QVERIFY(comparison.values() != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(hasValues(comparison), kPatience);
        QVERIFY(std::abs(comparison.values()->summary().high - 50.0) < 0.1);
        QCOMPARE(values.summary().count, std::size_t{0});
        const QImage apart = picture();
        QCOMPARE(apart.copy(0, 0, kWidth / 2, kHeight), alike.copy(0, 0, kWidth / 2, kHeight));
        QVERIFY(apart.copy(kWidth / 2, 0, kWidth / 2, kHeight) !=
                alike.copy(kWidth / 2, 0, kWidth / 2, kHeight));
        m_view.options.sideBySide = false;
        QVERIFY(settled());
        QVERIFY(comparison.values() == nullptr);
    }

    /// An array of uniforms that has dropped its first hits, beside a pipeline that keeps all.
    void looksAsItDid() {
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        shootAll(session, demoShots(session, 660, 7));
        QVERIFY(session.hits().history().size() > 620);
        ChangeValues values(session);
        values.setOtherVertices([&](TargetId target) { return comparison.vertices(target); });
        m_view.changeValues = &values;
        m_view.options.sideBySide = true;
        comparison.setOther(PipelineKind::UniformArray);
        QString plain;
        const auto hasDropped = [&] {
            plain = settled() ? comparisonText(comparison) : QString();
            return plain.contains(QStringLiteral("; B has dropped "));
        };
        QTRY_VERIFY2_WITH_TIMEOUT(hasDropped(), qPrintable(plain), kPatience);
        QVERIFY2(!plain.contains(QStringLiteral("; A has")), qPrintable(plain));
        comparison.setShownQuantity(ChangeQuantity::HitCount);
        QVERIFY(comparisonText(comparison).endsWith(QStringLiteral("; the colours count the hits of A")));
        comparison.setShownQuantity(std::nullopt);
        QCOMPARE(comparisonText(comparison), plain);
        HITSCOPE_NEEDS_SAMPLES();
        const QString apart = test::differenceFromBaseline(picture(), QStringLiteral("side-by-side"));
        QVERIFY2(apart.isEmpty(), qPrintable(apart));
        m_view.options.sideBySide = false;
        m_view.options.change.on = true;
        m_view.options.change.quantity = ChangeQuantity::Difference;
        m_view.camera.frame(session.targets().bounds(), 1.0f * kWidth / kHeight);
        values.setQuantity(ChangeQuantity::Difference);
        values.finish();
        QVERIFY(values.summary().high > 0.01);
        const QString map = test::differenceFromBaseline(picture(), QStringLiteral("difference"));
        QVERIFY2(map.isEmpty(), qPrintable(map));
        // And as a selection in its place.
        m_view.options.change.on = false;
        m_view.changeValues = nullptr;
        comparison.setOther(std::nullopt);
        const Target& target = *session.targets()[0];
        const std::span<const std::uint32_t> changed = target.deformed.onceChanged();
        session.selection().select(target.id, {changed.begin(), changed.begin() + 200},
                                   VertexSelection::Combine::Add);
        session.selection().setPicked(VertexRef{target.id, changed[0]});
        const QString dots = test::differenceFromBaseline(picture(), QStringLiteral("selection"));
        QVERIFY2(dots.isEmpty(), qPrintable(dots));
    }

    void followsTargetsThatComeAndGo() {
        Session session;
        Comparison comparison(session);
        open(session, comparison);
        HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        comparison.setOther(PipelineKind::UniformArrayCulled);
        shootAll(session, demoShots(session, 20, 3));
        QVERIFY(settled());
        const TargetId first = session.targets()[0]->id;
        session.targets().duplicate(std::array{first});
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        session.targets().remove(std::array{first});
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        loadMesh(session, makeLowPolyCube());
        shootAll(session, demoShots(session, 10, 3));
        QVERIFY(settled());
        QCOMPARE(comparison.report().largest, 0.0);
        QCOMPARE(comparison.report().vertices, session.targets()[0]->deformed.statistics().changedVertices);
    }

private:
    void open(Session& session, Comparison& comparison) {
        loadMesh(session, makeHighPolySphere());
        auto made = SceneGpu::create(session);
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
        m_scene = std::move(made).value();
        m_view = {};
        m_view.width = kWidth;
        m_view.height = kHeight;
        m_view.comparison = &comparison;
        m_view.camera.frame(session.targets().bounds(), 0.5f * kWidth / kHeight);
    }

    QImage picture() {
        const gl::RenderTarget target(kWidth, kHeight);
        if (!m_scene->draw(m_view, target.framebuffer())) {
            QTest::qFail("nothing is drawn", __FILE__, __LINE__);
            return {};
        }
        const Image image = target.read();
        return QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
    }

    static bool hasValues(const Comparison& comparison) {
        const ChangeValues* values = comparison.values();
        return values == nullptr || values->isComplete();
    }

    /// The report follows in slices of the event loop's time.
    bool reports(const Comparison& comparison, std::size_t vertices) {
        QElapsedTimer waited;
        waited.start();
        while (comparison.report().vertices != vertices && waited.elapsed() < kPatience) {
            QTest::qWait(5);
            if (picture().isNull()) {
                return false;
            }
        }
        return comparison.report().vertices == vertices;
    }

    /// Draws until everything has come back.
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

}  // namespace hitscope::comparison_test

#include "comparison_test.moc"
