// SPDX-License-Identifier: GPL-3.0-or-later
// A camera that was kept comes back in every bit, also from beyond where zooming leads.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "support/test_program.h"
#include "view/camera_text.h"
#include "viewport/camera_glide.h"

namespace hitscope::camera_restored_test {

namespace {

constexpr float kDegree = 0.017453292f;

Camera sceneCamera() {
    Camera camera;
    camera.setSceneRadius(3.4641f);
    return camera;
}

}  // namespace

class CameraRestoredTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fromItsText_data() {
        QTest::addColumn<float>("fieldOfView");
        QTest::addColumn<float>("aspect");
        QTest::newRow("narrow") << 5.0f * kDegree << 16.0f / 9.0f;
        QTest::newRow("narrow and upright") << 5.0f * kDegree << 0.5f;
        QTest::newRow("upright") << 10.0f * kDegree << 0.5f;
    }
    void fromItsText() {
        QFETCH(float, fieldOfView);
        QFETCH(float, aspect);
        Camera camera = sceneCamera();
        camera.setFieldOfView(fieldOfView);
        Bounds bounds;
        bounds.add(glm::vec3(-1));
        bounds.add(glm::vec3(1));
        camera.frame(bounds, aspect);
        QVERIFY(parseCamera(cameraText(camera), sceneCamera()).value() == camera);
        // Zooming leads back within its limits.
        camera.zoom(1.0f);
        QVERIFY(camera.distance() <= 10.0f * camera.sceneRadius());
    }

    void afterZoomingAboutWhatIsFarOrNear() {
        for (const float away : {60.0f, 0.002f}) {
            Camera camera = sceneCamera();
            camera.setPivot(glm::vec3(0), 0.0f, 0.2f, 6.0f);
            camera.zoomAbout(camera.eye() + camera.forward() * away, 0.98f);
            const Camera read = parseCamera(cameraText(camera), camera).value();
            QVERIFY(read == camera && read.eye() == camera.eye());
            // On the way there it is not held up either.
            Camera near = sceneCamera();
            near.setPivot(camera.pivot(), camera.yaw(), camera.pitch(), 6.0f);
            const float most = std::max(near.distance(), camera.distance());
            const float least = std::min(near.distance(), camera.distance());
            const float between = hitscope::between(near, camera, 0.99f).distance();
            QVERIFY(between > least && between < most);
            QVERIFY(std::abs(std::log(between / camera.distance())) < 0.1f);
        }
    }

    void whatIsNoDistanceIsPassedOver() {
        Camera camera = sceneCamera();
        for (const float wrong :
             {0.0f, -1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
            camera.restore({1, 2, 3}, 0.1f, 0.2f, wrong);
            QCOMPARE(camera.distance(), sceneCamera().distance());
        }
        camera.restore({1, 2, 3}, 0.1f, 0.2f, std::numeric_limits<float>::max());
        const glm::mat4 projection = camera.projection(1.5f);
        QVERIFY(std::isfinite(projection[2][2]) && std::isfinite(projection[3][2]));
        camera.setPivot({1, 2, 3}, 0.1f, 0.2f, 1.0e9f);
        QCOMPARE(camera.distance(), 10.0f * camera.sceneRadius());
    }
};

HITSCOPE_TEST(CameraRestoredTest, QCoreApplication)

}  // namespace hitscope::camera_restored_test

#include "camera_restored_test.moc"
