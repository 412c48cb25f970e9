// SPDX-License-Identifier: GPL-3.0-or-later
// A widget whose pictures are drawn ahead: events are seen to meanwhile, and no picture is lost or shown
// late.
#include <QApplication>
#include <QThread>
#include <QTimer>
#include <QVBoxLayout>
#include <functional>
#include <memory>
#include <utility>

#include "support/test_program.h"
#include "viewport/surface/picture_ahead.h"

namespace hitscope::picture_ahead_test {

/// Counts what is asked of it; a picture is finished when the test says so.
class Canvas : public QWidget {
public:
    PictureAhead ahead{{.prepare =
                            [this] {
                                if (partsLeft-- > 0) {
                                    QThread::msleep(kLongPart);
                                    return false;
                                }
                                return true;
                            },
                        .begin =
                            [this] {
                                ++begun;
                                toldBegun();
                                return mayBegin;
                            },
                        .isFinished = [this] { return isFinished; },
                        .show =
                            [this] {
                                isAhead = true;
                                repaint();
                                return !std::exchange(isAhead, false);
                            },
                        .paint =
                            [this] {
                                paintsItself = true;
                                update();
                            }}};
    static constexpr unsigned long kLongPart = 6;  // milliseconds; a turn ends after five
    std::function<void()> toldBegun = [] {};
    int partsLeft = 0;  ///< before each picture
    int begun = 0;
    int shown = 0;  ///< pictures drawn ahead
    int drawn = 0;  ///< by itself
    int again = 0;  ///< the last picture
    bool mayBegin = true;
    bool isFinished = false;
    bool isByWindow = true;
    bool isAhead = false;
    bool paintsItself = true;

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        if (std::exchange(isAhead, false)) {
            ++shown;
        } else if (std::exchange(paintsItself, false) || !isByWindow) {
            ahead.drawn();
            ++drawn;
        } else {
            ++again;
        }
        QMetaObject::invokeMethod(
            this, [this] { ahead.shown(); }, Qt::QueuedConnection);
    }
};

class PictureAheadTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }
    void eventsComeWhileOneIsDrawn();
    void whatIsWantedMeanwhileFollows();
    void grabbedPicturesAreOfNow();
    void eventsComeBetweenParts();
    void beginsBeforeOthersPaint();
    void droppedOnesAreNotShown();
    void theWindowPaintsMeanwhile();
    void hiddenOnesDoNotHoldTheNext();
    void drawsItselfWhereItCannot();
    void offDrawsItself();

private:
    /// What was to come by itself has come: timers and events that were waiting, and what follows from them.
    static void someTurns() {
        int turns = 0;
        QTimer timer;
        connect(&timer, &QTimer::timeout, &timer, [&turns] { ++turns; });
        timer.start(2);  // it is looked once a millisecond whether a picture is finished
        QTRY_VERIFY_WITH_TIMEOUT(turns > 10, kPatience);
    }

    std::unique_ptr<QWidget> m_window;
    Canvas* m_canvas = nullptr;
    QWidget* m_beside = nullptr;
};

void PictureAheadTest::init() {
    m_window = std::make_unique<QWidget>();
    auto* layout = new QVBoxLayout(m_window.get());
    m_canvas = new Canvas;
    m_beside = new QWidget;
    layout->addWidget(m_canvas);
    layout->addWidget(m_beside);
    m_window->resize(200, 200);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatience));
    QTRY_VERIFY_WITH_TIMEOUT(m_canvas->drawn > 0, kPatience);
    someTurns();  // no more frames of the window's own
    m_canvas->drawn = 0;
    m_canvas->ahead.setOn(true);
}

void PictureAheadTest::eventsComeWhileOneIsDrawn() {
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    QVERIFY(m_canvas->ahead.isUnderWay());
    int turns = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&turns] { ++turns; });
    timer.start(0);
    m_beside->update();
    QTRY_VERIFY_WITH_TIMEOUT(turns > 20, kPatience);
    someTurns();
    QCOMPARE(m_canvas->shown + m_canvas->drawn, 0);
    m_canvas->isFinished = true;
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->shown, 1, kPatience);
    someTurns();
    QVERIFY(!m_canvas->ahead.isUnderWay());
    QCOMPARE(m_canvas->begun, 1);
    QCOMPARE(m_canvas->shown, 1);
    QCOMPARE(m_canvas->drawn, 0);
}

void PictureAheadTest::whatIsWantedMeanwhileFollows() {
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    m_canvas->ahead.want();
    m_canvas->ahead.want();
    someTurns();
    QCOMPARE(m_canvas->begun, 1);
    m_canvas->isFinished = true;
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->shown, 2, kPatience);
    someTurns();
    QCOMPARE(m_canvas->begun, 2);
    QCOMPARE(m_canvas->shown, 2);
    QCOMPARE(m_canvas->drawn, 0);
}

/// Pictures that are grabbed while one is drawn take its place.
void PictureAheadTest::grabbedPicturesAreOfNow() {
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    m_canvas->isByWindow = false;
    static_cast<void>(m_canvas->grab());
    m_canvas->isByWindow = true;
    QCOMPARE(m_canvas->drawn, 1);
    QVERIFY(!m_canvas->ahead.isUnderWay());
    someTurns();
    QCOMPARE(m_canvas->shown, 0);
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 2, kPatience);
    m_canvas->isFinished = true;
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->shown, 1, kPatience);
}

void PictureAheadTest::eventsComeBetweenParts() {
    int turns = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] {
        turns += m_canvas->begun == 0 ? 1 : 0;
        m_canvas->ahead.want();
    });
    timer.start(0);
    m_canvas->partsLeft = 20;
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    timer.stop();
    QVERIFY2(turns >= 15, qPrintable(QString::number(turns)));
    m_canvas->isFinished = true;
    QTRY_VERIFY_WITH_TIMEOUT(m_canvas->shown > 0, kPatience);
}

/// They paint while it is drawn.
void PictureAheadTest::beginsBeforeOthersPaint() {
    struct Watch : QObject {
        int paints = 0;
        bool eventFilter(QObject* /*watched*/, QEvent* event) override {
            paints += event->type() == QEvent::Paint ? 1 : 0;
            return false;
        }
    } watch;
    m_beside->installEventFilter(&watch);
    int paintsBefore = -1;
    m_canvas->toldBegun = [&] { paintsBefore = watch.paints; };
    m_beside->update();
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    QCOMPARE(paintsBefore, 0);
    QTRY_VERIFY_WITH_TIMEOUT(watch.paints > 0, kPatience);
    m_canvas->toldBegun = [] {};
    m_canvas->isFinished = true;
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->shown, 1, kPatience);
}

void PictureAheadTest::droppedOnesAreNotShown() {
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    m_canvas->ahead.drop();
    QVERIFY(!m_canvas->ahead.isUnderWay());
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 2, kPatience);
    QCOMPARE(m_canvas->shown, 0);
    m_canvas->isFinished = true;
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->shown, 1, kPatience);
}

void PictureAheadTest::theWindowPaintsMeanwhile() {
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    m_window->resize(240, 220);
    QTRY_VERIFY_WITH_TIMEOUT(m_canvas->again > 0, kPatience);
    QVERIFY(m_canvas->ahead.isUnderWay());
    m_canvas->isFinished = true;
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->shown, 1, kPatience);
    someTurns();  // then it rests
    QCOMPARE(m_canvas->begun, 1);
    QCOMPARE(m_canvas->drawn, 0);
}

void PictureAheadTest::hiddenOnesDoNotHoldTheNext() {
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    m_canvas->hide();
    m_canvas->isFinished = true;
    QTRY_VERIFY_WITH_TIMEOUT(!m_canvas->ahead.isUnderWay(), kPatience);
    QCOMPARE(m_canvas->shown, 0);
    m_canvas->show();
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->shown, 1, kPatience);
}

void PictureAheadTest::drawsItselfWhereItCannot() {
    m_canvas->mayBegin = false;
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->drawn, 1, kPatience);
    QCOMPARE(m_canvas->begun, 1);
}

void PictureAheadTest::offDrawsItself() {
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->begun, 1, kPatience);
    m_canvas->ahead.setOn(false);
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->drawn, 1, kPatience);
    m_canvas->ahead.want();
    QTRY_COMPARE_WITH_TIMEOUT(m_canvas->drawn, 2, kPatience);
    QCOMPARE(m_canvas->begun, 1);
    QCOMPARE(m_canvas->shown, 0);
}

HITSCOPE_TEST(PictureAheadTest, QApplication)

}  // namespace hitscope::picture_ahead_test

#include "picture_ahead_test.moc"
