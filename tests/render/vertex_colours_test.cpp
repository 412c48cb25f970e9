// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose vertices have colours.
#include <QColor>
#include <QTest>
#include <optional>

#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::vertex_colours_test {

using namespace test;

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

}  // namespace

class VertexColoursTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_renderer = openRenderer(m_gl); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_renderer.reset(); }
    void coloursAreThoseOfTheMesh();
    void originalsHaveTheirColours();
    void coversHaveNoVertexColours();

private:
    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
};

void VertexColoursTest::coloursAreThoseOfTheMesh() {
    // A triangle of one colour all over is drawn as if its material had it: sRGB there, linear here.
    MeshData triangle;
    triangle.positions = {{-4, -2, 0}, {4, -2, 0}, {0, 5, 0}, {9, 9, 9}};
    triangle.faceStarts = {0, 3};
    triangle.cornerVertices = {0, 1, 2};
    const auto middle = [this](const MeshData& mesh, bool colours) {
        TestScene scene;
        scene.add(*m_renderer, mesh, glm::vec3(0));
        const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
        Frame frame = frameOf(scene, 40, 40);
        frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 6.0f);
        frame.options.vertexColours = colours;
        return picture(*m_renderer, frame, *pipeline).pixel(20, 20);
    };
    const auto with = [&triangle](const glm::vec3& colour, std::optional<glm::vec3> diffuse) {
        MeshData mesh = triangle;
        mesh.colours.assign(mesh.positions.size(), colour);
        mesh.colours.back() = glm::vec3(1.0f);  // of a vertex that no face uses
        if (diffuse) {
            mesh.materials.resize(1);
            mesh.materials[0].diffuse = *diffuse;
            mesh.materials[0].specular = glm::vec3(0.3f);
            mesh.materials[0].shininess = 40.0f;  // as the default material
            mesh.faceMaterials = {0};
        }
        return mesh;
    };
    const glm::vec3 white(1.0f);
    const glm::vec3 srgb(128.0f / 255.0f, 64.0f / 255.0f, 230.0f / 255.0f);
    const glm::vec3 linear(0.21586f, 0.05127f, 0.79130f);
    const QRgb expected = middle(with(white, linear), true);
    const QRgb own = middle(with(srgb, std::nullopt), true);  // nothing else colours it
    QVERIFY2(levels(own, expected) <= 1, qPrintable(QColor(own).name() + QColor(expected).name()));
    QVERIFY(levels(middle(with(srgb, white), true), expected) <= 1);
    const QRgb darker = middle(with(srgb, glm::vec3(0.5f)), true);
    QVERIFY(levels(darker, middle(with(white, 0.5f * linear), true)) <= 1);
    QVERIFY(levels(darker, expected) > 20);
    QCOMPARE(middle(with(srgb, linear), false), expected);
    QCOMPARE(middle(with(srgb, std::nullopt), false), middle(triangle, true));
}

void VertexColoursTest::originalsHaveTheirColours() {
    TestScene scene;
    scene.add(*m_renderer, withColours(makeUvSphere(24, 16, 2.5f)), glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame plain = frameOf(scene, kWidth, kHeight);
    Frame wiped = plain;
    wiped.options.beforeAfter.wipe = true;
    wiped.options.beforeAfter.wipeAt = 1.0f;
    const QImage shown = picture(*m_renderer, plain, *pipeline);
    QCOMPARE(differing(shown, picture(*m_renderer, wiped, *pipeline)), 0);
    wiped.options.vertexColours = false;
    QVERIFY(differing(shown, picture(*m_renderer, wiped, *pipeline), kDifferentLevels) > 1000);
}

void VertexColoursTest::coversHaveNoVertexColours() {
    MeshData mesh = makeUvSphere(24, 16, 2.5f);
    mesh.colours.assign(mesh.positions.size(), glm::vec3(1, 0, 0));
    TestScene scene;
    scene.add(*m_renderer, mesh, glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    const auto cover = m_renderer->makeCover(Image{1, 1, {255, 255, 255, 255}});
    std::vector<DrawItem> items(scene.items().begin(), scene.items().end());
    items[0].materials = cover.get();
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.targets = items;
    const QColor covered = picture(*m_renderer, frame, *pipeline).pixelColor(kWidth / 2, kHeight / 2);
    QVERIFY2(covered.green() > 100, qPrintable(covered.name()));
    frame.options.textures = false;
    const QColor own = picture(*m_renderer, frame, *pipeline).pixelColor(kWidth / 2, kHeight / 2);
    QVERIFY2(own.green() < 100, qPrintable(own.name()));
}

HITSCOPE_TEST(VertexColoursTest, QCoreApplication)

}  // namespace hitscope::vertex_colours_test

#include "vertex_colours_test.moc"
