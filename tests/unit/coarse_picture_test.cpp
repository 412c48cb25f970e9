// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/coarse_picture.h"

#include <QTest>
#include <cmath>

#include "core/parallel.h"
#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::coarse_picture_test {

namespace {

constexpr int kSize = 64;  // pixels, both ways
constexpr glm::vec3 kLight{0.0f, 0.0f, -1.0f};

/// Looks along -z at the origin; 2 m high there.
Camera straightCamera() {
    Camera camera;
    camera.setSceneRadius(4.0f);
    camera.setProjection(Projection::Orthographic);
    camera.setPivot(glm::vec3(0.0f), 0.0f, 0.0f, 1.0f / std::tan(0.5f * camera.fieldOfView()));
    return camera;
}

/// Triangles of three vertices each, and their material.
MeshData trianglesOf(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& materials) {
    MeshData mesh;
    mesh.positions.assign(positions.begin(), positions.end());
    mesh.faceStarts.push_back(0);
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        mesh.cornerVertices.push_back(v);
        if (v % 3 == 2) {
            mesh.faceStarts.push_back(v + 1);
        }
    }
    mesh.materials.resize(2);
    mesh.materials[0].diffuse = {1.0f, 0.0f, 0.0f};
    mesh.materials[1].diffuse = {0.0f, 1.0f, 0.0f};
    mesh.faceMaterials = materials;
    return mesh;
}

const std::uint8_t* pixelAt(const Image& image, int x, int y) {
    return &image.pixels[4 * (static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x))];
}

double shareCovered(const Image& image) {
    std::size_t covered = 0;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        covered += image.pixels[i] != 0 ? 1 : 0;
    }
    return static_cast<double>(covered) / (kSize * kSize);
}

}  // namespace

class CoarsePictureTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void coversWhatTheFaceCovers() {
        // A quarter of the picture, at the upper left.
        MeshData square = trianglesOf({{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {0});
        square.positions.push_back({-1, 1, 0});
        square.cornerVertices.push_back(3);
        square.faceStarts.back() = 4;
        const Image image = drawCoarsely(square, straightCamera(), kLight, kSize, kSize);
        QCOMPARE(shareCovered(image), 0.25);
        QCOMPARE(int{pixelAt(image, 0, 0)[3]}, 255);
        QCOMPARE(int{pixelAt(image, 31, 31)[3]}, 255);
        QCOMPARE(int{pixelAt(image, 32, 31)[3]}, 0);
        QCOMPARE(int{pixelAt(image, 31, 32)[3]}, 0);
    }

    void theNearerFaceIsSeen_data() {
        QTest::addColumn<float>("depthOfRed");
        QTest::newRow("red in front") << 0.5f;
        QTest::newRow("green in front") << -0.5f;
    }
    void theNearerFaceIsSeen() {
        QFETCH(float, depthOfRed);
        const float z = depthOfRed;
        const MeshData mesh =
            trianglesOf({{-3, -3, z}, {3, -3, z}, {0, 3, z}, {-3, -3, 0}, {3, -3, 0}, {0, 3, 0}}, {0, 1});
        const Image image = drawCoarsely(mesh, straightCamera(), kLight, kSize, kSize);
        const std::uint8_t* middle = pixelAt(image, 32, 40);
        QCOMPARE(middle[0] > 0, z > 0.0f);
        QCOMPARE(middle[1] > 0, z < 0.0f);
    }

    void theSideThatIsSeenIsLit() {
        const std::vector<glm::vec3> facing{{-3, -3, 0}, {3, -3, 0}, {0, 3, 0}};
        const std::vector<glm::vec3> turned{facing[0], facing[2], facing[1]};
        const auto redOf = [](const std::vector<glm::vec3>& corners, const glm::vec3& light) {
            return int{pixelAt(drawCoarsely(trianglesOf(corners, {0}), straightCamera(), light, kSize, kSize),
                               32, 40)[0]};
        };
        const int lit = redOf(facing, kLight);
        QCOMPARE(redOf(turned, kLight), lit);
        QVERIFY(redOf(facing, -kLight) < lit);
        QCOMPARE(redOf(facing, 10.0f * kLight), lit);
    }

    void whatReachesBehindTheEyeIsLeftOut() {
        Camera camera = straightCamera();
        camera.setProjection(Projection::Perspective);
        const MeshData mesh = trianglesOf({{-1, 0, 0}, {1, 0, 0}, {0, 1, 50}}, {0});
        QCOMPARE(shareCovered(drawCoarsely(mesh, camera, kLight, kSize, kSize)), 0.0);
    }

    void numbersThatAreNoPlaceDrawNothing() {
        const float huge = 3e38f;
        const MeshData mesh = trianglesOf({{-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}}, {0});
        const Image image = drawCoarsely(mesh, straightCamera(), kLight, kSize, kSize);
        QCOMPARE(image.pixels.size(), std::size_t{4 * kSize * kSize});
    }

    void anyNumberOfProcessorsDrawsTheSame() {
        const MeshData mesh = makeUvSphere(800, 400, 1.0f);
        Camera camera;
        camera.frame(mesh.bounds(), 1.0f);
        pretendedProcessors() = 1;
        const Image one = drawCoarsely(mesh, camera, kLight, kSize, kSize);
        pretendedProcessors() = 5;
        const Image five = drawCoarsely(mesh, camera, kLight, kSize, kSize);
        pretendedProcessors() = 0;
        QVERIFY(shareCovered(one) > 0.2);
        QVERIFY(one.pixels == five.pixels);
    }
};

HITSCOPE_TEST(CoarsePictureTest, QCoreApplication)

}  // namespace hitscope::coarse_picture_test

#include "coarse_picture_test.moc"
