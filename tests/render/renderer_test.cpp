// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.h"

#include <QSet>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::renderer_test {

using namespace test;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// Mean of the channels over a rectangle, [0, 255].
double brightness(const QImage& image, const QRect& part) {
    double sum = 0;
    for (int y = part.top(); y <= part.bottom(); ++y) {
        for (int x = part.left(); x <= part.right(); ++x) {
            sum += qRed(image.pixel(x, y)) + qGreen(image.pixel(x, y)) + qBlue(image.pixel(x, y));
        }
    }
    return sum / (3.0 * part.width() * part.height());
}

/// In the middle of the picture, where the target is.
const QRect kMiddle(kWidth / 2 - 20, kHeight / 2 - 20, 40, 40);

}  // namespace

class RendererTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void cleanupTestCase();
    void showsTheTarget();
    void hitsAreSeen();
    void pipelinesGiveTheSamePicture_data();
    void pipelinesGiveTheSamePicture();
    void everyLightCounts();
    void lightsOffIsDark();
    void diffuseFollowsThePapersEquation();
    void normalsMatter();
    void themesDiffer();
    void floorIsOptional();
    void fineMeshesAreDrawnWhole();
    void alikePointLightsShineAsOthersDo();
    void backFacesAreLit();
    void projectilesAreDrawn();
    void selectionAndHighlightAreSeen();
    void crosshairIsInTheMiddle();
    void pictureIsOpaque();
    void stateIsGivenBack();

private:
    [[nodiscard]] QImage draw(const Frame& frame) { return picture(*m_renderer, frame, *m_pipeline); }
    void use(PipelineKind kind, std::span<const Hit> hits = {}) {
        m_pipeline = m_scene->pipeline(kind, hits);
    }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<TestScene> m_scene;
    std::unique_ptr<DeformationPipeline> m_pipeline;
    Frame m_frame;
};

void RendererTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
}

void RendererTest::init() {
    m_scene = std::make_unique<TestScene>();
    addSphere(*m_scene, *m_renderer);
    use(PipelineKind::TransformFeedback);
    m_frame = frameOf(*m_scene, kWidth, kHeight);
}

void RendererTest::cleanup() {
    QCOMPARE(m_gl.errors(), QStringList());
    m_pipeline.reset();
    m_scene.reset();
}

void RendererTest::cleanupTestCase() {
    m_renderer.reset();
}

void RendererTest::showsTheTarget() {
    const QImage shown = draw(m_frame);
    QVERIFY(!shown.isNull());
    Frame empty = m_frame;
    empty.targets = {};
    const QImage without = draw(empty);
    // The sphere covers a good part of the picture, and not all of it.
    const int covered = differing(shown, without, 8);
    QVERIFY2(covered > kWidth * kHeight / 20 && covered < kWidth * kHeight / 2,
             qPrintable(QString::number(covered)));
    // Above is sky, below the floor's grid.
    const auto colours = [&](int y) {
        QSet<QRgb> seen;
        for (int x = 0; x < kWidth; ++x) {
            seen.insert(without.pixel(x, y));
        }
        return seen.size();
    };
    QVERIFY(colours(kHeight - 20) > 2 * colours(5));
}

void RendererTest::hitsAreSeen() {
    const QImage before = draw(m_frame);
    const auto hits = dents({1}, 12);
    use(PipelineKind::TransformFeedback, hits);
    m_scene->showTrueNormals(hits);
    QVERIFY(differing(before, draw(m_frame), 8) > 500);
}

void RendererTest::pipelinesGiveTheSamePicture_data() {
    QTest::addColumn<int>("wireframe");
    QTest::addColumn<int>("normals");
    QTest::newRow("true normals") << int(WireframeMode::Off) << int(NormalMode::True);
    QTest::newRow("paper's normals") << int(WireframeMode::Off) << int(NormalMode::Paper);
    QTest::newRow("wireframe over") << int(WireframeMode::Over) << int(NormalMode::Paper);
    QTest::newRow("wireframe only") << int(WireframeMode::Only) << int(NormalMode::Paper);
}

void RendererTest::pipelinesGiveTheSamePicture() {
    QFETCH(int, wireframe);
    QFETCH(int, normals);
    m_frame.options.wireframe = static_cast<WireframeMode>(wireframe);
    m_frame.options.normals = static_cast<NormalMode>(normals);
    const auto hits = dents({1}, 60);
    use(PipelineKind::TransformFeedback, hits);
    const QImage feedback = draw(m_frame);
    use(PipelineKind::UniformArray, hits);
    const QImage uniforms = draw(m_frame);
    // Both have the same vertices in every bit, so the pictures are the same in every pixel.
    QCOMPARE(differing(feedback, uniforms), 0);
    use(PipelineKind::UniformArray);
    QVERIFY(differing(uniforms, draw(m_frame)) > 100);
}

void RendererTest::everyLightCounts() {
    const QImage all = draw(m_frame);
    const auto without = [&](auto&& change) {
        Frame frame = m_frame;
        change(frame.lights);
        const QImage image = draw(frame);
        QVERIFY2(differing(all, image, 1) > 200, qPrintable(QString::number(differing(all, image, 1))));
        QVERIFY(brightness(image, image.rect()) < brightness(all, all.rect()));
    };
    without([](Lights& lights) { lights.directional.on = false; });
    without([](Lights& lights) { lights.spot.on = false; });
    for (std::size_t i = 0; i < 4; ++i) {
        without([i](Lights& lights) { lights.points[i].on = false; });
    }
}

void RendererTest::lightsOffIsDark() {
    m_frame.lights.directional.on = false;
    m_frame.lights.spot.on = false;
    for (PointLight& light : m_frame.lights.points) {
        light.on = false;
    }
    QVERIFY(brightness(draw(m_frame), kMiddle) < 1.0);
}

void RendererTest::diffuseFollowsThePapersEquation() {
    // A cube seen straight on, one directional light at 60 degrees: eq. 10 gives half the light.
    m_scene = std::make_unique<TestScene>();
    MeshData cube = makeCube(1, 1.0f);
    cube.materials.resize(1);
    cube.materials[0].diffuse = glm::vec3(0.8f, 0.4f, 0.2f);
    cube.faceMaterials.assign(cube.faceCount(), 0);
    m_scene->add(*m_renderer, cube, glm::vec3(0));
    use(PipelineKind::TransformFeedback);
    m_frame = frameOf(*m_scene, kWidth, kHeight);
    m_frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 5.0f);
    for (PointLight& light : m_frame.lights.points) {
        light.on = false;
    }
    m_frame.lights.spot.on = false;
    m_frame.lights.directional.direction = 3.0f * glm::vec3(0.0f, -std::sqrt(3.0f) / 2.0f, -0.5f);
    m_frame.lights.directional.terms = {glm::vec3(1.0f), 0.1f, 0.6f, 0.0f};
    const QColor colour = draw(m_frame).pixelColor(kWidth / 2, kHeight / 2);
    const auto expected = [](float albedo) {
        const float light = albedo * (0.1f + 0.5f * 0.6f);
        return static_cast<int>(std::lround(255.0f * (1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f)));
    };
    QVERIFY2(std::abs(colour.red() - expected(0.8f)) <= 1, qPrintable(colour.name()));
    QVERIFY(std::abs(colour.green() - expected(0.4f)) <= 1);
    QVERIFY(std::abs(colour.blue() - expected(0.2f)) <= 1);
}

void RendererTest::normalsMatter() {
    const auto hits = dents({1}, 12);
    use(PipelineKind::TransformFeedback, hits);
    m_scene->showTrueNormals(hits);
    const QImage shownTrue = draw(m_frame);
    m_frame.options.normals = NormalMode::Paper;
    QVERIFY(differing(shownTrue, draw(m_frame), 8) > 300);
}

void RendererTest::themesDiffer() {
    const QRect top(0, 0, kWidth, 20);
    const double dark = brightness(draw(m_frame), top);
    m_frame.options.theme = Theme::Light;
    QVERIFY(brightness(draw(m_frame), top) > dark + 100.0);
}

void RendererTest::floorIsOptional() {
    const QImage with = draw(m_frame);
    m_frame.options.floor = false;
    const QImage without = draw(m_frame);
    const QRect bottom(0, kHeight - 40, kWidth, 40);
    QVERIFY(differing(with.copy(bottom), without.copy(bottom)) > 1000);
    QCOMPARE(differing(with.copy(kMiddle), without.copy(kMiddle)), 0);
}

/// Software renderers draw those in several goes.
void RendererTest::fineMeshesAreDrawnWhole() {
    const auto pictureOf = [this](int segments) {
        TestScene scene;
        scene.add(*m_renderer, makeUvSphere(segments, segments / 2, 2.5f), {0.0f, 2.5f, 0.0f});
        const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
        return picture(*m_renderer, frameOf(scene, 160, 120), *pipeline);
    };
    const QImage fine = pictureOf(512);
    QVERIFY(!fine.isNull());
    const int different = differing(fine, pictureOf(64), 24);
    QVERIFY2(different < 10, qPrintable(QString::number(different)));
}

/// They have a program of their own.
void RendererTest::alikePointLightsShineAsOthersDo() {
    const QImage alike = draw(m_frame);
    LightTerms& terms = m_frame.lights.points[2].terms;
    terms.ambient = std::nextafter(terms.ambient, 1.0f);
    QCOMPARE(differing(alike, draw(m_frame), 1), 0);
    terms.diffuse *= 4.0f;
    QVERIFY(differing(alike, draw(m_frame), 8) > 100);
}

void RendererTest::backFacesAreLit() {
    // From inside the sphere one sees only back faces; they are lit as front faces are.
    m_frame.camera.setPivot(glm::vec3(0.0f, 2.5f, 0.0f), 0.6f, 0.0f, 0.5f);
    m_frame.camera.setSceneRadius(5.0f);
    m_frame.lights.directional.on = false;
    for (PointLight& light : m_frame.lights.points) {
        light.on = false;
    }
    QVERIFY(brightness(draw(m_frame), kMiddle) > 60.0);
}

void RendererTest::projectilesAreDrawn() {
    const QImage none = draw(m_frame);
    const glm::vec3 eye = m_frame.camera.eye();
    const Ray left = m_frame.camera.rayThrough({-0.75f, 0.0f}, float(kWidth) / kHeight);
    const Ray right = m_frame.camera.rayThrough({0.75f, 0.0f}, float(kWidth) / kHeight);
    const glm::vec3 orange(0.9f, 0.58f, 0.29f);
    const ProjectileItem spheres[] = {{{eye + 4.0f * left.direction, 0.2f}, orange, {}},
                                      {{eye + 4.0f * right.direction, 0.2f}, orange, {}}};
    m_frame.projectiles = spheres;
    const QImage two = draw(m_frame);
    for (const int x : {kWidth / 8, kWidth - kWidth / 8}) {
        QVERIFY(levels(none.pixel(x, kHeight / 2), two.pixel(x, kHeight / 2)) > 30);
    }
    QCOMPARE(differing(none.copy(kMiddle), two.copy(kMiddle)), 0);
}

void RendererTest::selectionAndHighlightAreSeen() {
    const QImage plain = draw(m_frame);
    m_scene->select(0, true);
    QVERIFY(differing(plain, draw(m_frame), 8) > 200);
    m_scene->select(0, false);
    // A hit on the far side: its ring is seen through the target.
    m_frame.highlightedHit = Sphere{glm::vec3(-1.4f, 2.0f, -2.0f), 0.5f};
    QVERIFY(differing(plain, draw(m_frame), 8) > 50);
    m_frame.highlightedHit = Sphere{m_frame.camera.eye(), 0.5f};
    QVERIFY(!draw(m_frame).isNull());
}

void RendererTest::crosshairIsInTheMiddle() {
    const QImage without = draw(m_frame);
    m_frame.options.crosshair = true;
    const QImage with = draw(m_frame);
    int count = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            if (levels(without.pixel(x, y), with.pixel(x, y)) > 0) {
                QVERIFY(std::max(std::abs(x - kWidth / 2), std::abs(y - kHeight / 2)) <= 13);
                ++count;
            }
        }
    }
    QVERIFY(count > 40);
}

void RendererTest::pictureIsOpaque() {
    m_frame.options.crosshair = true;
    m_frame.options.wireframe = WireframeMode::Over;
    const QImage image = draw(m_frame);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            QCOMPARE(qAlpha(image.pixel(x, y)), 255);
        }
    }
}

void RendererTest::stateIsGivenBack() {
    const gl::RenderTarget other(16, 16);
    const gl::RenderTarget target(kWidth, kHeight);
    glBindFramebuffer(GL_FRAMEBUFFER, other.framebuffer());
    glViewport(1, 2, 3, 4);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ZERO);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_ALWAYS);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    glActiveTexture(GL_TEXTURE3);
    m_frame.options.wireframe = WireframeMode::Only;
    QVERIFY(m_renderer->draw(m_frame, *m_pipeline, target.framebuffer()).ok());

    const auto integer = [](GLenum name) {
        GLint value = 0;
        glGetIntegerv(name, &value);
        return static_cast<GLenum>(value);
    };
    QCOMPARE(integer(GL_DRAW_FRAMEBUFFER_BINDING), other.framebuffer());
    QCOMPARE(integer(GL_READ_FRAMEBUFFER_BINDING), other.framebuffer());
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    QCOMPARE(viewport, (std::array<GLint, 4>{1, 2, 3, 4}));
    QVERIFY(glIsEnabled(GL_SCISSOR_TEST) && glIsEnabled(GL_BLEND) && !glIsEnabled(GL_DEPTH_TEST));
    QCOMPARE(integer(GL_BLEND_SRC_RGB), GLenum{GL_ONE});
    QCOMPARE(integer(GL_BLEND_DST_ALPHA), GLenum{GL_ZERO});
    QCOMPARE(integer(GL_DEPTH_WRITEMASK), GLenum{GL_TRUE});
    QCOMPARE(integer(GL_DEPTH_FUNC), GLenum{GL_ALWAYS});
    QCOMPARE(integer(GL_ACTIVE_TEXTURE), GLenum{GL_TEXTURE3});
    QCOMPARE(integer(GL_VERTEX_ARRAY_BINDING), 0u);
    QCOMPARE(integer(GL_CURRENT_PROGRAM), 0u);
    std::array<GLboolean, 4> mask{};
    glGetBooleanv(GL_COLOR_WRITEMASK, mask.data());
    QCOMPARE(mask, (std::array<GLboolean, 4>{GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE}));

    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glActiveTexture(GL_TEXTURE0);
    // And what was left on did not spoil the picture.
    const Image image = target.read();
    QVERIFY(std::any_of(image.pixels.begin() + 4 * kWidth * kHeight / 2, image.pixels.end(),
                        [](std::uint8_t value) { return value > 40 && value < 255; }));
}

HITSCOPE_TEST(RendererTest, QCoreApplication)

}  // namespace hitscope::renderer_test

#include "renderer_test.moc"
