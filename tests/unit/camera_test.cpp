// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/camera.h"

#include <QTest>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "physics_support.h"
#include "support/test_program.h"
#include "view/camera_text.h"
#include "view/lights.h"

namespace hitscope::camera_test {

using namespace test;

namespace {

glm::vec3 project(const Camera& camera, float aspect, const glm::vec3& point) {
    const glm::vec4 clip = camera.projection(aspect) * camera.view() * glm::vec4(point, 1.0f);
    return glm::vec3(clip) / clip.w;
}

bool isNear(const glm::vec3& a, const glm::vec3& b, float tolerance) {
    return glm::length(a - b) <= tolerance;
}

Camera someCamera(Random& random, Projection projection) {
    Camera camera;
    camera.setSceneRadius(20.0f);
    camera.setProjection(projection);
    camera.setPivot(10.0f * random.direction(), random.between(-3, 3), random.between(-1.4f, 1.4f),
                    random.between(1, 30));
    return camera;
}

}  // namespace

class CameraTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void axesAreAFrame();
    void rayGoesThroughWhatProjectsThere();
    void pivotIsInTheMiddle();
    void framesTheWholeBox();
    void framesAPoint();
    void panFollowsTheCursor();
    void orbitKeepsTheDistanceAndStopsAtThePoles();
    void zoomKeepsWithinLimits();
    void flyMovesTheEye();
    void recentreKeepsDirectionAndDistance();
    void orthographicRayGoesThroughWhatProjectsThere();
    void projectionsAgreeAtThePivot();
    void orthographicFramesTheWholeBox();
    void orbitAboutAPointKeepsItInPlace();
    void lookKeepsTheEye();
    void textGivesTheSameCamera();
    void textSaysWhatIsWrong_data();
    void textSaysWhatIsWrong();
    void planesHoldTheScene_data();
    void planesHoldTheScene();
    void defaultLightsFollowTheScene();
};

void CameraTest::axesAreAFrame() {
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        Camera camera;
        camera.setPivot(random.direction(), random.between(-7, 7), random.between(-1.5f, 1.5f), 3.0f);
        QVERIFY(isNear(glm::cross(camera.right(), camera.up()), -camera.forward(), 1e-5f));
        QVERIFY(std::abs(glm::length(camera.forward()) - 1.0f) < 1e-5f);
        QVERIFY(std::abs(camera.right().y) < 1e-6f && camera.up().y > 0.0f);
        QVERIFY(isNear(camera.eye() + 3.0f * camera.forward(), camera.pivot(), 1e-5f));
    }
}

void CameraTest::rayGoesThroughWhatProjectsThere() {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        const float aspect = random.between(0.4f, 2.5f);
        camera.setPivot(10.0f * random.direction(), random.between(-4, 4), random.between(-1.5f, 1.5f),
                        random.between(1, 30));
        const glm::vec2 ndc(random.between(-1, 1), random.between(-1, 1));
        const Ray ray = camera.rayThrough(ndc, aspect);
        QVERIFY(std::abs(glm::length(ray.direction) - 1.0f) < 1e-5f);
        const glm::vec3 seen = project(camera, aspect, ray.origin + random.between(2, 40) * ray.direction);
        QVERIFY(std::abs(seen.x - ndc.x) < 1e-3f && std::abs(seen.y - ndc.y) < 1e-3f);
        QVERIFY(seen.z > -1.0f && seen.z < 1.0f);
    }
}

void CameraTest::pivotIsInTheMiddle() {
    Camera camera;
    camera.setPivot({3, 4, 5}, 1.0f, 0.3f, 12.0f);
    const glm::vec3 seen = project(camera, 1.5f, camera.pivot());
    QVERIFY(std::abs(seen.x) < 1e-5f && std::abs(seen.y) < 1e-5f);
    // Yaw zero looks along -z, with x to the right.
    camera.setPivot({0, 0, 0}, 0.0f, 0.0f, 5.0f);
    QVERIFY(isNear(camera.eye(), {0, 0, 5}, 1e-6f) && isNear(camera.right(), {1, 0, 0}, 1e-6f));
    // A positive pitch looks down from above.
    camera.setPivot({0, 0, 0}, 0.0f, 0.5f, 5.0f);
    QVERIFY(camera.eye().y > 2.0f);
}

void CameraTest::framesTheWholeBox() {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        Bounds bounds;
        bounds.add(20.0f * random.direction());
        bounds.add(20.0f * random.direction());
        const float aspect = random.between(0.4f, 2.5f);
        Camera camera;
        camera.setSceneRadius(bounds.diagonal());
        camera.orbit(random.between(-4, 4), random.between(-2, 2));
        camera.frame(bounds, aspect);
        float largest = 0.0f;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 point((corner & 1) != 0 ? bounds.min.x : bounds.max.x,
                                  (corner & 2) != 0 ? bounds.min.y : bounds.max.y,
                                  (corner & 4) != 0 ? bounds.min.z : bounds.max.z);
            const glm::vec3 seen = project(camera, aspect, point);
            largest = std::max({largest, std::abs(seen.x), std::abs(seen.y)});
            QVERIFY(std::abs(seen.x) <= 1.0f && std::abs(seen.y) <= 1.0f && std::abs(seen.z) < 1.0f);
        }
        // And it fills it.
        QVERIFY2(largest > 0.85f, qPrintable(QString::number(largest)));
    }
}

void CameraTest::framesAPoint() {
    Camera camera;
    Bounds bounds;
    bounds.add({1, 2, 3});
    camera.frame(bounds, 1.0f);
    QVERIFY(isNear(camera.pivot(), {1, 2, 3}, 0.0f) && camera.distance() > 0.0f);
    camera.frame(Bounds{}, 1.0f);
    QVERIFY(isNear(camera.pivot(), {0, 0, 0}, 0.0f) && camera.distance() > 0.0f);
}

void CameraTest::panFollowsTheCursor() {
    Random random(4);
    for (int i = 0; i < 50; ++i) {
        Camera camera;
        const float aspect = random.between(0.5f, 2);
        camera.setPivot(random.direction(), random.between(-4, 4), random.between(-1.4f, 1.4f), 8.0f);
        const glm::vec3 held = camera.pivot();
        // The cursor moves by fractions of the picture's height; y up.
        const glm::vec2 delta(random.between(-0.4f, 0.4f), random.between(-0.4f, 0.4f));
        camera.pan(delta);
        const glm::vec3 seen = project(camera, aspect, held);
        QVERIFY(std::abs(seen.x - 2.0f * delta.x / aspect) < 1e-4f);
        QVERIFY(std::abs(seen.y - 2.0f * delta.y) < 1e-4f);
    }
}

void CameraTest::orbitKeepsTheDistanceAndStopsAtThePoles() {
    Camera camera;
    camera.setPivot({1, 2, 3}, 0.0f, 0.0f, 6.0f);
    for (int i = 0; i < 100; ++i) {
        camera.orbit(0.3f, 0.2f);
        QVERIFY(std::abs(glm::length(camera.eye() - camera.pivot()) - 6.0f) < 1e-4f);
        QVERIFY(camera.up().y > 0.0f);
    }
    QVERIFY(camera.forward().y < -0.99f);
    for (int i = 0; i < 100; ++i) {
        camera.orbit(0.0f, -0.2f);
    }
    QVERIFY(camera.forward().y > 0.99f && camera.up().y > 0.0f);
}

void CameraTest::zoomKeepsWithinLimits() {
    Camera camera;
    camera.setSceneRadius(20.0f);
    camera.setPivot({0, 0, 0}, 0, 0, 10.0f);
    camera.zoom(0.5f);
    QCOMPARE(camera.distance(), 5.0f);
    for (int i = 0; i < 200; ++i) {
        camera.zoom(0.5f);
    }
    QVERIFY(camera.distance() > 0.0f && camera.distance() < 0.1f);
    for (int i = 0; i < 200; ++i) {
        camera.zoom(2.0f);
    }
    QVERIFY(camera.distance() > 100.0f && camera.distance() < 1000.0f);
}

void CameraTest::flyMovesTheEye() {
    Camera camera;
    const glm::vec3 from = camera.eye();
    const glm::vec3 forward = camera.forward();
    camera.fly({1, 2, 3});
    QVERIFY(isNear(camera.eye(), from + camera.right() + 2.0f * camera.up() + 3.0f * forward, 1e-5f));
    QVERIFY(isNear(camera.forward(), forward, 1e-6f));
}

void CameraTest::recentreKeepsDirectionAndDistance() {
    Camera camera;
    const glm::vec3 forward = camera.forward();
    const float distance = camera.distance();
    camera.recentre({5, 6, 7});
    QVERIFY(isNear(camera.forward(), forward, 1e-6f));
    QCOMPARE(camera.distance(), distance);
    QVERIFY(isNear(camera.eye(), glm::vec3(5, 6, 7) - forward * distance, 1e-5f));
}

void CameraTest::orthographicRayGoesThroughWhatProjectsThere() {
    Random random(12);
    for (int i = 0; i < 200; ++i) {
        const Camera camera = someCamera(random, Projection::Orthographic);
        const float aspect = random.between(0.4f, 2.5f);
        const glm::vec2 ndc(random.between(-1, 1), random.between(-1, 1));
        const Ray ray = camera.rayThrough(ndc, aspect);
        QVERIFY(isNear(ray.direction, camera.forward(), 1e-6f));
        for (const float along : {0.1f, 0.5f, 1.0f, 1.4f}) {
            const float reach = glm::dot(camera.pivot() - ray.origin, ray.direction);
            QVERIFY(reach > 2.0f * camera.sceneRadius());
            const glm::vec3 seen = project(camera, aspect, ray.origin + along * reach * ray.direction);
            QVERIFY(std::abs(seen.x - ndc.x) < 2e-3f && std::abs(seen.y - ndc.y) < 2e-3f);
            QVERIFY(seen.z > -1.001f && seen.z < 1.0f);
        }
        // And back: what is in the picture is met by the ray through its place there.
        const glm::vec3 point = camera.pivot() + 0.4f * camera.heightAt(0.0f) * random.direction();
        const glm::vec3 seen = project(camera, aspect, point);
        const Ray back = camera.rayThrough({seen.x, seen.y}, aspect);
        const glm::vec3 way = point - back.origin;
        const glm::vec3 off = way - glm::dot(way, back.direction) * back.direction;
        QVERIFY(glm::length(off) < 1e-3f * camera.distance());
    }
}

void CameraTest::projectionsAgreeAtThePivot() {
    Random random(13);
    for (int i = 0; i < 50; ++i) {
        Camera camera = someCamera(random, Projection::Perspective);
        const glm::vec3 aside = 0.2f * camera.distance() * (camera.right() + camera.up());
        const glm::vec3 perspective = project(camera, 1.5f, camera.pivot() + aside);
        camera.setProjection(Projection::Orthographic);
        const glm::vec3 orthographic = project(camera, 1.5f, camera.pivot() + aside);
        QVERIFY(isNear({perspective.x, perspective.y, 0}, {orthographic.x, orthographic.y, 0}, 1e-4f));
        QCOMPARE(camera.heightAt(1.0f), camera.heightAt(camera.distance()));
    }
}

void CameraTest::orthographicFramesTheWholeBox() {
    Random random(14);
    for (int i = 0; i < 100; ++i) {
        Bounds bounds;
        bounds.add(20.0f * random.direction());
        bounds.add(20.0f * random.direction());
        Camera camera = someCamera(random, Projection::Orthographic);
        camera.setSceneRadius(bounds.diagonal());
        camera.frame(bounds, 1.4f);
        float largest = 0.0f;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 point((corner & 1) != 0 ? bounds.min.x : bounds.max.x,
                                  (corner & 2) != 0 ? bounds.min.y : bounds.max.y,
                                  (corner & 4) != 0 ? bounds.min.z : bounds.max.z);
            const glm::vec3 seen = project(camera, 1.4f, point);
            largest = std::max({largest, std::abs(seen.x), std::abs(seen.y)});
            QVERIFY(std::abs(seen.z) < 1.0f);
        }
        QVERIFY2(largest > 0.9f && largest < 1.0f, qPrintable(QString::number(largest)));
    }
}

void CameraTest::orbitAboutAPointKeepsItInPlace() {
    Random random(15);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        for (int i = 0; i < 100; ++i) {
            Camera camera = someCamera(random, projection);
            const glm::vec3 point = camera.pivot() + 0.3f * camera.distance() * random.direction();
            const glm::vec3 before = project(camera, 1.5f, point);
            const float yaw = camera.yaw();
            camera.orbitAbout(point, random.between(-1, 1), random.between(-0.1f, 0.1f));
            const glm::vec3 after = project(camera, 1.5f, point);
            QVERIFY(isNear(before, after, 1e-3f));
            QVERIFY(camera.yaw() != yaw);
            QVERIFY(std::abs(camera.right().y) < 1e-6f);
        }
    }
}

void CameraTest::lookKeepsTheEye() {
    Random random(16);
    Camera camera = someCamera(random, Projection::Perspective);
    const glm::vec3 eye = camera.eye();
    camera.look(0.4f, -0.2f);
    QVERIFY(isNear(camera.eye(), eye, 1e-4f));
    QVERIFY(isNear(camera.eye() + camera.distance() * camera.forward(), camera.pivot(), 1e-4f));
}

void CameraTest::textGivesTheSameCamera() {
    Random random(17);
    for (int i = 0; i < 500; ++i) {
        Camera camera = someCamera(random, i % 2 == 0 ? Projection::Perspective : Projection::Orthographic);
        camera.setFieldOfView(random.between(0.1f, 2.0f));
        const std::string text = cameraText(camera);
        const Result<Camera> read = parseCamera(text, camera);
        QVERIFY2(read.ok(), text.c_str());
        QVERIFY2(read.value() == camera, text.c_str());
        QVERIFY(text.find('\n') == std::string::npos && text.size() < 160);
    }
    // At meshes of any size, anywhere: as far as a float goes.
    for (const float away : {1.0e-7f, 3.0e6f, 1.0e30f, std::numeric_limits<float>::max()}) {
        Camera far;
        far.setSceneRadius(away);
        far.setPivot({away, -away, 0.0f}, 0.3f, 0.2f, away);
        const Result<Camera> read = parseCamera(cameraText(far), far);
        QVERIFY2(read.ok() && read.value() == far, cameraText(far).c_str());
    }
    // The poles, and a default camera, whose numbers are short.
    Camera camera;
    QVERIFY(cameraText(camera).ends_with("fov 50 perspective"));
    camera.orbit(0.0f, 10.0f);
    QVERIFY(parseCamera(cameraText(camera), camera).value() == camera);
}

void CameraTest::textSaysWhatIsWrong_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const char* text, const char* says) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(says);
    };
    row("empty", "", "no camera");
    row("something else", "v 1 2 3", "no camera");
    row("no distance", "camera pivot 0 0 0 yaw 0 pitch 0 fov 50 perspective", "\"distance\" is missing");
    row("no projection", "camera pivot 0 0 0 yaw 0 pitch 0 distance 3 fov 50", "\"perspective\" or");
    row("two numbers", "camera pivot 0 0 yaw 0 pitch 0 distance 3 fov 50 perspective", "needs 3 numbers");
    row("no number", "camera pivot 0 0 0 yaw 0 pitch 0 distance 3 fov", "\"fov\" needs a number");
    row("units", "camera pivot 0 0 0 yaw 0 pitch 0 distance 3m fov 50 perspective", "\"distance\" needs");
    row("not finite", "camera pivot nan 0 0 yaw 0 pitch 0 distance 3 fov 50 perspective", "\"pivot\" needs");
    row("no float", "camera pivot 4e38 0 0 yaw 0 pitch 0 distance 3 fov 50 perspective", "\"pivot\" has");
    row("zero distance", "camera pivot 0 0 0 yaw 0 pitch 0 distance 0 fov 50 perspective",
        "\"distance\" has");
    row("wide", "camera pivot 0 0 0 yaw 0 pitch 0 distance 3 fov 170 perspective", "from 5 to 120");
    row("upside down", "camera pivot 0 0 0 yaw 0 pitch 91 distance 3 fov 50 perspective", "from -90 to 90");
    row("twice", "camera pivot 0 0 0 yaw 0 yaw 0 pitch 0 distance 3 fov 50 perspective", "there twice");
    row("both", "camera pivot 0 0 0 yaw 0 pitch 0 distance 3 fov 50 perspective orthographic", "there twice");
    row("unknown", "camera pivot 0 0 0 yaw 0 pitch 0 roll 3 distance 3 fov 50 perspective", "\"roll\"");
}

void CameraTest::textSaysWhatIsWrong() {
    QFETCH(QString, text);
    QFETCH(QString, says);
    const Result<Camera> read = parseCamera(text.toStdString(), {});
    QVERIFY(!read.ok());
    QVERIFY2(QString::fromStdString(read.error().what).contains(says), read.error().what.c_str());
    QVERIFY(!read.error().advice.empty());
}

void CameraTest::planesHoldTheScene_data() {
    QTest::addColumn<float>("radius");
    QTest::addColumn<float>("distance");
    QTest::addColumn<float>("nearest");  // metres: something as near as this is still seen
    QTest::newRow("the paper's scene") << 72.0f << 60.0f << 0.06f;
    QTest::newRow("close up in it") << 72.0f << 3.0f << 0.06f;
    QTest::newRow("a teapot") << 9.0f << 10.0f << 0.06f;
    QTest::newRow("a small part") << 0.02f << 0.05f << 0.001f;
}

void CameraTest::planesHoldTheScene() {
    QFETCH(float, radius);
    QFETCH(float, distance);
    QFETCH(float, nearest);
    Camera camera;
    camera.setSceneRadius(radius);
    camera.setPivot({0, 0, 0}, 0, 0, distance);
    const auto depth = [&](float ahead) {
        return project(camera, 1.5f, camera.eye() + ahead * camera.forward()).z;
    };
    QVERIFY(depth(nearest) > -1.0f);
    QVERIFY(depth(distance + 2.0f * radius) < 1.0f);
    // With 24 bits of depth a thousandth of the distance can be told apart out there.
    const float there = distance + 0.5f * radius;
    QVERIFY((depth(1.001f * there) - depth(there)) * 0.5f * 16777216.0f > 2.0f);
}

void CameraTest::defaultLightsFollowTheScene() {
    for (const float extent : {1.0f, 60.0f}) {
        const glm::vec3 centre(1, 2, 3);
        const Lights lights = defaultLights({centre, extent});
        for (const PointLight& light : lights.points) {
            const float d = glm::length(light.position - centre);
            QVERIFY(light.position.y > centre.y && d > 0.5f * extent && d < 2.0f * extent);
            const Attenuation& a = light.attenuation;
            const float left = 1.0f / (a.constant + a.linear * d + a.quadratic * d * d);
            QVERIFY2(left > 0.15f && left < 0.9f, qPrintable(QString::number(left)));
        }
    }
}

HITSCOPE_TEST(CameraTest, QCoreApplication)

}  // namespace hitscope::camera_test

#include "camera_test.moc"
