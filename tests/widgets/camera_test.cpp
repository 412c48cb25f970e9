// SPDX-License-Identifier: GPL-3.0-or-later
// The camera by mouse, keys and menus of the whole window.
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QWheelEvent>
#include <cmath>

#include "app/actions/camera_actions.h"
#include "app/full_view.h"
#include "app/overlays/keys_overlay.h"
#include "mesh/primitives.h"
#include "support/test_program.h"
#include "view/camera_text.h"
#include "viewport/camera_trail.h"
#include "viewport/scene_in_sight.h"
#include "viewport/view_label.h"
#include "widgets/window_support.h"

namespace hitscope::camera_test {

namespace {

bool near(const glm::vec3& a, const glm::vec3& b, float distance = 1.0e-3f) {
    return glm::length(a - b) <= distance;
}

QAction* actionNamed(const QWidget& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>()) {
        QString plain = action->text();
        if (plain.remove(QLatin1Char('&')).startsWith(text)) {
            return action;
        }
    }
    return nullptr;
}

QString allText(const QWidget& widget) {
    QString text;
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
        text += label->text() + QLatin1Char('\n');
    }
    return text;
}

}  // namespace

class CameraWindowTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup();
    void padKeysTurnToTheAxes();
    void homeFramesAllAndPressingStopsIt();
    void whatIsAddedOutOfSightIsFramed();
    void middleDragOrbitsInBlendersPreset();
    void orthographicClickShootsWhereItPoints();
    void shiftWheelSaysTheFieldOfView();
    void copyAndPaste();
    void pasteSaysWhatIsWrong();
    void bookmarks();
    void earlierViewsComeBack();
    void isRemembered();
    void keysOverlayListsWhatThereIs();
    void viewportOnlyAndBack();
    void fullScreenIsShownInTheMenu();

private:
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(!navigation().isMoving(), kPatience); }
    [[nodiscard]] Navigation& navigation() { return m_window->viewport().navigation(); }
    [[nodiscard]] const Camera& camera() { return m_window->viewport().camera(); }
    [[nodiscard]] QPoint centre() const { return m_window->viewport().rect().center(); }
};

void CameraWindowTest::init() {
    makeWindow();
}

void CameraWindowTest::cleanup() {
    dropWindow();
}

void CameraWindowTest::padKeysTurnToTheAxes() {
    const auto pad = [this](Qt::Key key, Qt::KeyboardModifiers held = {}) {
        QTest::keyClick(&m_window->viewport(), key, held | Qt::KeypadModifier);
        settle();
    };
    const auto* label = m_window->findChild<ViewLabel*>();
    pad(Qt::Key_1);
    QVERIFY(near(camera().forward(), {0, 0, -1}));
    QVERIFY(label->text().contains(QStringLiteral("Front")));
    pad(Qt::Key_3);
    QVERIFY(near(camera().forward(), {-1, 0, 0}));
    pad(Qt::Key_7);
    QVERIFY(near(camera().forward(), {0, -1, 0}));
    pad(Qt::Key_1, Qt::ControlModifier);
    QVERIFY(near(camera().forward(), {0, 0, 1}));
    pad(Qt::Key_3, Qt::ControlModifier);
    QVERIFY(near(camera().forward(), {1, 0, 0}));
    pad(Qt::Key_Home);  // NumLock off
    QVERIFY(near(camera().forward(), {0, -1, 0}));
    pad(Qt::Key_5);
    QVERIFY(camera().isOrthographic());
    QVERIFY(label->text().contains(QStringLiteral("orthographic")));
    QVERIFY(actionNamed(*m_window, QStringLiteral("Orthographic"))->isChecked());
    pad(Qt::Key_5);
    QVERIFY(!camera().isOrthographic());
}

void CameraWindowTest::homeFramesAllAndPressingStopsIt() {
    const Camera before = camera();
    navigation().flyStep({8.0f, 0.0f, 0.0f});
    QTest::keyClick(&m_window->viewport(), Qt::Key_Home);
    QVERIFY(navigation().isMoving());
    settle();
    QVERIFY(near(camera().pivot(), before.pivot()));
    navigation().flyStep({8.0f, 0.0f, 0.0f});
    QTest::keyClick(&m_window->viewport(), Qt::Key_Home);
    QTest::mousePress(&m_window->viewport(), Qt::RightButton, {}, centre());
    QVERIFY(!navigation().isMoving());
    QTest::mouseRelease(&m_window->viewport(), Qt::RightButton, {}, centre());
    QVERIFY(!near(camera().pivot(), before.pivot(), 0.1f));
    // Measured, the camera is there at once.
    m_window->viewport().setDrawsContinuously(true);
    QTest::keyClick(&m_window->viewport(), Qt::Key_Home);
    QVERIFY(near(camera().pivot(), before.pivot()));
    m_window->viewport().setDrawsContinuously(false);
}

void CameraWindowTest::whatIsAddedOutOfSightIsFramed() {
    Viewport& viewport = m_window->viewport();
    viewport.navigation().setGlides(false);
    const Bounds teapot = m_session->targets().bounds();
    // From a file, it keeps its coordinates.
    TargetPlan added = planMesh(makeCube(2, 0.02f * teapot.diagonal()), QStringLiteral("/far.obj"));
    const auto isSeen = [&] {
        return isInPicture(coreOf(m_session->targets().find(m_session->targets().selected())->worldBounds()),
                           viewport.camera(), viewport.navigation().aspect(), 0.9f);
    };
    added.transform.position = teapot.centre() + glm::vec3(0.0f, 0.55f * teapot.size().y, 0.0f);
    m_session->targets().add({added});
    Camera before = viewport.camera();
    QVERIFY(isSeen());
    viewport.bringSelectionIntoSight();
    QVERIFY(viewport.camera() == before);
    added.transform.position = teapot.centre() + 40.0f * before.distance() * before.right();
    m_session->targets().add({added});
    before = viewport.camera();
    QVERIFY(!isSeen());
    viewport.bringSelectionIntoSight();
    QVERIFY(isSeen());
    QVERIFY(!(viewport.camera() == before));
}

void CameraWindowTest::middleDragOrbitsInBlendersPreset() {
    actionNamed(*m_window, QStringLiteral("As in Blender"))->trigger();
    Viewport& viewport = m_window->viewport();
    const auto drag = [&](Qt::MouseButton button) {
        QTest::mousePress(&viewport, button, {}, centre());
        const QPointF at = centre() + QPoint(80, 20);
        QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, button, {});
        QCoreApplication::sendEvent(&viewport, &move);
        QTest::mouseRelease(&viewport, button, {}, at.toPoint());
    };
    Camera before = camera();
    drag(Qt::LeftButton);
    QVERIFY(camera() == before);
    drag(Qt::MiddleButton);
    QVERIFY(!near(camera().forward(), before.forward(), 0.05f));
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, centre());
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{1}, kPatience);
}

void CameraWindowTest::orthographicClickShootsWhereItPoints() {
    navigation().setProjection(Projection::Orthographic);
    const QPoint at = centre() + QPoint(40, -50);
    const Ray ray = navigation().rayAt(at);
    const auto aimed = m_session->simulation().physics().castRay(ray.origin, ray.direction, 1.0e4f);
    QVERIFY(aimed.has_value());
    QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, at);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{1}, kPatience);
    QVERIFY(near(m_session->hits().history().hits().front().point, aimed->point, 0.15f));
}

void CameraWindowTest::shiftWheelSaysTheFieldOfView() {
    Viewport& viewport = m_window->viewport();
    const float before = camera().fieldOfView();
    QWheelEvent event(centre(), viewport.mapToGlobal(centre()), {}, {0, 120}, Qt::NoButton, Qt::ShiftModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&viewport, &event);
    QVERIFY(camera().fieldOfView() < before);
    const auto* label = m_window->findChild<ViewLabel*>();
    QVERIFY(label->text().contains(QStringLiteral("46°")));
    QTRY_VERIFY_WITH_TIMEOUT(!label->text().contains(QStringLiteral("46°")), kPatience);
}

void CameraWindowTest::copyAndPaste() {
    navigation().flyStep({1.0f, 2.0f, 0.0f});
    const Camera there = camera();
    QTest::keyClick(&m_window->viewport(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(QGuiApplication::clipboard()->text(), QString::fromStdString(cameraText(there)));
    navigation().flyStep({5.0f, 0.0f, 0.0f});
    QTest::keyClick(&m_window->viewport(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    settle();
    QVERIFY(camera() == there);
}

void CameraWindowTest::pasteSaysWhatIsWrong() {
    const Camera before = camera();
    QGuiApplication::clipboard()->setText(QStringLiteral("camera pivot 1 2 yaw 3"));
    QTest::keyClick(&m_window->viewport(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    auto* box = m_window->findChild<QMessageBox*>();
    QVERIFY(box != nullptr && box->text().contains(QStringLiteral("pivot")));
    QVERIFY(box->informativeText().contains(QStringLiteral("camera pivot 0 1.5 0")));
    box->close();
    QVERIFY(camera() == before);
}

void CameraWindowTest::bookmarks() {
    const Camera before = camera();
    QTest::keyClick(&m_window->viewport(), Qt::Key_3);  // none there yet
    QVERIFY(camera() == before);
    QTest::keyClick(&m_window->viewport(), Qt::Key_3, Qt::ControlModifier);
    navigation().flyStep({5.0f, 0.0f, 0.0f});
    navigation().setProjection(Projection::Orthographic);
    QTest::keyClick(&m_window->viewport(), Qt::Key_3);
    settle();
    QVERIFY(camera() == before);
}

void CameraWindowTest::earlierViewsComeBack() {
    CameraTrail& trail = m_window->findChild<CameraActions*>()->trail();
    trail.note();
    QAction* back = actionNamed(*m_window, QStringLiteral("Previous View"));
    QAction* forward = actionNamed(*m_window, QStringLiteral("Next View"));
    QVERIFY(back != nullptr && forward != nullptr);
    const std::string first = cameraText(camera());
    QVERIFY(!back->isEnabled() && !forward->isEnabled());
    navigation().turnBy({60.0, 0.0});
    const std::string second = cameraText(camera());
    QVERIFY(back->isEnabled());
    const std::size_t steps = m_session->steps().size();
    QTest::keyClick(&m_window->viewport(), Qt::Key_Left, Qt::AltModifier);
    settle();
    QCOMPARE(cameraText(camera()), first);
    QVERIFY(!back->isEnabled() && forward->isEnabled());
    QTest::mouseClick(&m_window->viewport(), Qt::ForwardButton, {}, centre());
    settle();
    QCOMPARE(cameraText(camera()), second);
    QTest::mouseClick(&m_window->viewport(), Qt::BackButton, {}, centre());
    settle();
    QCOMPARE(cameraText(camera()), first);
    QCOMPARE(m_session->steps().size(), steps);  // undo leaves the camera alone
    // They were views of this scene.
    loadPaperRow(*m_session, 0);
    QVERIFY(!forward->isEnabled());
}

void CameraWindowTest::isRemembered() {
    navigation().setPreset(NavigationPreset::Blender);
    navigation().setOrbitMode(OrbitMode::Turntable);
    navigation().setProjection(Projection::Orthographic);
    QTest::keyClick(&m_window->viewport(), Qt::Key_7, Qt::ControlModifier);
    const Camera stored = camera();
    m_window->close();
    makeWindow();
    QCOMPARE(navigation().preset(), NavigationPreset::Blender);
    QCOMPARE(navigation().orbitMode(), OrbitMode::Turntable);
    QVERIFY(camera().isOrthographic());
    navigation().flyStep({5.0f, 0.0f, 0.0f});
    QTest::keyClick(&m_window->viewport(), Qt::Key_7);
    settle();
    QVERIFY(camera() == stored);
}

void CameraWindowTest::keysOverlayListsWhatThereIs() {
    QTest::keyClick(&m_window->viewport(), Qt::Key_F1);
    auto* overlay = m_window->findChild<KeysOverlay*>();
    QVERIFY(overlay != nullptr && overlay->isVisible());
    QString text = allText(*overlay);
    // Of the preset, a held key, an action, a dock's own action, and one line for nine bookmarks.
    for (const char* said : {"Right-drag", "W A S D", "Ctrl+E", "Frame All", "Rename", "1 … 9"}) {
        QVERIFY2(text.contains(QString::fromUtf8(said)), said);
    }
    QVERIFY(!text.contains(QStringLiteral("Bookmark 5")));
    QTest::keyClick(overlay, Qt::Key_Escape);
    QVERIFY(!overlay->isVisible());
    QVERIFY(m_window->viewport().hasFocus());
    // It follows what there is.
    actionNamed(*m_window, QStringLiteral("Frame All"))->setShortcut(QKeySequence(QStringLiteral("Ctrl+F9")));
    navigation().setPreset(NavigationPreset::Blender);
    QTest::keyClick(&m_window->viewport(), Qt::Key_F1);
    text = allText(*overlay);
    QVERIFY(text.contains(QStringLiteral("Ctrl+F9")) && !text.contains(QStringLiteral("Right-drag")));
    QTest::keyClick(overlay, Qt::Key_F1);
    QVERIFY(!overlay->isVisible());
}

void CameraWindowTest::viewportOnlyAndBack() {
    auto* history = m_window->findChild<QDockWidget*>(QStringLiteral("hitHistory"));
    auto* lights = m_window->findChild<QDockWidget*>(QStringLiteral("lights"));
    lights->hide();
    QVERIFY(history->isVisible());
    const QSize before = m_window->viewport().size();
    QTest::keyClick(&m_window->viewport(), Qt::Key_Return, Qt::AltModifier);
    QVERIFY(!history->isVisible() && !m_window->menuBar()->isVisible());
    QVERIFY(m_window->windowState().testFlag(Qt::WindowFullScreen));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->viewport().height() > before.height(), kPatience);
    // Keys of the menus still count.
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QCOMPARE(m_window->viewport().options().wireframe, WireframeMode::Over);
    QTest::keyClick(&m_window->viewport(), Qt::Key_Escape);
    QVERIFY(history->isVisible() && m_window->menuBar()->isVisible() && !lights->isVisible());
    QVERIFY(!m_window->windowState().testFlag(Qt::WindowFullScreen));
    // Closed while it is on, the window comes back with all its parts.
    QTest::keyClick(&m_window->viewport(), Qt::Key_Return, Qt::AltModifier);
    m_window->close();
    makeWindow();
    QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("hitHistory"))->isVisible());
    QVERIFY(m_window->menuBar()->isVisible());
}

/// Whoever changes the window's state: our keys, the window manager, a restored geometry.
void CameraWindowTest::fullScreenIsShownInTheMenu() {
    const auto isFull = [this] { return m_window->windowState().testFlag(Qt::WindowFullScreen); };
    QAction* full = actionNamed(*m_window, QStringLiteral("Full Screen"));
    m_window->setWindowState(m_window->windowState() | Qt::WindowFullScreen);
    QVERIFY(full->isChecked());
    m_window->setWindowState(m_window->windowState() & ~Qt::WindowFullScreen);
    QVERIFY(!full->isChecked());
    QTest::keyClick(&m_window->viewport(), Qt::Key_Return, Qt::AltModifier);
    QVERIFY(isFull() && full->isChecked());
    full->trigger();  // F11 leaves it, where it was entered by another key
    QVERIFY(!isFull() && !full->isChecked());
    QTest::keyClick(&m_window->viewport(), Qt::Key_Escape);
    full->trigger();
    QTest::keyClick(&m_window->viewport(), Qt::Key_Return, Qt::AltModifier);
    QTest::keyClick(&m_window->viewport(), Qt::Key_Escape);
    QVERIFY(isFull() && full->isChecked());
    m_window->close();
    makeWindow();
    QVERIFY(isFull());
    full = actionNamed(*m_window, QStringLiteral("Full Screen"));
    QVERIFY(full->isChecked());
    full->trigger();
    QVERIFY(!isFull());
}

HITSCOPE_TEST(CameraWindowTest, QApplication)

}  // namespace hitscope::camera_test

#include "camera_test.moc"
