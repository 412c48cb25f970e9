// SPDX-License-Identifier: GPL-3.0-or-later
// The scene stays in the picture whatever mouse and wheel do.
#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "support/test_program.h"
#include "viewport/navigation.h"

namespace hitscope::navigation_scene_test {

namespace {

constexpr QSizeF kSize(800, 600);

/// A ball that stands on the floor, y = 0.
struct Ball {
    glm::vec3 centre{0.0f};
    float radius = 1.0f;

    [[nodiscard]] std::optional<glm::vec3> metBy(const Ray& ray) const {
        const glm::vec3 to = centre - ray.origin;
        const float along = glm::dot(to, ray.direction);
        const float beside = glm::length(to - along * ray.direction);
        if (beside > radius) {
            return std::nullopt;
        }
        const float half = std::sqrt(radius * radius - beside * beside);
        const float at = along > half ? along - half : along + half;
        return at > 0.0f ? std::optional(ray.origin + at * ray.direction) : std::nullopt;
    }
    [[nodiscard]] Bounds bounds() const {
        Bounds bounds;
        bounds.add(centre - glm::vec3(radius));
        bounds.add(centre + glm::vec3(radius));
        return bounds;
    }
};

Ball ballOf(float radius, const glm::vec3& beside = {}) {
    return {beside + glm::vec3(0.0f, radius, 0.0f), radius};
}

}  // namespace

class NavigationSceneTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void boxesInThePicture();
    void neverLosesTheScene_data();
    void neverLosesTheScene();
    void orbitFromTheVoidKeepsTheTargetWhereItIs();
    void selectedTargetIsWhatOneOrbits();
    void wheelZoomsAtThePointUnderTheCursor();
    void wheelStaysAboveTheFloorAndBeforeTheTarget();
    void lookingAroundIsFree();

private:
    void make(std::vector<Ball> balls);
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPointF& from, const QPointF& by);
    void wheel(const QPointF& at, int amount, Qt::KeyboardModifiers keys = {});
    [[nodiscard]] const Camera& camera() const { return m_navigation->camera(); }
    [[nodiscard]] QPointF placeOf(const glm::vec3& point) const;
    [[nodiscard]] bool seesABall() const;

    std::vector<Ball> m_balls;
    std::optional<std::size_t> m_selected;
    std::unique_ptr<Navigation> m_navigation;
};

void NavigationSceneTest::make(std::vector<Ball> balls) {
    m_balls = std::move(balls);
    m_selected.reset();
    m_navigation = std::make_unique<Navigation>(
        [this](const QPointF& at) {
            const Ray ray = m_navigation->rayAt(at);
            std::optional<glm::vec3> nearest;
            for (const Ball& ball : m_balls) {
                const auto met = ball.metBy(ray);
                if (met &&
                    (!nearest || glm::distance(*met, ray.origin) < glm::distance(*nearest, ray.origin))) {
                    nearest = met;
                }
            }
            return nearest;
        },
        [this] {
            SceneInSight scene;
            for (const Ball& ball : m_balls) {
                scene.targets.push_back(ball.bounds());
            }
            scene.selected = m_selected;
            scene.floor = 0.0f;
            return scene;
        });
    Bounds all;
    for (const Ball& ball : m_balls) {
        all.add(ball.bounds());
    }
    m_navigation->setViewSize(kSize);
    m_navigation->setSceneRadius(all.diagonal());
    m_navigation->frame(all, Navigation::Arrival::AtOnce);
}

void NavigationSceneTest::drag(Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPointF& from,
                               const QPointF& by) {
    m_navigation->press({QEvent::MouseButtonPress, from, from, button, button, keys});
    for (int step = 1; step <= 5; ++step) {
        const QPointF at = from + by * (step / 5.0);
        m_navigation->move({QEvent::MouseMove, at, at, Qt::NoButton, button, keys});
    }
    m_navigation->release({QEvent::MouseButtonRelease, from + by, from + by, button, Qt::NoButton, keys});
}

void NavigationSceneTest::wheel(const QPointF& at, int amount, Qt::KeyboardModifiers keys) {
    m_navigation->wheel({at, at, {}, {0, amount}, Qt::NoButton, keys, Qt::NoScrollPhase, false});
}

QPointF NavigationSceneTest::placeOf(const glm::vec3& point) const {
    const float aspect = m_navigation->aspect();
    const glm::vec4 clip = camera().projection(aspect) * camera().view() * glm::vec4(point, 1.0f);
    return {0.5 * kSize.width() * static_cast<double>(1.0f + clip.x / clip.w),
            0.5 * kSize.height() * static_cast<double>(1.0f - clip.y / clip.w)};
}

bool NavigationSceneTest::seesABall() const {
    const auto isShown = [this](const glm::vec3& point) {
        const QPointF place = placeOf(point);
        return glm::dot(point - camera().eye(), camera().forward()) > 0.0f &&
               QRectF({}, kSize).contains(place);
    };
    for (const Ball& ball : m_balls) {
        if (isShown(ball.centre)) {
            return true;
        }
    }
    // Near one, its middle may be beside the picture.
    constexpr int kSteps = 40;
    for (int y = 0; y <= kSteps; ++y) {
        for (int x = 0; x <= kSteps; ++x) {
            const Ray ray = m_navigation->rayAt({x * kSize.width() / kSteps, y * kSize.height() / kSteps});
            for (const Ball& ball : m_balls) {
                if (ball.metBy(ray)) {
                    return true;
                }
            }
        }
    }
    return false;
}

void NavigationSceneTest::boxesInThePicture() {
    Camera camera;
    camera.setSceneRadius(100.0f);
    camera.setPivot({0, 0, 0}, 0.0f, 0.0f, 10.0f);  // the eye at z = 10, half the picture's height is 4.66 m
    const auto box = [](const glm::vec3& centre, float half) {
        Bounds bounds;
        bounds.add(centre - glm::vec3(half));
        bounds.add(centre + glm::vec3(half));
        return bounds;
    };
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        camera.setProjection(projection);
        QVERIFY(isInPicture(box({0, 0, 0}, 1.0f), camera, 1.0f, 1.0f));
        QVERIFY(isInPicture(box({5.0f, 0, 0}, 1.0f), camera, 1.0f, 1.0f));
        QVERIFY(!isInPicture(box({5.0f, 0, 0}, 1.0f), camera, 1.0f, 0.5f));
        QVERIFY(!isInPicture(box({0, 9.0f, 0}, 1.0f), camera, 1.0f, 1.0f));
        QVERIFY(isInPicture(box({0, 0, 0}, 90.0f), camera, 1.0f, 1.0f));  // the eye is in it
        QVERIFY(!isInPicture(Bounds(), camera, 1.0f, 1.0f));
    }
    camera.setProjection(Projection::Perspective);
    QVERIFY(!isInPicture(box({0, 0, 20.0f}, 1.0f), camera, 1.0f, 1.0f));  // behind the eye
    // Across a corner: each side of the picture's pyramid has some of the box within, and yet it is beside.
    Bounds slab;
    slab.add(glm::vec3(4.0f, -20.0f, -40.0f));
    slab.add(glm::vec3(80.0f, -19.0f, 9.0f));
    QCOMPARE(isInPicture(slab, camera, 1.0f, 1.0f), true);
    slab.min.x = 23.5f;
    QCOMPARE(isInPicture(slab, camera, 1.0f, 1.0f), false);
}

void NavigationSceneTest::neverLosesTheScene_data() {
    QTest::addColumn<float>("radius");
    QTest::addColumn<int>("projection");
    QTest::addColumn<int>("mode");
    for (const float radius : {0.0005f, 1.0f, 40'000.0f}) {
        for (int projection = 0; projection < 2; ++projection) {
            for (const OrbitMode mode : {OrbitMode::Point, OrbitMode::Turntable}) {
                QTest::addRow("radius %g, projection %d, mode %d", static_cast<double>(radius), projection,
                              static_cast<int>(mode))
                    << radius << projection << static_cast<int>(mode);
            }
        }
    }
}

void NavigationSceneTest::neverLosesTheScene() {
    QFETCH(float, radius);
    QFETCH(int, projection);
    QFETCH(int, mode);
    std::mt19937 random(7);
    const auto number = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int run = 0; run < 6; ++run) {
        make({ballOf(radius), ballOf(0.5f * radius, {4.0f * radius, 0.0f, 2.0f * radius})});
        m_navigation->setProjection(static_cast<Projection>(projection));
        m_navigation->setOrbitMode(static_cast<OrbitMode>(mode));
        for (int step = 0; step < 40; ++step) {
            const QPointF at(number(0.0, kSize.width()), number(0.0, kSize.height()));
            const QPointF by(number(-700.0, 700.0), number(-500.0, 500.0));
            const float height = camera().eye().y;
            switch (random() % 5) {
                case 0:
                    drag(Qt::LeftButton, {}, at, by);
                    break;
                case 1:
                    drag(Qt::RightButton, {}, at, by);
                    break;
                case 2:
                    wheel(at, 120, Qt::ShiftModifier);
                    break;
                default:
                    wheel(at, static_cast<int>(number(-2400.0, 2400.0)));
                    if (height >= 0.0f && projection == 0) {
                        QVERIFY(camera().eye().y >= 0.0f);
                    }
            }
            QVERIFY(seesABall());
            QVERIFY(m_navigation->isSceneInSight());
        }
    }
}

void NavigationSceneTest::orbitFromTheVoidKeepsTheTargetWhereItIs() {
    make({ballOf(1.0f)});
    const QPointF before = placeOf(m_balls[0].centre);
    drag(Qt::LeftButton, {}, {20.0, 580.0}, {300.0, -60.0});
    QVERIFY((placeOf(m_balls[0].centre) - before).manhattanLength() < 0.5);
    // Beside the middle it stays as well.
    drag(Qt::RightButton, {}, {400.0, 300.0}, {150.0, 80.0});
    const QPointF aside = placeOf(m_balls[0].centre);
    QVERIFY((aside - before).manhattanLength() > 100.0);
    drag(Qt::LeftButton, {}, {20.0, 580.0}, {300.0, 60.0});
    QVERIFY((placeOf(m_balls[0].centre) - aside).manhattanLength() < 0.5);
}

void NavigationSceneTest::selectedTargetIsWhatOneOrbits() {
    make({ballOf(1.0f), ballOf(1.0f, {6.0f, 0.0f, 0.0f})});
    for (const std::size_t selected : {std::size_t{0}, std::size_t{1}}) {
        m_selected = selected;
        const QPointF before = placeOf(m_balls[selected].centre);
        drag(Qt::LeftButton, {}, {20.0, 580.0}, {100.0, 0.0});
        QVERIFY((placeOf(m_balls[selected].centre) - before).manhattanLength() < 0.5);
        QVERIFY((placeOf(m_balls[1 - selected].centre) - before).manhattanLength() > 50.0);
    }
}

void NavigationSceneTest::wheelZoomsAtThePointUnderTheCursor() {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        make({ballOf(1.0f)});
        m_navigation->setProjection(projection);
        const QPointF at(470.0, 250.0);
        const glm::vec3 point = *m_balls[0].metBy(m_navigation->rayAt(at));
        const float before = camera().heightAt(glm::dot(point - camera().eye(), camera().forward()));
        const Camera start = camera();
        wheel(at, 600);
        QVERIFY((placeOf(point) - at).manhattanLength() < 0.5);
        const float after = camera().heightAt(glm::dot(point - camera().eye(), camera().forward()));
        QVERIFY(std::abs(after / before - std::pow(0.88f, 5.0f)) < 1.0e-3f);
        wheel(at, -600);
        QVERIFY(glm::distance(camera().eye(), start.eye()) < 1.0e-3f * start.distance());
    }
}

void NavigationSceneTest::wheelStaysAboveTheFloorAndBeforeTheTarget() {
    make({ballOf(1.0f)});
    const QPointF middle(400.0, 300.0);
    for (int notch = 0; notch < 200; ++notch) {
        wheel(middle, 120);
        QVERIFY(glm::distance(camera().eye(), m_balls[0].centre) > 0.999f * m_balls[0].radius);
        QVERIFY(camera().eye().y > 0.0f);
    }
    // From below a ball's middle, looking up and going away: along the floor.
    make({ballOf(1.0f)});
    drag(Qt::LeftButton, {}, {20.0, 580.0}, {0.0, -100.0});
    QVERIFY(camera().pitch() < -0.1f && camera().eye().y > 0.0f);
    for (int notch = 0; notch < 40; ++notch) {
        wheel(middle, -120);
        QVERIFY(camera().eye().y >= 0.0f);
        QVERIFY(seesABall());
    }
    QVERIFY(camera().distance() > 20.0f);
}

void NavigationSceneTest::lookingAroundIsFree() {
    make({ballOf(1.0f)});
    m_navigation->setOrbitMode(OrbitMode::Fly);
    for (int turn = 0; turn < 3; ++turn) {
        drag(Qt::LeftButton, {}, {100.0, 300.0}, {600.0, 0.0});
    }
    QVERIFY(!m_navigation->isSceneInSight());
    // Whoever has lost it may go on, and frames it again.
    drag(Qt::RightButton, {}, {100.0, 300.0}, {60.0, 0.0});
    m_navigation->frame(m_balls[0].bounds(), Navigation::Arrival::AtOnce);
    QVERIFY(m_navigation->isSceneInSight());
}

HITSCOPE_TEST(NavigationSceneTest, QApplication)

}  // namespace hitscope::navigation_scene_test

#include "navigation_scene_test.moc"
