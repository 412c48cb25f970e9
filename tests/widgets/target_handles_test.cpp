// SPDX-License-Identifier: GPL-3.0-or-later
// The Move tool: selected targets are moved and turned by handles in the picture.
#include <QMouseEvent>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <vector>

#include "mesh/primitives.h"
#include "session/mesh_steps/scale_target.h"
#include "support/test_program.h"
#include "viewport/handles/handle_grip.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::target_handles_test {

class TargetHandlesTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        QTest::keyClick(&viewport(), Qt::Key_M);
        QCOMPARE(viewport().inspectTool().tool(), Tool::Move);
    }
    void cleanup() { dropWindow(); }

    void aClickSelectsAndDoesNotShoot() {
        QVERIFY(targets().isSelected(first().id));  // the only one
        QVERIFY(grip("moveX")->isVisible());
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(8, viewport().height() - 8));
        QVERIFY(!targets().selected());
        QVERIFY(!grip("moveX")->isVisible());
        // Beside the grip in the middle.
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().rect().center() + QPoint(0, 30));
        QVERIFY(targets().isSelected(first().id));
        QVERIFY(grip("moveX")->isVisible());
        QCOMPARE(m_session->hits().history().size(), std::size_t{0});
        QVERIFY(!m_session->simulation().isMoving());
        QTest::keyClick(&viewport(), Qt::Key_I);
        QVERIFY(!grip("moveX")->isVisible());
    }

    void theHandlesOfAHitAreOfOtherTools() {
        QVERIFY(m_session->simulation().hitscan(viewport().rayThrough({0.5, 0.5})));
        QVERIFY(viewport().syncNow().ok());
        m_session->hits().select(0);
        QVERIFY(!grip("hitSize")->isVisible());
        QTest::keyClick(&viewport(), Qt::Key_I);
        QVERIFY(grip("hitSize")->isVisible());
        QTest::keyClick(&viewport(), Qt::Key_M);
        QVERIFY(!grip("hitSize")->isVisible());
    }

    void alongAnAxis_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("axis");
        QTest::newRow("x") << QStringLiteral("moveX") << 0;
        QTest::newRow("y") << QStringLiteral("moveY") << 1;
        QTest::newRow("z") << QStringLiteral("moveZ") << 2;
    }
    void alongAnAxis() {
        QFETCH(const QString, name);
        QFETCH(const int, axis);
        const RigidTransform before = first().transform;
        const QPointF head = grip(name)->centre();
        const QPointF way = 0.8 * (head - grip("moveAcross")->centre());
        drag(name, way);
        const glm::vec3 moved = first().transform.position - before.position;
        QVERIFY2(moved[axis] > 0.05f, qPrintable(QString::number(moved[axis])));
        QCOMPARE(moved[(axis + 1) % 3], 0.0f);
        QCOMPARE(moved[(axis + 2) % 3], 0.0f);
        QVERIFY(first().transform.rotation == before.rotation);
        // The grip has followed the cursor, to a pixel; its own size in the picture stays, so that from
        // nearer or farther it ends elsewhere on its line than it began.
        const QPointF middle = placeOf(first().worldBounds().centre());
        QVERIFY(distance(grip("moveAcross")->centre(), middle) < 1.0);
        QCOMPARE(m_session->steps().size(), std::size_t{1});
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::MoveTarget, 1}));
        m_session->undo();
        QVERIFY(first().transform.position == before.position);
        QVERIFY(distance(grip(name)->centre(), head) < 1.0);
    }

    void acrossTheSight() {
        const QPointF from = grip("moveAcross")->centre();
        drag("moveAcross", {70.0, -40.0});
        QVERIFY(distance(grip("moveAcross")->centre(), from + QPointF(70.0, -40.0)) < 1.5);
        const glm::vec3 moved = first().transform.position;
        QVERIFY(std::abs(glm::dot(moved, viewport().camera().forward())) < 0.01f * glm::length(moved));
        QCOMPARE(m_session->steps().size(), std::size_t{1});
    }

    void roundSteps() {
        drag("moveX", {61.0, 9.0}, Qt::ControlModifier);
        const double moved = static_cast<double>(first().transform.position.x);
        const double tenths = moved / 0.05;  // steps of 1, 2 or 5 times a power of ten
        QVERIFY(moved > 0.0);
        QVERIFY2(std::abs(tenths - std::round(tenths)) < 1.0e-4, qPrintable(QString::number(moved)));
        drag("turnY", {50.0, 10.0}, Qt::ControlModifier);
        const double degrees = turnOf(first()) * 180.0 / std::numbers::pi;
        QVERIFY(degrees > 1.0);
        QVERIFY2(std::abs(std::remainder(degrees, 15.0)) < 0.01, qPrintable(QString::number(degrees)));
    }

    void aboutAnAxis_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("axis");
        QTest::newRow("x") << QStringLiteral("turnX") << 0;
        QTest::newRow("y") << QStringLiteral("turnY") << 1;
        QTest::newRow("z") << QStringLiteral("turnZ") << 2;
    }
    void aboutAnAxis() {
        QFETCH(const QString, name);
        QFETCH(const int, axis);
        const RigidTransform before = first().transform;
        const glm::vec3 centre = first().worldBounds().centre();
        // Along the circle where the grip is: it stays under the cursor.
        const QPointF from = grip(name)->centre();
        drag(name, {24.0, 18.0});
        const glm::vec3 turnedAbout(first().transform.rotation.x, first().transform.rotation.y,
                                    first().transform.rotation.z);
        QVERIFY2(turnOf(first()) > 0.05, qPrintable(QString::number(turnOf(first()))));
        QVERIFY(std::abs(turnedAbout[axis]) > 0.999f * glm::length(turnedAbout));
        QVERIFY(glm::distance(first().worldBounds().centre(), centre) < 1.0e-5f);
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::RotateTarget, 1}));
        QCOMPARE(m_session->steps().size(), std::size_t{1});
        m_session->undo();
        QVERIFY(first().transform.rotation == before.rotation);
        QVERIFY(distance(grip(name)->centre(), from) < 1.0);
    }

    void aTurnFollowsTheCursor() {
        // From above the circle about y is a circle, and the target turns by as much as the cursor goes
        // round.
        viewport().navigation().show(StandardView::Top);
        QTRY_VERIFY_WITH_TIMEOUT(viewport().camera().forward().y < -0.9999f, kPatience);
        QVERIFY(!grip("moveY")->isVisible());
        const QPointF middle = grip("moveAcross")->centre();
        const QPointF arm = grip("turnY")->centre() - middle;
        constexpr double kTurn = 2.0;  // radians, clockwise as one sees it
        const QPointF to(arm.x() * std::cos(kTurn) - arm.y() * std::sin(kTurn),
                         arm.x() * std::sin(kTurn) + arm.y() * std::cos(kTurn));
        drag("turnY", to - arm);
        QVERIFY2(std::abs(turnOf(first()) - kTurn) < 0.03, qPrintable(QString::number(turnOf(first()))));
        QVERIFY(first().transform.rotation.y * first().transform.rotation.w < 0.0f);  // y is up, to the eye
    }

    void escapeTakesTheDragBack() {
        const RigidTransform before = first().transform;
        const HandleGrip* held = grip("turnZ");
        const QPointF from = held->centre();
        for (const char* name : {"moveX", "turnZ"}) {
            press(name);
            moveBy({40.0, -20.0});
            QVERIFY(first().transform.position != before.position ||
                    first().transform.rotation != before.rotation);
            QTest::keyClick(&viewport(), Qt::Key_Escape);
            QVERIFY(!m_held->isHeld());
            moveBy({80.0, -20.0});
            release();
            QVERIFY(first().transform.position == before.position);
            QVERIFY(first().transform.rotation == before.rotation);
            QCOMPARE(m_session->steps().size(), std::size_t{0});
            QVERIFY(targets().isSelected(first().id));
        }
        QVERIFY(distance(held->centre(), from) < 1.0);
    }

    /// Rotations of whatever last bits: one step, and none after Escape.
    void whatIsTurnedIsOnlyMoved() {
        glm::quat rotation(1.0f, 0.0f, 0.0f, 0.0f);
        for (float angle = 0.1f; rotation / glm::length(rotation) == rotation; angle += 0.1f) {
            rotation = glm::normalize(glm::angleAxis(angle, glm::normalize(glm::vec3(1.0f, 2.0f, angle))));
        }
        QVERIFY(targets().setTransform(first().id, {{}, rotation}).ok());
        viewport().frameAll(Navigation::Arrival::AtOnce);
        QVERIFY(viewport().syncNow().ok());
        const RigidTransform before = first().transform;
        QVERIFY(before.rotation == rotation);
        QVERIFY(targets().setTransform(first().id, {{0.1f, 0.0f, 0.0f}, rotation}).ok());
        m_session->undo();
        const std::size_t done = m_session->steps().done();
        press("moveX");
        moveBy({20.0, 0.0});
        moveBy({40.0, 0.0});
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        release();
        QVERIFY(first().transform == before);
        QCOMPARE(m_session->steps().done(), done);
        QVERIFY(m_session->steps().canRedo());
        press("moveX");
        moveBy({20.0, 0.0});
        moveBy({40.0, 0.0});
        release();
        QCOMPARE(m_session->steps().done(), done + 1);
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::MoveTarget, 1}));
    }

    void allAreSelectedByKey() {
        targets().add({planMesh(makeLowPolyCube())});
        targets().select({});
        QTest::keyClick(&viewport(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(targets().allSelected().size(), std::size_t{2});
        QCOMPARE(targets().selected(), first().id);
        QVERIFY(grip("moveX")->isVisible());
    }

    /// The cursor may be anywhere: the target goes with the nearest place on the line that is shown.
    void theDragGoesOnOutside() {
        const QPointF head = grip("moveX")->centre();
        const QPointF along = head - grip("moveAcross")->centre();
        const QPointF line = along / std::hypot(along.x(), along.y());
        const QPointF across(-line.y(), line.x());
        press("moveX");
        float last = 0.0f;
        for (int way = 40; head.x() + way < viewport().width() + 200.0; way += 40) {
            moveBy(way * line);
            const float now = first().transform.position.x;
            QVERIFY2(now > last, qPrintable(QString::number(way)));
            last = now;
            moveBy(way * line + 60.0 * across);
            QVERIFY(std::abs(first().transform.position.x / now - 1.0f) < 0.02f);
        }
        release();
        viewport().frameAll(Navigation::Arrival::AtOnce);
        drag("moveAcross", {viewport().width() + 50.0, 0.0});
        QVERIFY(first().transform.position.x > last);
    }

    void undoLetsGo() {
        press("moveX");
        moveBy({40.0, 0.0});
        m_session->undo();
        QVERIFY(!m_held->isHeld());
        QVERIFY(grip("moveY")->isVisible());
        moveBy({80.0, 0.0});
        release();
        QCOMPARE(first().transform.position.x, 0.0f);
        QVERIFY(m_session->steps().canRedo());
    }

    void severalTurnAboutTheirMiddle() {
        targets().add({planMesh(makeLowPolyCube())});
        viewport().frameAll(Navigation::Arrival::AtOnce);
        const std::vector<TargetId> both{targets()[0]->id, targets()[1]->id};
        targets().select(both[0], both);
        QVERIFY(viewport().syncNow().ok());
        const glm::vec3 way = targets()[1]->transform.position - targets()[0]->transform.position;
        const glm::vec3 middle = middleOfAll();
        const std::size_t steps = m_session->steps().size();
        drag("turnY", {50.0, 10.0});
        const glm::vec3 now = targets()[1]->transform.position - targets()[0]->transform.position;
        QVERIFY(glm::distance(now, way) > 0.1f);
        QVERIFY(std::abs(glm::length(now) - glm::length(way)) < 1.0e-4f);
        QVERIFY(glm::distance(middleOfAll(), middle) < 0.5f * glm::length(way));
        QVERIFY(targets()[0]->transform.rotation == targets()[1]->transform.rotation);
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::RotateTarget, 2}));
        QCOMPARE(m_session->steps().size(), steps + 1);
        m_session->undo();
        QVERIFY(targets()[1]->transform.position - targets()[0]->transform.position == way);
    }

    void whatIsDynamicStaysInTheHand() {
        QVERIFY(targets().setPhysics(first().id, {.isDynamic = true}).ok());
        press("moveY");
        moveBy({0.0, -60.0});
        const float height = first().transform.position.y;
        QVERIFY(height > 0.1f);
        m_session->simulation().advance(0.2);
        QCOMPARE(first().transform.position.y, height);
        release();
        QTRY_VERIFY_WITH_TIMEOUT(first().transform.position.y < 0.5f * height, kPatience);
    }

    void whatGoesMeanwhileIsLetGo() {
        press("moveX");
        moveBy({30.0, 5.0});
        targets().remove({{first().id}});
        QVERIFY(!m_held->isHeld());
        QVERIFY(!m_held->isVisible());
        moveBy({60.0, 5.0});
        release();
        m_session->undo();
        QCOMPARE(targets().size(), std::size_t{1});
    }

    /// A scaling that was begun before ends: the target under the handles is another one.
    void whatIsReplacedMeanwhileIsLetGo() {
        const Result<ScaledTarget> scaled = scaledTo(first(), 2.0 * static_cast<double>(first().extent()));
        QVERIFY(scaled.ok());
        press("moveX");
        moveBy({30.0, 5.0});
        QVERIFY(takeScaled(*m_session, scaled.value()).ok());
        QVERIFY(!m_held->isHeld());
        QVERIFY(targets().isSelected(first().id));
        const RigidTransform now = first().transform;
        moveBy({60.0, 5.0});
        release();
        QVERIFY(first().transform == now);
    }

    /// Frames of a drag take as long as those before: what they may draw is not found out anew.
    void framesStayAsCoarseAsTheyAre() {
        PictureMotion& motion = viewport().pictures().motion();
        motion.setOn(true);
        motion.moved();
        for (int frame = 0; frame < 20; ++frame) {
            const auto scale = static_cast<double>(motion.beginFrame().scale);
            motion.frameShown(0.2 * scale * scale);
        }
        QVERIFY(motion.coming().scale < 1.0f);
        QVERIFY(targets().setTransform(first().id, {{0.0f, 1.0f, 0.0f}}).ok());
        QVERIFY(motion.coming().scale < 1.0f);
        targets().add({planMesh(makeLowPolyCube())});
        QCOMPARE(motion.coming().scale, 1.0f);
    }

private:
    Viewport& viewport() { return m_window->viewport(); }
    SessionTargets& targets() { return m_session->targets(); }
    const Target& first() const { return *m_session->targets().front(); }
    HandleGrip* grip(const QString& name) { return viewport().findChild<HandleGrip*>(name); }
    HandleGrip* grip(const char* name) { return grip(QString::fromLatin1(name)); }

    static double distance(const QPointF& a, const QPointF& b) {
        return std::hypot(a.x() - b.x(), a.y() - b.y());
    }
    /// Radians.
    static double turnOf(const Target& target) {
        const glm::quat& q = target.transform.rotation;
        return 2.0 * std::atan2(static_cast<double>(glm::length(glm::vec3(q.x, q.y, q.z))),
                                static_cast<double>(std::abs(q.w)));
    }
    glm::vec3 middleOfAll() {
        Bounds bounds;
        for (const auto& target : targets()) {
            bounds.add(target->worldBounds());
        }
        return bounds.centre();
    }
    QPointF placeOf(const glm::vec3& point) {
        const Camera& camera = viewport().camera();
        const glm::vec4 clip =
            camera.projection(viewport().navigation().aspect()) * camera.view() * glm::vec4(point, 1.0f);
        return {0.5 * (1.0 + static_cast<double>(clip.x / clip.w)) * viewport().width(),
                0.5 * (1.0 - static_cast<double>(clip.y / clip.w)) * viewport().height()};
    }

    void press(const QString& name) {
        m_held = grip(name);
        QTRY_VERIFY_WITH_TIMEOUT(m_held->isVisible(), kPatience);
        m_from = viewport().mapToGlobal(m_held->centre());
        mouse(QEvent::MouseButtonPress, m_from, {});
    }
    void moveBy(const QPointF& way, Qt::KeyboardModifiers keys = {}) {
        mouse(QEvent::MouseMove, m_from + way, keys);
    }
    void release() { mouse(QEvent::MouseButtonRelease, m_from, {}); }
    void drag(const QString& name, const QPointF& way, Qt::KeyboardModifiers keys = {}) {
        press(name);
        for (int step = 1; step <= 8; ++step) {
            moveBy(step / 8.0 * way, keys);
        }
        release();
    }
    void mouse(QEvent::Type type, const QPointF& global, Qt::KeyboardModifiers keys) {
        QMouseEvent event(type, m_held->mapFromGlobal(global), global,
                          type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, keys);
        QCoreApplication::sendEvent(m_held, &event);
    }

    HandleGrip* m_held = nullptr;
    QPointF m_from;  ///< on the screen
};

HITSCOPE_TEST(TargetHandlesTest, QApplication)

}  // namespace hitscope::target_handles_test

#include "target_handles_test.moc"
