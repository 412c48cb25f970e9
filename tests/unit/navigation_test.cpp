// SPDX-License-Identifier: GPL-3.0-or-later
// The hand on the camera, without a window: presets, orbit modes, glides, trackpads.
#include "viewport/navigation.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <glm/geometric.hpp>

#include "support/test_program.h"
#include "viewport/aim.h"

namespace hitscope::navigation_test {

namespace {

constexpr QSizeF kSize(800, 600);
constexpr QPointF kFrom(500, 200);

bool near(const glm::vec3& a, const glm::vec3& b, float distance = 1.0e-3f) {
    return glm::length(a - b) <= distance;
}

QPointF placeOf(const Camera& camera, const glm::vec3& point) {
    const auto aspect = static_cast<float>(kSize.width() / kSize.height());
    const glm::vec4 clip = camera.projection(aspect) * camera.view() * glm::vec4(point, 1.0f);
    return {0.5 * kSize.width() * static_cast<double>(1.0f + clip.x / clip.w),
            0.5 * kSize.height() * static_cast<double>(1.0f - clip.y / clip.w)};
}

}  // namespace

class NavigationTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void presetsMapButtons_data();
    void presetsMapButtons();
    void aClickIsNoDrag();
    void orbitTurnsAboutThePointUnderTheCursor();
    void turntableKeepsThePivot();
    void flyKeepsTheEyeAndFollowsTheHand();
    void shiftWheelChangesTheFieldOfView();
    void wheelZoomsInBothProjections();
    void twoFingersOrbitPanAndZoom();
    void pinchZooms();
    void glideArrivesExactly();
    void glideCanBeInterrupted();
    void noGlideWhileMeasuring();
    void standardViews();
    void flyingForwardWithoutAnEyeZooms();
    void shotsStartNearWhatTheyMeet();

private:
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPointF& by);
    void turn(QPoint pixels, QPoint angle, Qt::KeyboardModifiers keys, Qt::ScrollPhase phase);
    [[nodiscard]] const Camera& camera() const { return m_navigation->camera(); }

    std::unique_ptr<Navigation> m_navigation;
    std::optional<glm::vec3> m_surface;
};

void NavigationTest::init() {
    m_surface.reset();
    m_navigation = std::make_unique<Navigation>([this](const QPointF&) { return m_surface; });
    m_navigation->setViewSize(kSize);
    m_navigation->setSceneRadius(20.0f);
}

void NavigationTest::drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPointF& by) {
    const QMouseEvent press(QEvent::MouseButtonPress, kFrom, kFrom, button, button, keys);
    m_navigation->press(press);
    for (int step = 1; step <= 4; ++step) {
        const QPointF at = kFrom + by * (step / 4.0);
        m_navigation->move({QEvent::MouseMove, at, at, Qt::NoButton, button, keys});
    }
    m_navigation->release({QEvent::MouseButtonRelease, kFrom + by, kFrom + by, button, Qt::NoButton, keys});
}

void NavigationTest::turn(QPoint pixels, QPoint angle, Qt::KeyboardModifiers keys, Qt::ScrollPhase phase) {
    m_navigation->wheel({kFrom, kFrom, pixels, angle, Qt::NoButton, keys, phase, false});
}

void NavigationTest::presetsMapButtons_data() {
    QTest::addColumn<int>("preset");
    QTest::addColumn<int>("button");
    QTest::addColumn<int>("keys");
    QTest::addColumn<int>("motion");
    const auto row = [](const char* name, NavigationPreset preset, Qt::MouseButton button,
                        Qt::KeyboardModifiers keys, CameraMotion motion) {
        QTest::newRow(name) << static_cast<int>(preset) << static_cast<int>(button)
                            << static_cast<int>(keys.toInt()) << static_cast<int>(motion);
    };
    using P = NavigationPreset;
    row("left", P::Hitscope, Qt::LeftButton, {}, CameraMotion::Orbit);
    row("Shift+left", P::Hitscope, Qt::LeftButton, Qt::ShiftModifier, CameraMotion::Pan);
    row("Alt+left", P::Hitscope, Qt::LeftButton, Qt::AltModifier, CameraMotion::Orbit);
    row("right", P::Hitscope, Qt::RightButton, {}, CameraMotion::Pan);
    row("middle", P::Hitscope, Qt::MiddleButton, {}, CameraMotion::Pan);
    row("Blender's left", P::Blender, Qt::LeftButton, {}, CameraMotion::None);
    row("Blender's middle", P::Blender, Qt::MiddleButton, {}, CameraMotion::Orbit);
    row("Blender's Shift+middle", P::Blender, Qt::MiddleButton, Qt::ShiftModifier, CameraMotion::Pan);
    row("Blender's Ctrl+middle", P::Blender, Qt::MiddleButton, Qt::ControlModifier, CameraMotion::Zoom);
    row("Blender's right", P::Blender, Qt::RightButton, {}, CameraMotion::None);
}

void NavigationTest::presetsMapButtons() {
    QFETCH(int, preset);
    QFETCH(int, button);
    QFETCH(int, keys);
    QFETCH(int, motion);
    m_navigation->setPreset(static_cast<NavigationPreset>(preset));
    const Camera before = camera();
    drag(static_cast<Qt::MouseButton>(button), Qt::KeyboardModifiers::fromInt(keys), {60, 40});
    const bool turned = !near(camera().forward(), before.forward(), 1.0e-5f);
    const bool zoomed = camera().distance() != before.distance();
    const bool panned = !turned && !near(camera().pivot(), before.pivot(), 1.0e-5f);
    QCOMPARE(turned, motion == static_cast<int>(CameraMotion::Orbit));
    QCOMPARE(zoomed, motion == static_cast<int>(CameraMotion::Zoom));
    QCOMPARE(panned, motion == static_cast<int>(CameraMotion::Pan));
    QVERIFY(m_navigation->hasDragged());
}

void NavigationTest::aClickIsNoDrag() {
    const Camera before = camera();
    drag(Qt::LeftButton, {}, {2, 2});
    QVERIFY(!m_navigation->hasDragged());
    QVERIFY(camera() == before);
}

void NavigationTest::orbitTurnsAboutThePointUnderTheCursor() {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        m_navigation->setProjection(projection);
        const Ray ray = m_navigation->rayAt(kFrom);
        m_surface =
            ray.origin + (glm::dot(camera().pivot() - ray.origin, ray.direction) - 2.0f) * ray.direction;
        const Camera before = camera();
        drag(Qt::LeftButton, {}, {150, 40});
        QVERIFY(glm::dot(camera().forward(), before.forward()) < 0.95f);
        const QPointF there = placeOf(camera(), *m_surface);
        QVERIFY((there - kFrom).manhattanLength() < 0.5);
        QVERIFY(!near(camera().pivot(), before.pivot(), 0.1f));
    }
}

void NavigationTest::turntableKeepsThePivot() {
    m_surface = glm::vec3(1.0f, 2.0f, 3.0f);
    m_navigation->setOrbitMode(OrbitMode::Turntable);
    const Camera before = camera();
    drag(Qt::LeftButton, {}, {100, 40});
    QVERIFY(camera().pivot() == before.pivot() && camera().forward() != before.forward());
}

void NavigationTest::flyKeepsTheEyeAndFollowsTheHand() {
    m_navigation->setOrbitMode(OrbitMode::Fly);
    const Camera before = camera();
    const glm::vec3 seen = before.pivot();
    const QPointF from = placeOf(before, seen);
    drag(Qt::LeftButton, {}, {60, 40});
    QVERIFY(near(camera().eye(), before.eye()));
    const QPointF moved = placeOf(camera(), seen) - from;
    QVERIFY(std::abs(moved.x() - 60) < 12 && std::abs(moved.y() - 40) < 12);
}

void NavigationTest::shiftWheelChangesTheFieldOfView() {
    const QSignalSpy said(m_navigation.get(), &Navigation::fieldOfViewChanged);
    const Camera before = camera();
    turn({}, {0, 120}, Qt::ShiftModifier, Qt::NoScrollPhase);
    QVERIFY(camera().fieldOfView() < before.fieldOfView());
    QCOMPARE(camera().distance(), before.distance());
    QCOMPARE(said.size(), 1);
    for (int i = 0; i < 100; ++i) {
        turn({}, {0, -120}, Qt::ShiftModifier, Qt::NoScrollPhase);
    }
    QCOMPARE(camera().fieldOfView(), Camera::kWidest);
}

void NavigationTest::wheelZoomsInBothProjections() {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        m_navigation->setProjection(projection);
        const float before = camera().heightAt(camera().distance());
        turn({}, {0, 120}, {}, Qt::NoScrollPhase);
        QVERIFY(camera().heightAt(camera().distance()) < 0.95f * before);
    }
}

void NavigationTest::twoFingersOrbitPanAndZoom() {
    Camera before = camera();
    turn({40, 10}, {}, {}, Qt::ScrollUpdate);
    QVERIFY(camera().pivot() == before.pivot() && camera().forward() != before.forward());
    before = camera();
    turn({40, 10}, {}, Qt::ShiftModifier, Qt::ScrollUpdate);
    QVERIFY(camera().pivot() != before.pivot() && camera().forward() == before.forward());
    before = camera();
    turn({0, 10}, {}, Qt::ControlModifier, Qt::ScrollUpdate);
    QVERIFY(camera().distance() != before.distance() && near(camera().pivot(), before.pivot()));
}

void NavigationTest::pinchZooms() {
    const QPointingDevice pad;
    const auto gesture = [&pad](Qt::NativeGestureType type, double value) {
        return QNativeGestureEvent(type, &pad, 2, kFrom, kFrom, kFrom, value, {});
    };
    const float before = camera().distance();
    QVERIFY(m_navigation->gesture(gesture(Qt::ZoomNativeGesture, 0.25)));
    QVERIFY(std::abs(camera().distance() - before / 1.25f) < 1.0e-4f);
    QVERIFY(m_navigation->gesture(gesture(Qt::ZoomNativeGesture, -5.0)));  // a wild one stays sane
    QVERIFY(std::isfinite(camera().distance()) && camera().distance() > 0.0f);
    const float yaw = camera().yaw();
    QVERIFY(m_navigation->gesture(gesture(Qt::RotateNativeGesture, 10.0)));
    QVERIFY(camera().yaw() != yaw);
    QVERIFY(!m_navigation->gesture(gesture(Qt::BeginNativeGesture, 0.0)));
}

void NavigationTest::glideArrivesExactly() {
    Camera goal = camera();
    goal.setPivot({4.0f, 1.0f, -3.0f}, 3.0f, -0.4f, 17.0f);
    m_navigation->setCamera(goal);
    QVERIFY(m_navigation->isMoving() && m_navigation->goal() == goal && !(camera() == goal));
    float last = glm::length(camera().pivot() - goal.pivot());
    for (int frame = 0; m_navigation->isMoving(); ++frame) {
        QVERIFY(frame < 30);
        m_navigation->advance(CameraGlide::kSeconds / 20.0);
        const float left = glm::length(camera().pivot() - goal.pivot());
        QVERIFY(left <= last);
        last = left;
    }
    QVERIFY(camera() == goal);
    // From 3 to -3 radians is a short way across the half turn, not one round the front.
    Camera other = goal;
    other.setPivot(goal.pivot(), -3.0f, -0.4f, 17.0f);
    m_navigation->setCamera(other);
    m_navigation->advance(CameraGlide::kSeconds / 2.0);
    QVERIFY(std::abs(camera().yaw()) > 2.9f);
}

void NavigationTest::glideCanBeInterrupted() {
    Camera goal = camera();
    goal.setPivot({4.0f, 1.0f, -3.0f}, 3.0f, -0.4f, 17.0f);
    m_navigation->setCamera(goal);
    m_navigation->advance(CameraGlide::kSeconds / 2.0);
    const Camera halfway = camera();
    m_navigation->press({QEvent::MouseButtonPress, kFrom, kFrom, Qt::LeftButton, Qt::LeftButton, {}});
    QVERIFY(!m_navigation->isMoving());
    m_navigation->advance(1.0);
    QVERIFY(camera() == halfway);
}

void NavigationTest::noGlideWhileMeasuring() {
    Camera goal = camera();
    goal.setPivot({4.0f, 1.0f, -3.0f}, 3.0f, -0.4f, 17.0f);
    m_navigation->setGlides(false);
    m_navigation->setCamera(goal);
    QVERIFY(!m_navigation->isMoving() && camera() == goal);
}

void NavigationTest::standardViews() {
    const std::pair<StandardView, glm::vec3> views[] = {
        {StandardView::Front, {0, 0, -1}}, {StandardView::Back, {0, 0, 1}},
        {StandardView::Right, {-1, 0, 0}}, {StandardView::Left, {1, 0, 0}},
        {StandardView::Top, {0, -1, 0}},   {StandardView::Bottom, {0, 1, 0}}};
    m_navigation->setGlides(false);
    for (const auto& view : views) {
        const Camera before = camera();
        m_navigation->show(view.first);
        QVERIFY(near(camera().forward(), view.second, 1.0e-5f));
        QCOMPARE(camera().distance(), before.distance());
        QVERIFY(standardViewOf(camera()) == view.first);
    }
    m_navigation->setCamera(Camera());
    QVERIFY(!standardViewOf(camera()));
}

void NavigationTest::flyingForwardWithoutAnEyeZooms() {
    m_navigation->setProjection(Projection::Orthographic);
    const Camera before = camera();
    m_navigation->flyStep({0.0f, 0.0f, 1.0f});
    QVERIFY(camera().heightAt(0.0f) < before.heightAt(0.0f) && camera().pivot() == before.pivot());
    m_navigation->flyStep({1.0f, 0.0f, 0.0f});
    QVERIFY(glm::dot(camera().pivot() - before.pivot(), before.right()) > 0.1f);
}

void NavigationTest::shotsStartNearWhatTheyMeet() {
    const Ray perspective = m_navigation->rayAt(kFrom);
    QVERIFY(shotAlong(perspective, camera(), glm::vec3(0.0f)).origin == perspective.origin);
    m_navigation->setProjection(Projection::Orthographic);
    const Ray ray = m_navigation->rayAt(kFrom);
    const glm::vec3 met = ray.origin + 60.0f * ray.direction;
    const Ray shot = shotAlong(ray, camera(), met);
    QVERIFY(near(shot.origin + camera().distance() * shot.direction, met));
    const Ray past = shotAlong(ray, camera(), std::nullopt);
    QVERIFY(std::abs(glm::dot(past.origin - camera().eye(), camera().forward())) < 1.0e-3f);
}

HITSCOPE_TEST(NavigationTest, QApplication)

}  // namespace hitscope::navigation_test

#include "navigation_test.moc"
