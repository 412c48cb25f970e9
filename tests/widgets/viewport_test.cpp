// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and keys in the viewport.
#include <QApplication>
#include <QElapsedTimer>
#include <QProgressBar>
#include <QSignalSpy>
#include <QStatusBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "deform/reference.h"
#include "gl/context.h"
#include "mesh/primitives.h"
#include "mesh/render_mesh.h"
#include "session/prepared_mesh.h"
#include "session/target_plan.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "viewport/aim.h"
#include "widgets/window_support.h"

namespace hitscope::viewport_test {

namespace {

bool near(const glm::vec3& a, const glm::vec3& b, float distance = 1.0e-3f) {
    return glm::length(a - b) <= distance;
}

}  // namespace

class ViewportTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup() { dropWindow(); }
    void clickShootsWhereItPoints();
    void aimAllowsForTheFall();
    void dragOrbitsAndShootsNothing();
    void draggingFromTheFloorOrbitsTheTarget();
    void rightAndShiftDragPan();
    void wheelZooms();
    void middleClickRecentresAndShootsNothing_data();
    void middleClickRecentresAndShootsNothing();
    void twoQuickClicksAreTwoShots();
    void controlClickSelectsAndShootsNothing();
    void spaceShootsRepeatedlyWhileHeld();
    void flyKeysMoveWhileHeld();
    void smallerWhileItMoves();
    void framing();
    void aMeshBroughtBeforehandDents();
    void meshesOnTheirWayAreGivenUp();
    void manyHitsAreAppliedBetweenFrames();
    void progressIsNotPaintedInTheMiddleOfAFrame();
    void idleDrawsNothing();

private:
    [[nodiscard]] QPoint centre() const { return m_window->viewport().rect().center(); }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& by);
    [[nodiscard]] std::size_t flying() const { return m_session->simulation().physics().projectileCount(); }
};

void ViewportTest::init() {
    makeWindow();
}

void ViewportTest::drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& by) {
    Viewport& viewport = m_window->viewport();
    QTest::mousePress(&viewport, button, keys, centre());
    for (int step = 1; step <= 4; ++step) {
        const QPointF at = centre() + QPointF(by) * (step / 4.0);
        QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, button, keys);
        QCoreApplication::sendEvent(&viewport, &move);
    }
    QTest::mouseRelease(&viewport, button, keys, centre() + by);
}

void ViewportTest::clickShootsWhereItPoints() {
    const Viewport& viewport = m_window->viewport();
    const Camera& camera = viewport.camera();
    // Before: the dent would be in its way.
    const auto aimed = m_session->simulation().physics().castRay(camera.eye(), camera.forward(), 100.0f);
    QVERIFY(aimed.has_value());
    QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, centre());
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{1}, kPatience);
    const Hit& hit = m_session->hits().history().hits().front();
    QVERIFY(near(hit.point, aimed->point, 0.1f));
    QVERIFY(glm::dot(hit.direction, camera.forward()) > 0.97f);
}

void ViewportTest::aimAllowsForTheFall() {
    for (const glm::vec3& to :
         {glm::vec3(20.0f, 0.0f, 0.0f), glm::vec3(-15.0f, 6.0f, 30.0f), glm::vec3(0.0f, -40.0f, 25.0f)}) {
        const glm::dvec3 velocity = 30.0 * glm::dvec3(launchDirection({}, to, 30.0f, 9.81f));
        const double time = std::hypot(to.x, to.z) / std::hypot(velocity.x, velocity.z);
        const glm::dvec3 there = velocity * time - glm::dvec3(0.0, 0.5 * 9.81 * time * time, 0.0);
        QVERIFY(near(glm::vec3(there), to, 0.01f));
    }
    // Out of reach, or straight down: along the line.
    QVERIFY(near(launchDirection({}, {0.0f, 0.0f, -500.0f}, 30.0f, 9.81f), {0.0f, 0.0f, -1.0f}));
    QVERIFY(near(launchDirection({1.0f, 9.0f, 2.0f}, {1.0f, 0.0f, 2.0f}, 30.0f, 9.81f), {0.0f, -1.0f, 0.0f}));
}

void ViewportTest::dragOrbitsAndShootsNothing() {
    m_window->viewport().navigation().setOrbitMode(OrbitMode::Turntable);
    const Camera before = m_window->viewport().camera();
    drag(Qt::LeftButton, {}, {80, 30});
    const Camera& after = m_window->viewport().camera();
    QVERIFY(near(after.pivot(), before.pivot()));
    QVERIFY(std::abs(after.distance() - before.distance()) < 1.0e-3f);
    // The scene turns with the hand: dragged right and down, the eye goes left and up.
    QVERIFY(glm::dot(after.eye() - before.eye(), before.right()) < -0.1f);
    QVERIFY(after.eye().y > before.eye().y + 0.1f);
    QTest::qWait(500);
    QCOMPARE(flying(), std::size_t{0});
}

void ViewportTest::draggingFromTheFloorOrbitsTheTarget() {
    Viewport& viewport = m_window->viewport();
    const glm::vec3 centre = m_session->targets().bounds().centre();
    const auto placeOf = [&viewport](const glm::vec3& point) {
        const Camera& camera = viewport.camera();
        const glm::vec3 away = point - camera.eye();
        return glm::vec2(glm::dot(away, camera.right()), glm::dot(away, camera.up())) /
               glm::dot(away, camera.forward());
    };
    const QPoint floor(viewport.width() - 30, viewport.height() - 10);
    const auto met = m_session->simulation().physics().castRay(
        viewport.camera().eye(), viewport.navigation().rayAt(floor).direction, 1000.0f);
    QVERIFY(met && !met->target);
    const Camera before = viewport.camera();
    const glm::vec2 place = placeOf(centre);
    QTest::mousePress(&viewport, Qt::LeftButton, {}, floor);
    for (const QPoint& by : {QPoint(-60, -10), QPoint(-200, -20), QPoint(-400, -40)}) {
        const QPointF at = floor + by;
        QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&viewport, &move);
        QVERIFY(glm::length(placeOf(centre) - place) < 1.0e-3f);
    }
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, floor - QPoint(400, 40));
    QVERIFY(glm::dot(viewport.camera().forward(), before.forward()) < 0.9f);
}

void ViewportTest::rightAndShiftDragPan() {
    for (const auto& [button, keys] : {std::pair(Qt::RightButton, Qt::KeyboardModifiers()),
                                       std::pair(Qt::LeftButton, Qt::KeyboardModifiers(Qt::ShiftModifier))}) {
        const Camera before = m_window->viewport().camera();
        drag(button, keys, {60, -40});
        const Camera& after = m_window->viewport().camera();
        QVERIFY(near(after.forward(), before.forward(), 1.0e-4f));
        // What was under the cursor follows it: the pivot goes the other way.
        QVERIFY(glm::dot(after.pivot() - before.pivot(), before.right()) < -0.05f);
        QVERIFY(glm::dot(after.pivot() - before.pivot(), before.up()) < -0.05f);
    }
    QTest::qWait(500);
    QCOMPARE(flying(), std::size_t{0});
}

void ViewportTest::wheelZooms() {
    Viewport& viewport = m_window->viewport();
    const float before = viewport.camera().distance();
    const glm::vec3 eye = viewport.camera().eye();
    const auto turn = [&](int amount) {
        QWheelEvent event(centre(), viewport.mapToGlobal(centre()), {}, {0, amount}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&viewport, &event);
    };
    turn(120);
    const float nearer = viewport.camera().distance();
    QVERIFY(nearer < before);
    turn(-120);
    QVERIFY(near(viewport.camera().eye(), eye));
}

void ViewportTest::middleClickRecentresAndShootsNothing_data() {
    QTest::addColumn<NavigationPreset>("preset");
    QTest::newRow("Hitscope") << NavigationPreset::Hitscope;
    QTest::newRow("Blender") << NavigationPreset::Blender;
}

void ViewportTest::middleClickRecentresAndShootsNothing() {
    QFETCH(NavigationPreset, preset);
    Viewport& viewport = m_window->viewport();
    viewport.navigation().setPreset(preset);
    const Camera before = viewport.camera();
    const QPoint at = centre() + QPoint(40, -30);
    QTest::mouseClick(&viewport, Qt::MiddleButton, {}, at);
    QTRY_VERIFY_WITH_TIMEOUT(!near(viewport.camera().pivot(), before.pivot(), 0.1f), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!viewport.navigation().isMoving(), kPatience);
    QVERIFY(std::abs(glm::length(viewport.camera().pivot()) - 2.5f) < 0.1f);
    // A drag there and back is none.
    const glm::vec3 there = viewport.camera().pivot();
    drag(Qt::MiddleButton, {}, {80, 30});
    drag(Qt::MiddleButton, {}, {-80, -30});
    QTest::qWait(300);
    QVERIFY(!viewport.navigation().isMoving());
    QVERIFY(near(viewport.camera().pivot(), there, 0.05f));
    QCOMPARE(flying(), std::size_t{0});
    QCOMPARE(m_session->hits().history().size(), std::size_t{0});
}

void ViewportTest::twoQuickClicksAreTwoShots() {
    Viewport& viewport = m_window->viewport();
    const glm::vec3 before = viewport.camera().pivot();
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, centre());
    QCOMPARE(flying(), std::size_t{1});  // nothing is waited for
    // As the desktop sends a double click: the second press is called one.
    const QPoint aside = centre() + QPoint(2, 0);
    QTest::mouseDClick(&viewport, Qt::LeftButton, {}, aside);
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, aside);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->hits().history().size() >= 2, kPatience);
    QVERIFY(near(viewport.camera().pivot(), before));
}

void ViewportTest::spaceShootsRepeatedlyWhileHeld() {
    Viewport& viewport = m_window->viewport();
    const QSignalSpy shots(&viewport, &Viewport::shot);
    QTest::keyPress(&viewport, Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(shots.size() >= 3, kPatience);
    QTest::keyRelease(&viewport, Qt::Key_Space);
    const qsizetype shot = shots.size();
    QTest::qWait(qRound(4000.0f / m_session->settings().projectile().rateOfFire));
    QCOMPARE(shots.size(), shot);
}

void ViewportTest::controlClickSelectsAndShootsNothing() {
    Viewport& viewport = m_window->viewport();
    m_session->targets().select({});
    QTest::mouseClick(&viewport, Qt::LeftButton, Qt::ControlModifier, centre());
    QCOMPARE(m_session->targets().selected(), m_session->targets().front()->id);
    QTest::mouseClick(&viewport, Qt::LeftButton, Qt::ControlModifier, {4, 4});
    QVERIFY(!m_session->targets().selected());
    for (const std::size_t selected : {1, 0}) {
        QTest::mouseClick(&viewport, Qt::LeftButton, Qt::ControlModifier | Qt::ShiftModifier, centre());
        QCOMPARE(m_session->targets().allSelected().size(), selected);
    }
    QTest::qWait(500);
    QCOMPARE(flying(), std::size_t{0});
    QCOMPARE(m_session->hits().history().size(), std::size_t{0});
}

void ViewportTest::flyKeysMoveWhileHeld() {
    Viewport& viewport = m_window->viewport();
    const Camera before = viewport.camera();
    QTest::keyPress(&viewport, Qt::Key_D);
    QTRY_VERIFY_WITH_TIMEOUT(glm::dot(viewport.camera().eye() - before.eye(), before.right()) > 0.2f,
                             kPatience);
    QTest::keyRelease(&viewport, Qt::Key_D);
    const glm::vec3 there = viewport.camera().eye();
    QTest::qWait(300);
    QVERIFY(near(viewport.camera().eye(), there));
}

/// Where frames take too long, the picture is drawn smaller while it moves, and in full size when it rests.
void ViewportTest::smallerWhileItMoves() {
    Viewport& viewport = m_window->viewport();
    viewport.pictures().motion().hold(PictureDetail{.scale = 0.5f});
    const auto scalesUntilRest = [&] {
        QTest::keyPress(&viewport, Qt::Key_D);
        float least = 1.0f;
        QSignalSpy frames(&viewport.pictures(), &PictureFlow::framePainted);
        while (frames.size() < 4 && frames.wait(kPatience)) {
            least = std::min(least, viewport.pictures().motion().lastDetail().scale);
        }
        QTest::keyRelease(&viewport, Qt::Key_D);
        return least;
    };
    QCOMPARE(scalesUntilRest(), 1.0f);  // turned off in tests
    DisplayOptions options = viewport.options();
    options.reduceInMotion = true;
    viewport.setOptions(options);
    QCOMPARE(scalesUntilRest(), 0.5f);
    QTRY_COMPARE_WITH_TIMEOUT(viewport.pictures().motion().lastDetail().scale, 1.0f, kPatience);
    // A frame alone is no motion, and what is measured has its full size.
    viewport.wantPicture();
    QSignalSpy frames(&viewport.pictures(), &PictureFlow::framePainted);
    QVERIFY(frames.wait(kPatience));
    QCOMPARE(viewport.pictures().motion().lastDetail().scale, 1.0f);
    viewport.setDrawsContinuously(true);
    QCOMPARE(scalesUntilRest(), 1.0f);
    viewport.setDrawsContinuously(false);
}

void ViewportTest::framing() {
    Viewport& viewport = m_window->viewport();
    const Camera before = viewport.camera();
    viewport.navigation().flyStep({3.0f, 1.0f, 2.0f});
    QVERIFY(!near(viewport.camera().pivot(), before.pivot(), 0.1f));
    QTest::keyClick(m_window.get(), Qt::Key_F);
    QTRY_VERIFY_WITH_TIMEOUT(!viewport.navigation().isMoving(), kPatience);
    QVERIFY(near(viewport.camera().pivot(), before.pivot()));
    QVERIFY(std::abs(viewport.camera().distance() - before.distance()) < 0.05f);
}

/// Another thread with a context of its own may have filled its buffers.
void ViewportTest::aMeshBroughtBeforehandDents() {
    const PreparedMesh mesh = prepareMesh(makeUvSphere(400, 300, 2.0f));
    const ScenePlan plan{.name = {}, .targets = {planMesh(mesh)}};
    QVERIFY(!m_window->viewport().scene().bringMeshes(plan));  // begun
    QTRY_VERIFY_WITH_TIMEOUT(m_window->viewport().scene().bringMeshes(plan), kPatience);
    loadMesh(*m_session, mesh);
    std::vector<Hit> hits(5);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        hits[i].target = m_session->targets().front()->id;
        hits[i].point = {0.3f * static_cast<float>(i), 0.0f, 2.0f};
        hits[i].direction = {0.0f, 0.0f, -1.0f};
    }
    QVERIFY(m_session->hits().add(hits).ok());
    QVERIFY(m_window->viewport().syncNow().ok());
    const DeformedMesh& deformed = m_session->targets().front()->deformed;
    ReferenceDeformation reference(deformed.render());
    reference.apply(m_session->hits().history().hits());
    std::size_t moved = 0;
    for (std::size_t i = 0; i < reference.vertices().size(); ++i) {
        const glm::vec3& position = deformed.vertices()[i].position;
        QVERIFY(glm::distance(position, reference.vertices()[i].position) < 1.0e-5f);
        moved += position != deformed.render().vertices[i].position ? 1 : 0;
    }
    QVERIFY(moved > 100);
}

void ViewportTest::meshesOnTheirWayAreGivenUp() {
    for (int time = 0; time < 8; ++time) {
        const ScenePlan plan{.name = {}, .targets = {planMesh(makeUvSphere(500, 300, 2.0f))}};
        const std::shared_ptr<const RenderMesh>& mesh = plan.targets.front().shape.render;
        const long holders = mesh.use_count();
        QVERIFY(!m_window->viewport().scene().bringMeshes(plan));
        QVERIFY(mesh.use_count() > holders);
        QTest::qWait(time);
        m_window->viewport().scene().dropUnusedMeshes();
        QCOMPARE(mesh.use_count(), holders);
    }
    const ScenePlan plan{.name = {}, .targets = {planMesh(makeUvSphere(500, 300, 2.0f))}};
    QVERIFY(!m_window->viewport().scene().bringMeshes(plan));
    m_window.reset();  // meanwhile
}

/// The CPU that draws also applies them: a frame for each few hits would take most of its time.
void ViewportTest::manyHitsAreAppliedBetweenFrames() {
    m_window->viewport().surface().makeCurrent();
    const bool software = gl::rendererInfo().isSoftware();
    m_window->viewport().surface().doneCurrent();
    if (!software) {
        QSKIP("a GPU's frames cost next to nothing: it applies them there");
    }
    constexpr int kMany = 10'000;  // in frames alone 512 at most would be applied in each
    std::vector<Hit> hits(kMany);
    for (int i = 0; i < kMany; ++i) {
        const auto angle = static_cast<float>(i);
        hits[i].target = m_session->targets().front()->id;
        hits[i].point = {2.0f * std::sin(0.1f * angle), 2.0f * std::cos(0.07f * angle), 2.5f};
        hits[i].direction = {0.0f, 0.0f, -1.0f};
        hits[i].constants = {.maxDistance = 0.3f, .power = 0.002f, .maxMagnitude = 0.01f};
    }
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().size() == 0, kPatience);
    const QSignalSpy frames(&m_window->viewport().pictures(), &PictureFlow::framePainted);
    QElapsedTimer clock;
    clock.start();
    QVERIFY(m_session->hits().add(hits).ok());
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().size() > 0, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().size() == 0, kPatience);
    const qint64 most = clock.elapsed() / 500 + 5;
    QVERIFY2(frames.size() <= most, qPrintable(QString::number(frames.size())));
}

/// What is applied in a frame says how far it has come: painting that there would take the context away.
void ViewportTest::progressIsNotPaintedInTheMiddleOfAFrame() {
    TaskProgress progress(m_session->tasks(), QStringLiteral("Applying"));
    progress.report(0.1);
    auto* bar = m_window->statusBar()->findChild<QProgressBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar != nullptr && bar->isVisible(), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(bar->value(), 10, kPatience);
    progress.report(0.9);
    QCOMPARE(bar->value(), 10);
    QTRY_COMPARE_WITH_TIMEOUT(bar->value(), 90, kPatience);
}

void ViewportTest::idleDrawsNothing() {
    Viewport& viewport = m_window->viewport();
    QSignalSpy frames(&viewport.pictures(), &PictureFlow::framePainted);
    do {
        frames.clear();
        QTest::qWait(150);
    } while (!frames.isEmpty());  // a busy machine is not idle at once
    QTest::qWait(500);
    QVERIFY(frames.size() <= 1);
    viewport.setDrawsContinuously(true);
    QTRY_VERIFY_WITH_TIMEOUT(frames.size() > 10, kPatience);
    viewport.setDrawsContinuously(false);
}

HITSCOPE_TEST(ViewportTest, QApplication)

}  // namespace hitscope::viewport_test

#include "viewport_test.moc"
