// SPDX-License-Identifier: GPL-3.0-or-later
// The range between the handles in the dock "Mesh statistics": who chose it, and for how long.
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <cmath>

#include "panels/histogram/histogram_plot.h"
#include "panels/mesh_statistics/mesh_statistics_panel.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::displacement_range_test {

class DisplacementRangeTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        choosePipeline(*m_window, PipelineKind::TransformFeedback);  // also where it is not exact
        auto* panel = m_window->findChild<MeshStatisticsPanel*>();
        QVERIFY(panel != nullptr);
        m_window->findChild<QDockWidget*>(QStringLiteral("meshStatistics"))->raise();
        panel->findChild<QTabWidget*>(QStringLiteral("tabs"))->setCurrentIndex(1);
        m_plot = panel->findChild<HistogramPlot*>(QStringLiteral("histogram"));
        m_whole = panel->findChild<QPushButton*>(QStringLiteral("wholeRange"));
        QTRY_VERIFY_WITH_TIMEOUT(m_plot->isVisible(), kPatience);
        shootAndWait(1, 3);
    }
    void cleanup() { dropWindow(); }

    void followsTheDataUntilSomebodyChooses() {
        QCOMPARE(m_plot->range()->high, m_plot->histogram().high);
        const double before = m_plot->histogram().high;
        shootAndWait(40, 5);
        QVERIFY(m_plot->histogram().high > before);
        QCOMPARE(m_plot->range()->high, m_plot->histogram().high);
    }

    void staysWhereSomebodyPutIt() {
        dragUpperHandleToTheMiddle();
        const HistogramPlot::Range chosen = *m_plot->range();
        QVERIFY(chosen.high < 0.6 * m_plot->histogram().high);
        shootAndWait(40, 5);
        QCOMPARE(*m_plot->range(), chosen);
        QTest::mouseClick(m_whole, Qt::LeftButton);
        QCOMPARE(m_plot->range()->high, m_plot->histogram().high);
        const double before = m_plot->histogram().high;
        shootAndWait(40, 9);
        QVERIFY(m_plot->histogram().high >= before);
        QCOMPARE(m_plot->range()->high, m_plot->histogram().high);
    }

    void anotherSceneIsNotThatOfTheHandles() {
        dragUpperHandleToTheMiddle();
        loadSphere(*m_session);
        QTRY_VERIFY_WITH_TIMEOUT(m_plot->histogram().counts.empty(), kPatience);
        shootAndWait(10, 3);
        QCOMPARE(m_plot->range()->high, m_plot->histogram().high);
    }

    /// What was chosen was of displacements that are all gone.
    void undoingEverythingForgetsTheChoice() {
        dragUpperHandleToTheMiddle();
        m_session->goToStep(0);
        QTRY_VERIFY_WITH_TIMEOUT(m_plot->histogram().counts.empty(), kPatience);
        shootAndWait(10, 3);
        QCOMPARE(m_plot->range()->high, m_plot->histogram().high);
        shootAndWait(40, 5);
        QCOMPARE(m_plot->range()->high, m_plot->histogram().high);
    }

private:
    /// Until the histogram counts every vertex that moved.
    void shootAndWait(int shots, std::uint32_t seed) {
        shootAll(*m_session, demoShots(*m_session, shots, seed));
        QVERIFY(m_window->viewport().syncNow().ok());
        const auto isShown = [this] {
            const DisplacementStatistics moved = m_session->targets()[0]->deformed.statistics();
            std::size_t counted = 0;
            for (const std::uint32_t count : m_plot->histogram().counts) {
                counted += count;
            }
            return moved.changedVertices > 0 && counted == moved.changedVertices &&
                   std::abs(m_plot->histogram().high - moved.maximum) < 1e-6;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isShown(), kPatience);
    }

    void dragUpperHandleToTheMiddle() {
        QWidget* surface = m_plot->childAt(m_plot->rect().center());
        const auto mouse = [surface](QEvent::Type type, double x, bool held) {
            const QPointF at(x, surface->height() / 2.0);
            QMouseEvent event(type, at, surface->mapToGlobal(at),
                              type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                              held ? Qt::LeftButton : Qt::NoButton, {});
            QCoreApplication::sendEvent(surface, &event);
        };
        const double high = m_plot->range()->high;
        mouse(QEvent::MouseButtonPress, m_plot->pixelOf(high), true);
        mouse(QEvent::MouseMove, m_plot->pixelOf(0.5 * high), true);
        mouse(QEvent::MouseButtonRelease, m_plot->pixelOf(0.5 * high), false);
    }

    HistogramPlot* m_plot = nullptr;
    QPushButton* m_whole = nullptr;
};

HITSCOPE_TEST(DisplacementRangeTest, QApplication)

}  // namespace hitscope::displacement_range_test

#include "displacement_range_test.moc"
