// SPDX-License-Identifier: GPL-3.0-or-later
// The frame rate panel, on frames that are made up, driven by the mouse.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "gl/context.h"
#include "models/frame_rate_text.h"
#include "panels/frame_rate/cost_view.h"
#include "panels/frame_rate/frame_rate_panel.h"
#include "panels/icons/themed_icon.h"
#include "pipeline/deformation_pipeline.h"
#include "scene/measure_costs.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::frame_rate_test {

namespace {

/// Of two that were asked for: none of a pipeline that this renderer cannot run.
std::size_t pointsOf(PipelineKind pipeline) {
    const auto context = gl::OffscreenContext::create();
    return context && !whyUnavailable(pipeline) ? 2 : 0;
}

void addFrame(Session& session, double seconds, std::uint32_t hits = 0) {
    FrameCost cost;
    cost.drawing = 0.25 * seconds;
    cost.deformation = 0.125 * seconds;
    cost.hits = hits;
    session.frameCosts().addGpuTimes(session.frameCosts().nextFrame() - 1, 0.5 * seconds, 0.25 * seconds);
    session.frameCosts().addFrame(cost);
    session.frameCosts().endFrame(seconds);
}

}  // namespace

class FrameRateTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup();
    void readsOut();
    void pausesAndGoesOn();
    void wheelZooms();
    void dragGoesBack();
    void pointingReadsAFrame();
    void curvesAreSwitchedAndRemembered();
    void narrowDocksWrap();
    void plotsFollowThePalette();
    void savesCsv();
    void collectsCosts();
    void twoPipelinesAreNotMixedWithOne();
    void saysWhatFrameTimesAllow();
    void framesAloneWaitForTheGpu();
    void saysThatTheGpuIsNotMeasured();
    void measuresOnRequest();
    void measuresAgainstTheNumberOfVertices();

private:
    template <class Widget>
    Widget* child(const char* name) {
        return m_panel->findChild<Widget*>(QLatin1String(name));
    }
    QWidget* plot() { return child<QWidget>("framesPage")->findChild<QWidget*>(QStringLiteral("plot")); }

    std::unique_ptr<Session> m_session;
    QAction m_continuous{themedIcon(QStringLiteral("continuous")), QStringLiteral("Draw continuously")};
    std::unique_ptr<FrameRatePanel> m_panel;
};

void FrameRateTest::init() {
    m_session = std::make_unique<Session>();
    m_session->frameCosts().setMeasuresGpu(true);
    m_panel = std::make_unique<FrameRatePanel>(*m_session, m_continuous, costMeter());
    m_panel->resize(480, 260);
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get(), kPatience));
}

void FrameRateTest::cleanup() {
    m_panel.reset();
    m_session.reset();
}

void FrameRateTest::readsOut() {
    for (int i = 0; i < 199; ++i) {
        addFrame(*m_session, 0.02);
    }
    addFrame(*m_session, 0.08);
    QTRY_COMPARE_WITH_TIMEOUT(child<QLabel>("worst")->text(), QStringLiteral("80.0 ms"), kPatience);
    QCOMPARE(child<QLabel>("median")->text(), QStringLiteral("20.0 ms"));
    QCOMPARE(child<QLabel>("mean")->text(), QStringLiteral("20.3 ms"));
    QCOMPARE(child<QLabel>("percentile99")->text(), QStringLiteral("20.0 ms"));
    QCOMPARE(child<QLabel>("low")->text(), QStringLiteral("20.0"));  // 2 frames in 0.1 s
    child<QToolButton>("clear")->click();
    QCOMPARE(child<QLabel>("mean")->text(), QStringLiteral("–"));
    QVERIFY(m_panel->graph().frames().empty());
    addFrame(*m_session, 0.01);
    QCOMPARE(m_panel->graph().frames().size(), std::size_t{1});
}

void FrameRateTest::pausesAndGoesOn() {
    addFrame(*m_session, 0.02);
    auto* pause = child<QToolButton>("pause");
    QTest::mouseClick(pause, Qt::LeftButton);
    QVERIFY(m_panel->graph().isPaused());
    addFrame(*m_session, 0.03);
    QCOMPARE(m_panel->graph().frames().size(), std::size_t{1});
    QTest::mouseClick(pause, Qt::LeftButton);
    QVERIFY(!m_panel->graph().isPaused());
    QCOMPARE(m_panel->graph().frames().size(), std::size_t{2});
}

void FrameRateTest::wheelZooms() {
    const double before = m_panel->graph().seconds();
    const QPointF middle = QRectF(plot()->rect()).center();
    QWheelEvent wheel(middle, plot()->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(plot(), &wheel);
    QCOMPARE(m_panel->graph().seconds(), before / 1.25);
    QTest::keyClick(plot(), Qt::Key_Minus);
    QCOMPARE(m_panel->graph().seconds(), before);
    for (int i = 0; i < 100; ++i) {
        QTest::keyClick(plot(), Qt::Key_Plus);
    }
    QVERIFY(m_panel->graph().seconds() > 0.0);
    QTest::mouseDClick(plot(), Qt::LeftButton, {}, middle.toPoint());
    QCOMPARE(m_panel->graph().seconds(), before);
}

void FrameRateTest::dragGoesBack() {
    addFrame(*m_session, 0.02);
    const QPoint middle = plot()->rect().center();
    QTest::mousePress(plot(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(plot(), middle + QPoint(40, 0));
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->graph().isPaused(), kPatience);
    QVERIFY(child<QToolButton>("pause")->isChecked());
    QTest::mouseRelease(plot(), Qt::LeftButton, {}, middle + QPoint(40, 0));
    QTest::keyClick(plot(), Qt::Key_Home);
    QVERIFY(!m_panel->graph().isPaused());
}

void FrameRateTest::pointingReadsAFrame() {
    addFrame(*m_session, 0.02);
    QTest::qWait(600);
    addFrame(*m_session, 0.04, 3);
    m_panel->graph().setPaused(true);
    QTest::mouseMove(plot(), QPoint(plot()->width() - 12, plot()->height() / 2));
    QTRY_VERIFY_WITH_TIMEOUT(m_panel->graph().hovered().has_value(), kPatience);
    const FrameCost read = *m_panel->graph().hovered();
    QCOMPARE(read.total, 0.04);
    const QString words = m_panel->graph().describe(read);
    QVERIFY2(words.contains(QStringLiteral("40.00 ms")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("CPU 15.00 ms, GPU –")), qPrintable(words));
    QVERIFY2(words.contains(QStringLiteral("Hits that arrived: 3")), qPrintable(words));
    QTest::mouseMove(m_panel.get(), QPoint(2, 2));
    QTRY_VERIFY_WITH_TIMEOUT(!m_panel->graph().hovered(), kPatience);
}

void FrameRateTest::curvesAreSwitchedAndRemembered() {
    QTest::mouseClick(child<QToolButton>("curve2"), Qt::LeftButton);
    QVERIFY(!child<QToolButton>("curve2")->isChecked());
    child<QComboBox>("quantity")->setCurrentIndex(1);
    QVERIFY(!child<QToolButton>("curve1")->isEnabled());
    const QByteArray state = m_panel->saveState();
    FrameRatePanel other(*m_session, m_continuous, costMeter());
    QVERIFY(other.saveState() != state);
    other.restoreState(QByteArray("nonsense, and too long"));
    other.restoreState(state);
    QCOMPARE(other.saveState(), state);
    // Another pipeline, another colour.
    addFrame(*m_session, 0.02);
    const QColor before = m_panel->graph().colour(FrameGraph::Frame);
    m_session->settings().setPipeline(PipelineKind::UniformArray);
    addFrame(*m_session, 0.02);
    QVERIFY(m_panel->graph().colour(FrameGraph::Frame) != before);
}

void FrameRateTest::narrowDocksWrap() {
    QVERIFY2(m_panel->minimumSizeHint().width() <= 260,
             qPrintable(QStringLiteral("%1: %2 %3 %4")
                            .arg(m_panel->minimumSizeHint().width())
                            .arg(child<QTabWidget>("tabs")->cornerWidget()->minimumSizeHint().width())
                            .arg(child<QWidget>("framesPage")->minimumSizeHint().width())
                            .arg(m_panel->costs().minimumSizeHint().width())));
    m_panel->resize(260, 400);
    for (int i = 0; i < FrameGraph::CurveCount; ++i) {
        const auto* curve = m_panel->findChild<QToolButton*>(QStringLiteral("curve%1").arg(i));
        QTRY_VERIFY_WITH_TIMEOUT(curve->geometry().right() < 260, kPatience);
        QVERIFY(curve->width() >
                curve->fontMetrics().horizontalAdvance(curve->text()) + curve->iconSize().width());
    }
}

void FrameRateTest::plotsFollowThePalette() {
    const QPalette before = QGuiApplication::palette();
    QPalette dark = before;
    dark.setColor(QPalette::Base, QColor(20, 30, 40));
    QGuiApplication::setPalette(dark);
    auto* tabs = child<QTabWidget>("tabs");
    for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        auto* shown = tabs->currentWidget()->findChild<QWidget*>(QStringLiteral("plot"));
        const auto corner = [shown] { return shown->grab().toImage().pixelColor(1, 1); };
        QTRY_COMPARE_WITH_TIMEOUT(corner(), QColor(20, 30, 40), kPatience);
    }
    QGuiApplication::setPalette(before);
}

void FrameRateTest::savesCsv() {
    addFrame(*m_session, 0.02);
    addFrame(*m_session, 0.04, 3);
    addFrame(*m_session, 0.04);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("frames.csv"));
    QVERIFY(m_panel->saveCsv(path).ok());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), 4);
    const QList<QByteArray> names = lines[0].split(',');
    const QList<QByteArray> cells = lines[2].split(',');
    QCOMPARE(cells.size(), names.size());
    const auto cell = [&](const char* name) { return cells[names.indexOf(name)]; };
    QCOMPARE(cell("pipeline"), QByteArray("transform-feedback"));
    QCOMPARE(cell("frame_ms").toDouble(), 40.0);
    QCOMPARE(cell("cpu_ms").toDouble(), 15.0);
    QCOMPARE(cell("gpu_ms").toDouble(), 20.0);
    QCOMPARE(cell("arrived_hits"), QByteArray("3"));
    QCOMPARE(lines[3].split(',')[names.indexOf("gpu_ms")], QByteArray());
    QVERIFY(!m_panel->saveCsv(folder.filePath(QStringLiteral("no/such/folder.csv"))).ok());
}

void FrameRateTest::saysThatTheGpuIsNotMeasured() {
    const auto* sentence = child<QLabel>("noGpuTimes");
    QVERIFY(!sentence->isVisible());
    m_session->frameCosts().setMeasuresGpu(false);
    QTRY_VERIFY_WITH_TIMEOUT(sentence->isVisible(), kPatience);
    QVERIFY(sentence->text().contains(QStringLiteral("no timer queries")));
}

void FrameRateTest::collectsCosts() {
    loadPaperRow(*m_session, 0);
    for (int i = 0; i < 3; ++i) {
        addFrame(*m_session, 0.02);
    }
    m_session->frameCosts().addGpuTimes(m_session->frameCosts().nextFrame() - 1, 0.01, 0.0);
    m_panel->costs().refresh();
    std::vector<NamedCurve> curves = m_panel->costs().curves();
    QCOMPARE(curves[1].pipeline, PipelineKind::TransformFeedback);
    QCOMPARE(curves[1].points.size(), std::size_t{1});
    QCOMPARE(curves[1].points[0].frame.value_or(0.0), 0.01);  // the GPU's, which is the longer
    addFrame(*m_session, 0.02, 2);
    m_panel->costs().refresh();
    QVERIFY(!m_panel->costs().curves()[1].points[0].hit);  // the GPU has not told yet
    m_session->frameCosts().addGpuTimes(m_session->frameCosts().nextFrame() - 1, 0.01, 0.0055);
    m_panel->costs().refresh();
    QCOMPARE(m_panel->costs().curves()[1].points[0].hit.value_or(0.0), 0.004);
    loadPaperRow(*m_session, 1);
    QVERIFY(m_panel->costs().curves()[1].points.empty());
}

void FrameRateTest::twoPipelinesAreNotMixedWithOne() {
    m_session->frameCosts().setMeasuresGpu(false);
    addFrame(*m_session, 0.02);
    FrameCost both;
    both.drawing = 1.0;
    both.pipelines = 2;
    m_session->frameCosts().addFrame(both);
    m_session->frameCosts().endFrame(1.0);
    m_panel->costs().refresh();
    const std::vector<NamedCurve> curves = m_panel->costs().curves();
    QCOMPARE(curves.size(), allPipelines().size());
    QCOMPARE(curves[1].points.size(), std::size_t{1});
    QVERIFY(curves[1].points[0].frame.value_or(1.0) < 0.02);
    QCOMPARE(m_panel->summary().worstCost, 1.0);
    QCOMPARE(m_panel->summary().medianCost, 1.0);  // of two pipelines alone
    addFrame(*m_session, 0.02);
    QCOMPARE(m_panel->summary().worstCost, 0.02);
}

void FrameRateTest::saysWhatFrameTimesAllow() {
    QCOMPARE(frameRateText({}), QStringLiteral("Idle"));
    QCOMPARE(frameTimeText(0.0833), QStringLiteral("83.3 ms"));
    QCOMPARE(frameTimeText(0.9994), QStringLiteral("999 ms"));
    QCOMPARE(frameTimeText(0.9996), QStringLiteral("1.0 s"));
    QCOMPARE(frameTimeText(12.34), QStringLiteral("12.3 s"));
    addFrame(*m_session, 0.0083);
    QCOMPARE(frameRateText(m_panel->summary()), QStringLiteral("8.3 ms (120 FPS)"));
    QCOMPARE(frameRateText(m_panel->summary(), {.scale = 0.70710678f}),
             QStringLiteral("8.3 ms (120 FPS), drawn at 71 % size"));
    QCOMPARE(frameRateText(m_panel->summary(), {.coarse = true}),
             QStringLiteral("8.3 ms (120 FPS), drawn with fewer triangles"));
    QCOMPARE(frameRateText(m_panel->summary(), {.scale = 0.5f, .coarse = true}),
             QStringLiteral("8.3 ms (120 FPS), drawn at 50 % size with fewer triangles"));
    FrameTimes::Summary idle = m_panel->summary();
    idle.recent = 0;
    QCOMPARE(frameRateText(idle), QStringLiteral("Idle · last frame 8.3 ms"));
}

void FrameRateTest::framesAloneWaitForTheGpu() {
    FrameCosts& costs = m_session->frameCosts();
    FrameCost cost;
    cost.drawing = 0.001;
    costs.addFrame(cost);
    costs.endFrame(0.001, false);
    QCOMPARE(m_panel->summary().recent, std::size_t{0});
    costs.addGpuTimes(costs.frames().back().number, 0.02, 0.0);
    QCOMPARE(frameRateText(m_panel->summary()), QStringLiteral("20.0 ms (50 FPS)"));
}

void FrameRateTest::measuresOnRequest() {
    loadPaperRow(*m_session, 0);
    CostPlan plan;
    plan.width = 64;
    plan.height = 48;
    plan.hits = {0, 5};
    plan.samples = 1;
    m_panel->costs().setPlan(plan);
    child<QTabWidget>("tabs")->setCurrentIndex(1);
    auto* measure = child<QPushButton>("measure");
    QTest::mouseClick(measure, Qt::LeftButton);
    QCOMPARE(measure->text(), QStringLiteral("Cancel"));
    QTRY_COMPARE_WITH_TIMEOUT(measure->text(), QStringLiteral("Measure now"), kPatience);
    for (const NamedCurve& curve : m_panel->costs().curves()) {
        QCOMPARE(curve.points.size(), pointsOf(curve.pipeline));
    }
    QVERIFY(child<QLabel>("words")->text().startsWith(QStringLiteral("Measured")));
    loadPaperRow(*m_session, 1);
    QVERIFY(child<QLabel>("words")->text().contains(QStringLiteral("The scene has changed since")));
    QCOMPARE(m_panel->costs().curves()[0].points.size(), std::size_t{2});
    plan.samples = 1'000'000;
    m_panel->costs().setPlan(plan);
    QTest::mouseClick(measure, Qt::LeftButton);
    QTest::mouseClick(measure, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(measure->text(), QStringLiteral("Measure now"), kPatience);
}

void FrameRateTest::measuresAgainstTheNumberOfVertices() {
    SizePlan plan;
    plan.width = 64;
    plan.height = 48;
    plan.vertices = {500, 8000};
    plan.hits = 4;
    plan.samples = 1;
    m_panel->costs().setSizePlan(plan);
    child<QTabWidget>("tabs")->setCurrentIndex(1);
    auto* words = child<QLabel>("words");
    child<QComboBox>("axis")->setCurrentIndex(1);
    QVERIFY(m_panel->costs().axis() == CostAxis::Vertices);
    QVERIFY2(words->text().startsWith(QStringLiteral("Not measured yet")), qPrintable(words->text()));
    auto* measure = child<QPushButton>("measure");
    QTest::mouseClick(measure, Qt::LeftButton);
    QCOMPARE(measure->text(), QStringLiteral("Cancel"));
    QTRY_COMPARE_WITH_TIMEOUT(measure->text(), QStringLiteral("Measure now"), kPatience);
    for (const NamedCurve& curve : m_panel->costs().curves()) {
        QCOMPARE(curve.points.size(), pointsOf(curve.pipeline));
        QVERIFY(curve.points.empty() || curve.points[1].at > 4.0 * curve.points[0].at);
    }
    QVERIFY2(words->text().startsWith(QStringLiteral("Measured on spheres with 4 hits.")),
             qPrintable(words->text()));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("sizes.csv"));
    QVERIFY(m_panel->saveCsv(path).ok());
    QFile csv(path);
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QVERIFY(csv.readLine().startsWith("pipeline,vertices,"));
    // The curve against hits is not touched, nor is this one by the scene.
    child<QComboBox>("axis")->setCurrentIndex(0);
    QVERIFY(words->text().startsWith(QStringLiteral("Collected")));
    loadPaperRow(*m_session, 1);
    child<QComboBox>("axis")->setCurrentIndex(1);
    QCOMPARE(m_panel->costs().curves()[0].points.size(), std::size_t{2});
}

HITSCOPE_TEST(FrameRateTest, QApplication)

}  // namespace hitscope::frame_rate_test

#include "frame_rate_test.moc"
