// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh's materials do to the picture.
#include <QTest>
#include <algorithm>
#include <array>

#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render/renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

using namespace hitscope;
using namespace hitscope::test;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// In the middle of the picture, where the target is.
const QRect kMiddle(kWidth / 2 - 20, kHeight / 2 - 20, 40, 40);

}  // namespace

class MaterialsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void cleanupTestCase();
    void texturesAreShownTheRightWayUp();
    void translucentMaterialsLetThrough();

private:
    [[nodiscard]] QImage draw(const Frame& frame) { return picture(*m_renderer, frame, *m_pipeline); }
    void use(PipelineKind kind) { m_pipeline = m_scene->pipeline(kind, {}); }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<TestScene> m_scene;
    std::unique_ptr<DeformationPipeline> m_pipeline;
    Frame m_frame;
};

void MaterialsTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
}

void MaterialsTest::init() {
    m_scene = std::make_unique<TestScene>();
    addSphere(*m_scene, *m_renderer);
    use(PipelineKind::TransformFeedback);
    m_frame = frameOf(*m_scene, kWidth, kHeight);
}

void MaterialsTest::cleanup() {
    QCOMPARE(m_gl.errors(), QStringList());
    m_pipeline.reset();
    m_scene.reset();
}

void MaterialsTest::cleanupTestCase() {
    m_renderer.reset();
}

void MaterialsTest::texturesAreShownTheRightWayUp() {
    // One quad towards the eye, texture coordinates upwards as in OBJ: the image's first row is on top.
    MeshData quad;
    quad.positions = {{-1, 0, 0}, {1, 0, 0}, {1, 2, 0}, {-1, 2, 0}};
    quad.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    quad.faceStarts = {0, 4};
    quad.cornerVertices = {0, 1, 2, 3};
    quad.cornerTexcoords = {0, 1, 2, 3};
    quad.faceMaterials = {0};
    quad.materials.resize(1);
    quad.materials[0].diffuseImage = 0;
    quad.materials[0].specular = glm::vec3(0);
    Image image{2, 2, {}};
    for (const auto& texel : {std::array{255, 0, 0, 255}, std::array{0, 255, 0, 255},
                              std::array{0, 0, 255, 255}, std::array{255, 255, 255, 255}}) {
        for (const int channel : texel) {
            image.pixels.push_back(static_cast<std::uint8_t>(channel));
        }
    }
    quad.images.push_back(image);
    m_scene = std::make_unique<TestScene>();
    m_scene->add(*m_renderer, quad, glm::vec3(0));
    use(PipelineKind::TransformFeedback);
    m_frame = frameOf(*m_scene, kWidth, kHeight);
    m_frame.camera.setPivot(glm::vec3(0, 1, 0), 0.0f, 0.0f, 3.0f);
    const QImage shown = draw(m_frame);
    const auto at = [&](int dx, int dy) { return shown.pixelColor(kWidth / 2 + dx, kHeight / 2 + dy); };
    const auto isMostly = [](int one, int other, int third) { return 2 * one > 3 * std::max(other, third); };
    QVERIFY(isMostly(at(-43, -43).red(), at(-43, -43).green(), at(-43, -43).blue()));
    QVERIFY(isMostly(at(43, -43).green(), at(43, -43).red(), at(43, -43).blue()));
    QVERIFY(isMostly(at(-43, 43).blue(), at(-43, 43).red(), at(-43, 43).green()));
    m_frame.options.textures = false;
    QVERIFY(differing(shown, draw(m_frame), 20) > 5000);
}

void MaterialsTest::translucentMaterialsLetThrough() {
    MeshData glass = makeUvSphere(24, 16, 1.0f);
    glass.materials.resize(1);
    glass.materials[0].opacity = 0.3f;
    glass.faceMaterials.assign(glass.faceCount(), 0);
    m_scene->add(*m_renderer, glass, m_frame.camera.eye() + 4.0f * m_frame.camera.forward());
    use(PipelineKind::TransformFeedback);
    m_frame.targets = m_scene->items();
    const QImage through = draw(m_frame);
    for (const std::size_t one : {std::size_t{0}, std::size_t{1}}) {
        m_frame.targets = m_scene->items().subspan(one, 1);
        QVERIFY(differing(draw(m_frame).copy(kMiddle), through.copy(kMiddle), 2) > 200);
    }
}

HITSCOPE_TEST(MaterialsTest, QCoreApplication)
#include "materials_test.moc"
