// SPDX-License-Identifier: GPL-3.0-or-later
// What shows the viewport's pictures: on software renderers from memory, with the same pixels as composed by
// OpenGL, and without another picture for what lies over it.
#include <QApplication>
#include <QPainter>
#include <QSignalSpy>

#include "support/baseline.h"
#include "support/test_program.h"
#include "viewport/surface/picture_surface.h"
#include "viewport/surface/surface_format.h"
#include "widgets/window_support.h"

namespace hitscope::picture_surface_test {

class PictureSurfaceTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup() { dropWindow(); }
    void bothShowTheSame();
    void windowShowsTheLastPicture();
    void grabbedWindowsShowIt();
    void whatLiesOverItDrawsNoPicture();
    void anotherSizeGetsItsPicture();
    void hiddenOnesGoOnLater();

private:
    [[nodiscard]] Viewport& viewport() { return m_window->viewport(); }
    [[nodiscard]] QWidget& canvas() { return viewport().surface().widget(); }
    /// What the window shows there.
    [[nodiscard]] QImage onScreen() {
        return m_window->grab(QRect(canvas().mapTo(m_window.get(), QPoint()), canvas().size())).toImage();
    }
    void hideOverlays() {
        for (QWidget* overlay : viewport().findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            overlay->setVisible(overlay == &canvas());
        }
    }
    void waitForRest() {
        QSignalSpy frames(&viewport().pictures(), &PictureFlow::shown);
        QTRY_VERIFY_WITH_TIMEOUT(!frames.wait(300), kPatience);
    }
};

void PictureSurfaceTest::init() {
    if (!isDrawnByCpu()) {
        QSKIP("a GPU's pictures are not kept in memory");
    }
    qunsetenv(kComposes);
    makeWindow();
    waitForRest();
}

void PictureSurfaceTest::bothShowTheSame() {
    QVERIFY(viewport().surface().keepsPictures());
    const QImage kept = viewport().surface().grab();
    dropWindow();
    qputenv(kComposes, "1");
    makeWindow();
    qunsetenv(kComposes);
    QVERIFY(!viewport().surface().keepsPictures());
    const QImage composed = viewport().surface().grab();
    QCOMPARE(composed.size(), kept.size());
    QCOMPARE(test::differing(composed, kept), 0);
}

/// As the screen has it, and not only when somebody asks for it.
void PictureSurfaceTest::windowShowsTheLastPicture() {
    const QImage before = viewport().surface().grab();
    const QSignalSpy shown(&viewport().pictures(), &PictureFlow::shown);
    Lights lights = m_session->settings().lights();
    lights.directional.direction.x *= -1.0f;
    m_session->settings().setLights(lights);
    QTRY_VERIFY_WITH_TIMEOUT(!shown.isEmpty(), kPatience);
    waitForRest();
    const QSignalSpy drawn(&viewport().pictures(), &PictureFlow::drawn);
    const QImage thumbnail = viewport().pictures().thumbnail(canvas().width());
    QCOMPARE(drawn.size(), 0);
    QVERIFY(test::differing(thumbnail, before, 20) > 100);
    QCOMPARE(test::differing(thumbnail, viewport().surface().grab()), 0);
}

void PictureSurfaceTest::grabbedWindowsShowIt() {
    hideOverlays();
    QCOMPARE(test::differing(onScreen(), viewport().surface().grab()), 0);
    // Of what is there now, even if no event has been seen to.
    Lights lights = m_session->settings().lights();
    lights.directional.direction.x *= -1.0f;
    m_session->settings().setLights(lights);
    const QImage grabbed = onScreen();
    QCOMPARE(test::differing(grabbed, viewport().surface().grab()), 0);
}

void PictureSurfaceTest::whatLiesOverItDrawsNoPicture() {
    QWidget overlay(&viewport());
    overlay.setGeometry(50, 50, 80, 40);
    const QSignalSpy drawn(&viewport().pictures(), &PictureFlow::drawn);
    QSignalSpy painted(&viewport(), &Viewport::windowPainted);
    overlay.show();
    QVERIFY(painted.wait(kPatience));
    overlay.move(120, 90);
    QVERIFY(painted.wait(kPatience));
    overlay.hide();
    QVERIFY(painted.wait(kPatience));
    QTest::qWait(100);
    QCOMPARE(drawn.size(), 0);
}

void PictureSurfaceTest::anotherSizeGetsItsPicture() {
    m_window->resize(m_window->size() + QSize(40, 30));
    QTRY_COMPARE_WITH_TIMEOUT(viewport().pictures().thumbnail(10'000).size(),
                              (viewport().devicePixelRatioF() * QSizeF(canvas().size())).toSize(), kPatience);
    QCOMPARE(canvas().size(), viewport().size());
    hideOverlays();
    QCOMPARE(test::differing(onScreen(), viewport().surface().grab()), 0);
}

void PictureSurfaceTest::hiddenOnesGoOnLater() {
    m_window->hide();
    const QImage before = viewport().pictures().thumbnail(canvas().width());
    Lights lights = m_session->settings().lights();
    lights.directional.direction.x *= -1.0f;
    m_session->settings().setLights(lights);
    QTest::qWait(100);
    m_window->show();
    const auto isAnother = [&] {
        const QImage now = viewport().pictures().thumbnail(canvas().width());
        return test::areComparable(now, before) && test::differing(now, before, 20) > 100;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isAnother(), kPatience);
}

HITSCOPE_TEST(PictureSurfaceTest, QApplication)

}  // namespace hitscope::picture_surface_test

#include "picture_surface_test.moc"
