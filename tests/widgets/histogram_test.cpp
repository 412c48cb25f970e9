// SPDX-License-Identifier: GPL-3.0-or-later
// The histogram widget and its handles, by mouse.
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "panels/histogram/histogram_plot.h"
#include "support/test_program.h"

namespace hitscope::histogram_test {

namespace {

/// The plot within, which takes the mouse.
QWidget* surfaceOf(HistogramPlot& plot) {
    return plot.childAt(plot.rect().center());
}

void mouse(QWidget* widget, QEvent::Type type, double x, bool held) {
    const QPointF at(x, widget->height() / 2.0);
    QMouseEvent event(type, at, widget->mapToGlobal(at),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      held ? Qt::LeftButton : Qt::NoButton, {});
    QCoreApplication::sendEvent(widget, &event);
}

Histogram someHistogram() {
    Histogram histogram(0.0, 1.0, 10);
    for (int i = 0; i < 100; ++i) {
        histogram.add(i / 100.0);
    }
    return histogram;
}

}  // namespace

class HistogramTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void binsAreHalfOpenButTheLast() {
        Histogram histogram(0.0, 1.0, 4);
        for (const double value : {0.0, 0.25, 0.5, 0.75, 1.0, -0.1, 1.1, std::nan("")}) {
            histogram.add(value);
        }
        QCOMPARE(histogram.counts, (std::vector<std::uint32_t>{1, 1, 1, 2}));
    }

    void handlesFollowTheMouse() {
        HistogramPlot plot;
        plot.resize(400, 200);
        plot.setHistogram(someHistogram());
        plot.setRange(HistogramPlot::Range{0.2, 0.8});
        plot.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot, kPatience));
        QSignalSpy dragged(&plot, &HistogramPlot::rangeDragged);
        QSignalSpy chosen(&plot, &HistogramPlot::rangeChosen);
        QWidget* surface = surfaceOf(plot);

        mouse(surface, QEvent::MouseButtonPress, plot.pixelOf(0.8), true);
        mouse(surface, QEvent::MouseMove, plot.pixelOf(0.65), true);
        mouse(surface, QEvent::MouseMove, plot.pixelOf(0.5), true);
        mouse(surface, QEvent::MouseButtonRelease, plot.pixelOf(0.5), false);
        QCOMPARE(dragged.size(), 2);
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(plot.range()->low, 0.2);
        QVERIFY(std::abs(plot.range()->high - 0.5) < 0.01);
        QCOMPARE(chosen[0][1].toDouble(), plot.range()->high);

        // Handles do not pass each other.
        mouse(surface, QEvent::MouseButtonPress, plot.pixelOf(0.2), true);
        mouse(surface, QEvent::MouseMove, plot.pixelOf(0.9), true);
        mouse(surface, QEvent::MouseButtonRelease, plot.pixelOf(0.9), false);
        QVERIFY(plot.range()->low < plot.range()->high);
        QVERIFY(plot.range()->high - plot.range()->low < 0.01);
    }

    void beyondTheGripNothingIsHeld() {
        HistogramPlot plot;
        plot.resize(400, 200);
        plot.setHistogram(someHistogram());
        plot.setRange(HistogramPlot::Range{0.2, 0.8});
        plot.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot, kPatience));
        QSignalSpy dragged(&plot, &HistogramPlot::rangeDragged);
        QWidget* surface = surfaceOf(plot);
        mouse(surface, QEvent::MouseButtonPress, plot.pixelOf(0.8) - HistogramPlot::kGrip - 2, true);
        mouse(surface, QEvent::MouseMove, plot.pixelOf(0.5), true);
        mouse(surface, QEvent::MouseButtonRelease, plot.pixelOf(0.5), false);
        QCOMPARE(dragged.size(), 0);
        QCOMPARE(*plot.range(), (HistogramPlot::Range{0.2, 0.8}));
    }

    void colouredInTheRange() {
        HistogramPlot plot;
        plot.resize(400, 200);
        plot.setHistogram(someHistogram());
        plot.setRange(HistogramPlot::Range{0.0, 1.0});
        plot.setColours([](double at) { return at < 0.5 ? QColor(Qt::red) : QColor(Qt::blue); });
        plot.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plot, kPatience));
        QCoreApplication::processEvents();
        const QImage image = plot.grab().toImage();
        const int y = image.height() / 2;
        const double ratio = image.devicePixelRatio();
        QVERIFY(QColor(image.pixel(static_cast<int>(plot.pixelOf(0.25) * ratio), y)).red() > 200);
        QVERIFY(QColor(image.pixel(static_cast<int>(plot.pixelOf(0.85) * ratio), y)).blue() > 200);
    }
};

HITSCOPE_TEST(HistogramTest, QApplication)

}  // namespace hitscope::histogram_test

#include "histogram_test.moc"
