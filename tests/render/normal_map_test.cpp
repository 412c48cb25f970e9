// SPDX-License-Identifier: GPL-3.0-or-later
// Normal maps: a map that leans all normals alike looks as a surface does whose own normals lean so.
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::normal_map_test {

using namespace test;

namespace {

constexpr float kSide = 2.0f;  // metres

/// A quad across z, with texture coordinates turned by quarter turns and perhaps mirrored.
MeshData plane(const glm::vec3& normal, int turns = 0, bool mirrored = false) {
    MeshData mesh;
    mesh.positions = {{-kSide, -kSide, 0}, {kSide, -kSide, 0}, {kSide, kSide, 0}, {-kSide, kSide, 0}};
    mesh.faceStarts = {0, 4};
    mesh.cornerVertices = {0, 1, 2, 3};
    mesh.normals.push_back(normal);
    mesh.cornerNormals = {0, 0, 0, 0};
    mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
        const std::uint32_t turned = (corner + static_cast<std::uint32_t>(4 - turns)) % 4;
        mesh.cornerTexcoords.push_back(mirrored ? (5 - turned) % 4 : turned);
    }
    mesh.faceMaterials = {0};
    mesh.materials.resize(1);
    return mesh;
}

/// The same normal all over: along u, along v, outwards; unit.
void addMap(MeshData& mesh, const glm::vec3& normal, float strength = 1.0f) {
    Image image{4, 4, {}};
    for (int texel = 0; texel < 16; ++texel) {
        for (int i = 0; i < 3; ++i) {
            image.pixels.push_back(static_cast<std::uint8_t>(std::lround(128.0f + 127.0f * normal[i])));
        }
        image.pixels.push_back(255);
    }
    mesh.images = {image};
    mesh.materials[0].normalMap.image = 0;
    mesh.materials[0].normalMap.strength = strength;
}

}  // namespace

class NormalMapTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void cleanupTestCase() { m_renderer.reset(); }
    void leansNormals_data();
    void leansNormals();
    void followsDents();
    void isLeftOut_data();
    void isLeftOut();

private:
    QImage draw(const MeshData& mesh, const DisplayOptions& options = {}, std::span<const Hit> hits = {}) {
        TestScene scene;
        scene.add(*m_renderer, mesh, glm::vec3(0));
        const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, hits);
        scene.showTrueNormals(hits);
        Frame frame = frameOf(scene, 160, 120);
        frame.camera.setPivot(glm::vec3(0), 0.3f, 0.2f, 6.0f);
        frame.options = options;
        frame.options.floor = false;
        return picture(*m_renderer, frame, *pipeline);
    }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
};

void NormalMapTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
}

void NormalMapTest::cleanup() {
    QCOMPARE(m_gl.errors(), QStringList());
}

void NormalMapTest::leansNormals_data() {
    QTest::addColumn<float>("alongU");  // of the unit normal
    QTest::addColumn<float>("alongV");
    QTest::addColumn<int>("turns");
    QTest::addColumn<bool>("mirrored");
    QTest::addColumn<float>("strength");
    QTest::newRow("not at all") << 0.0f << 0.0f << 0 << false << 1.0f;
    QTest::newRow("along u") << 0.5f << 0.0f << 0 << false << 1.0f;
    QTest::newRow("along v") << 0.0f << 0.5f << 0 << false << 1.0f;
    QTest::newRow("both, turned") << 0.4f << -0.3f << 1 << false << 1.0f;
    QTest::newRow("mirrored") << 0.4f << 0.3f << 0 << true << 1.0f;
    QTest::newRow("stronger") << 0.2f << 0.1f << 0 << false << 2.0f;
}

void NormalMapTest::leansNormals() {
    QFETCH(float, alongU);
    QFETCH(float, alongV);
    QFETCH(int, turns);
    QFETCH(bool, mirrored);
    QFETCH(float, strength);
    const glm::vec3 texel(alongU, alongV, std::sqrt(1.0f - alongU * alongU - alongV * alongV));
    MeshData mapped = plane({0, 0, 1}, turns, mirrored);
    addMap(mapped, texel, strength);
    // Where u and v go on the plane: texture coordinates are an affine function of the place.
    const auto at = [&mapped](int corner) {
        return mapped.texcoords[mapped.cornerTexcoords[static_cast<std::size_t>(corner)]];
    };
    const glm::vec2 alongX = at(1) - at(0);
    const glm::vec2 alongY = at(3) - at(0);
    const glm::vec3 u(alongX.x, alongY.x, 0.0f);
    const glm::vec3 v(alongX.y, alongY.y, 0.0f);
    const glm::vec3 lean =
        glm::normalize(strength * texel.x * u + strength * texel.y * v + glm::vec3(0, 0, texel.z));
    const QImage expected = draw(plane(lean));
    const QImage shown = draw(mapped);
    QCOMPARE(differing(shown, expected, 4), 0);  // texels are rounded to 1/127
    if (alongU != 0.0f || alongV != 0.0f) {
        QVERIFY(differing(shown, draw(plane({0, 0, 1})), 4) > 2000);
    }
}

void NormalMapTest::followsDents() {
    // A map that changes nothing leaves a dent as it is: it starts from the normal of the dented surface.
    MeshData mesh = makeUvSphere(48, 32, 2.5f);
    mesh.faceMaterials.assign(mesh.faceCount(), 0);
    mesh.materials.resize(1);
    const std::vector<Hit> hits = dents({1}, 8);
    for (const NormalMode mode : {NormalMode::True, NormalMode::Paper}) {
        const DisplayOptions options{.normals = mode};
        MeshData mapped = mesh;
        addMap(mapped, {0, 0, 1});
        QVERIFY(differing(draw(mapped, options, hits), draw(mesh, options, hits), 4) < 20);
        addMap(mapped, {0.5f, 0, std::sqrt(0.75f)});
        QVERIFY(differing(draw(mapped, options, hits), draw(mesh, options, hits), 4) > 1000);
    }
}

void NormalMapTest::isLeftOut_data() {
    QTest::addColumn<DisplayOptions>("options");
    QTest::newRow("flat") << DisplayOptions{.flat = true};
    QTest::newRow("no textures") << DisplayOptions{.textures = false};
    QTest::newRow("wireframe only") << DisplayOptions{.wireframe = WireframeMode::Only};
}

void NormalMapTest::isLeftOut() {
    QFETCH(DisplayOptions, options);
    MeshData mapped = plane({0, 0, 1});
    addMap(mapped, {0.5f, 0, std::sqrt(0.75f)});
    QCOMPARE(differing(draw(mapped, options), draw(plane({0, 0, 1}), options)), 0);
}

HITSCOPE_TEST(NormalMapTest, QCoreApplication)

}  // namespace hitscope::normal_map_test

#include "normal_map_test.moc"
