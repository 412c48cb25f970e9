// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh's materials do to the picture.
#include <QTest>
#include <algorithm>
#include <array>

#include "gl/context.h"
#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render/material_set.h"
#include "render/renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::materials_test {

using namespace test;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr int kSide = 120;  // pixels of a picture of a ball

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
    void theCpuFiltersInOneDirection();
    void translucentMaterialsLetThrough();
    void metalsLookAsTheyDid_data();
    void metalsLookAsTheyDid();
    void metalsAreNeverBlack();
    void roughnessSpreadsHighlights();
    void mapsScaleMetalnessAndRoughness();

private:
    /// A ball whose material has this colour, in the lights of m_frame.
    [[nodiscard]] QImage ball(const glm::vec3& base, const MetalRoughness& metal, const Image& map = {});
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

/// There it can take for ever: a picture of Assimp's spider did, 1056 x 578 pixels large.
void MaterialsTest::theCpuFiltersInOneDirection() {
    if (epoxy_gl_version() < 45 || !gl::rendererInfo().isSoftware()) {
        QSKIP("for software renderers whose textures can be asked by name");
    }
    constexpr int kUnusual = 37;  // pixels
    Image map{kUnusual, kUnusual, {}};
    map.pixels.assign(std::size_t{4} * kUnusual * kUnusual, 200);
    const MaterialSet materials(map);
    int found = 0;
    for (GLuint name = 1; name < 1000; ++name) {
        GLint width = 0;
        if (glIsTexture(name) == GL_TRUE) {
            glGetTextureLevelParameteriv(name, 0, GL_TEXTURE_WIDTH, &width);
        }
        if (width == kUnusual) {
            ++found;
            GLfloat anisotropy = 0.0f;
            glGetTextureParameterfv(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, &anisotropy);
            QCOMPARE(anisotropy, 1.0f);
        }
    }
    QCOMPARE(found, 1);
}

QImage MaterialsTest::ball(const glm::vec3& base, const MetalRoughness& metal, const Image& map) {
    MeshData mesh = makeUvSphere(48, 32, 2.5f);
    mesh.materials.resize(1);
    mesh.materials[0].diffuse = base;
    mesh.materials[0].specular = glm::vec3(1);
    mesh.materials[0].metalRoughness = metal;
    mesh.faceMaterials.assign(mesh.faceCount(), 0);
    if (map.width > 0) {
        mesh.images = {map};
        mesh.materials[0].metalRoughness.image = 0;
    }
    m_scene = std::make_unique<TestScene>();
    m_scene->add(*m_renderer, mesh, glm::vec3(0));
    use(PipelineKind::TransformFeedback);
    Frame frame = frameOf(*m_scene, kSide, kSide);
    frame.lights = m_frame.lights;
    frame.camera.zoom(0.75f);
    return draw(frame);
}

void MaterialsTest::metalsLookAsTheyDid_data() {
    QTest::addColumn<float>("metalness");
    QTest::addColumn<float>("roughness");
    QTest::newRow("gold-smooth") << 1.0f << 0.2f;
    QTest::newRow("gold-rough") << 1.0f << 0.7f;
    QTest::newRow("gold-paint") << 0.0f << 0.3f;
}

void MaterialsTest::metalsLookAsTheyDid() {
    QFETCH(float, metalness);
    QFETCH(float, roughness);
    HITSCOPE_NEEDS_SAMPLES();
    const QImage shown = ball({1.0f, 0.77f, 0.34f}, {metalness, roughness, {}, -1});
    const QString difference = differenceFromBaseline(shown, QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

void MaterialsTest::metalsAreNeverBlack() {
    // One light from the left: the right side has what is around, coloured by the metal.
    m_frame.lights = {};
    for (PointLight& light : m_frame.lights.points) {
        light.on = false;
    }
    m_frame.lights.spot.on = false;
    m_frame.lights.directional.direction = glm::vec3(1, 0, 0);
    for (const float roughness : {0.0f, 0.5f, 1.0f}) {
        const QImage gold = ball({1.0f, 0.5f, 0.1f}, {1.0f, roughness, {}, -1});
        const QColor dark = gold.pixelColor(kSide / 2 + kSide / 6, kSide / 2);
        QVERIFY2(dark.red() > 60 && dark.red() > dark.green() + 20 && dark.green() > dark.blue() + 20,
                 qPrintable(dark.name()));
    }
    // Paint of that colour is there as dark as any other.
    const QColor paint =
        ball({1.0f, 0.5f, 0.1f}, {0.0f, 1.0f, {}, -1}).pixelColor(kSide / 2 + kSide / 6, kSide / 2);
    QVERIFY2(paint.red() < 90, qPrintable(paint.name()));
    // Without light there is nothing to reflect.
    m_frame.lights.directional.on = false;
    QVERIFY(ball(glm::vec3(1), {1.0f, 0.3f, {}, -1}).pixelColor(kSide / 2, kSide / 2).lightness() == 0);
}

void MaterialsTest::roughnessSpreadsHighlights() {
    const auto bright = [this](float metalness, float roughness) {
        const QImage shown = ball(glm::vec3(0.25f), {metalness, roughness, {}, -1});
        int count = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                count += qGreen(shown.pixel(x, y)) > 215 ? 1 : 0;
            }
        }
        return count;
    };
    const int smooth = bright(1.0f, 0.1f);
    const int half = bright(1.0f, 0.3f);
    QVERIFY2(smooth > 0 && half > 2 * smooth, qPrintable(QStringLiteral("%1, %2").arg(smooth).arg(half)));
    QCOMPARE(bright(1.0f, 1.0f), 0);
    QVERIFY(bright(0.0f, 0.1f) > 0);
}

void MaterialsTest::mapsScaleMetalnessAndRoughness() {
    // Green is roughness and blue metalness, as numbers and not as colours.
    const auto texel = [](int red, int green, int blue) {
        return Image{1,
                     1,
                     {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                      static_cast<std::uint8_t>(blue), 255}};
    };
    const glm::vec3 base(0.8f, 0.4f, 0.2f);
    const QImage mapped = ball(base, {1.0f, 0.5f, {}, -1}, texel(7, 204, 51));
    const QImage same = ball(base, {0.2f, 0.4f, {}, -1});
    QVERIFY(differing(mapped, same, 2) < 20);
    QVERIFY(differing(mapped, ball(base, {0.8f, 0.1f, {}, -1}), 5) > 500);
    QVERIFY(differing(mapped, ball(base, {1.0f, 0.5f, {}, -1}), 5) > 500);
    // A map of a material that is not described so is nothing.
    QCOMPARE(differing(ball(base, {0.0f, -1.0f, {}, -1}, texel(7, 204, 51)), ball(base, {})), 0);
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

}  // namespace hitscope::materials_test

#include "materials_test.moc"
