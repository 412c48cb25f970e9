// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels against the paper's equations 7-14, worked out here.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/primitives.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::lights_test {

using namespace test;

namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 160;
const glm::vec3 kDiffuse(0.5f, 0.3f, 0.2f);
const glm::vec3 kSpecular(0.2f);
constexpr float kShininess = 20.0f;

/// Equations 8 to 11: what a light's diffuse and specular terms send to the eye.
glm::vec3 reflected(const LightTerms& terms, const glm::vec3& n, const glm::vec3& toLight,
                    const glm::vec3& toEye) {
    const float diff = std::max(glm::dot(n, toLight), 0.0f);
    const glm::vec3 reflectDir = glm::reflect(-toLight, n);
    const float spec = diff > 0.0f ? std::pow(std::max(glm::dot(toEye, reflectDir), 0.0f), kShininess) : 0.0f;
    return terms.colour * (terms.diffuse * diff * kDiffuse + terms.specular * spec * kSpecular);
}

float left(const Attenuation& a, float d) {
    return 1.0f / (a.constant + a.linear * d + a.quadratic * d * d);
}

glm::vec3 light(const Lights& lights, const glm::vec3& p, const glm::vec3& n, const Camera& camera) {
    const glm::vec3 toEye = camera.isOrthographic() ? -camera.forward() : glm::normalize(camera.eye() - p);
    glm::vec3 sum(0.0f);
    if (lights.directional.on) {
        const LightTerms& terms = lights.directional.terms;
        sum += terms.colour * terms.ambient * kDiffuse +
               reflected(terms, n, -glm::normalize(lights.directional.direction), toEye);
    }
    for (const PointLight& point : lights.points) {
        if (point.on) {
            const glm::vec3 way = point.position - p;
            sum += left(point.attenuation, glm::length(way)) *
                   (point.terms.colour * point.terms.ambient * kDiffuse +
                    reflected(point.terms, n, glm::normalize(way), toEye));
        }
    }
    const SpotLight& spot = lights.spot;
    if (spot.on) {
        const glm::vec3 way = (spot.atEye ? camera.eye() : spot.position) - p;
        const glm::vec3 aim = spot.atEye ? camera.forward() : glm::normalize(spot.direction);
        const float theta = glm::dot(glm::normalize(-way), aim);
        const float outer = std::cos(spot.outerAngle);
        const float intensity = std::clamp((theta - outer) / (std::cos(spot.innerAngle) - outer), 0.0f, 1.0f);
        sum += left(spot.attenuation, glm::length(way)) *
               (spot.terms.colour * spot.terms.ambient * kDiffuse +
                intensity * reflected(spot.terms, n, glm::normalize(way), toEye));
    }
    return sum;
}

/// As tone.glsl says: sRGB, and above 0.7 a soft shoulder.
int level(float light) {
    const float over = std::max(light - 0.7f, 0.0f);
    const float soft = std::min(light, 0.7f) + 0.3f * over / (over + 0.3f);
    const float srgb = soft <= 0.0031308f ? 12.92f * soft : 1.055f * std::pow(soft, 1.0f / 2.4f) - 0.055f;
    return static_cast<int>(std::lround(255.0f * srgb));
}

Lights none() {
    Lights lights;
    lights.directional.on = false;
    for (PointLight& point : lights.points) {
        point.on = false;
    }
    lights.spot.on = false;
    return lights;
}

Lights directional() {
    Lights lights = none();
    lights.directional.on = true;
    lights.directional.direction = glm::vec3(-0.4f, -0.3f, -1.0f);
    lights.directional.terms = {{1.0f, 0.9f, 0.8f}, 0.05f, 0.9f, 0.8f};
    return lights;
}

Lights points(std::size_t first, std::size_t count) {
    Lights lights = none();
    for (std::size_t i = first; i < first + count; ++i) {
        PointLight& point = lights.points[i];
        point.on = true;
        const auto n = static_cast<float>(i);
        point.position = glm::vec3(n - 1.5f, 1.0f - 0.5f * n, 2.0f + 0.3f * n);
        point.attenuation = {0.8f + 0.2f * n, 0.2f, 0.1f + 0.05f * n};
        point.terms = {{1.0f, 0.4f + 0.2f * n, 1.0f - 0.2f * n}, 0.02f, 0.8f, 0.5f};
    }
    return lights;
}

Lights spot(bool atEye) {
    Lights lights = none();
    lights.spot.on = true;
    lights.spot.atEye = atEye;
    lights.spot.position = glm::vec3(1.0f, 1.5f, 3.0f);
    lights.spot.direction = glm::vec3(-0.3f, -0.5f, -1.0f);
    lights.spot.innerAngle = atEye ? 0.05f : 0.1f;
    lights.spot.outerAngle = atEye ? 0.2f : 0.5f;
    lights.spot.attenuation = {1.0f, 0.1f, 0.02f};
    lights.spot.terms = {{0.9f, 1.0f, 0.8f}, 0.1f, 1.5f, 0.5f};
    return lights;
}

Lights all() {
    Lights lights = points(0, 4);
    lights.directional = directional().directional;
    lights.directional.terms.diffuse = 0.2f;
    lights.spot = spot(true).spot;
    lights.spot.terms.diffuse = 0.3f;
    return lights;
}

}  // namespace

class LightsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (!m_gl.open()) {
            return;
        }
        auto renderer = Renderer::create();
        QVERIFY2(renderer.ok(), renderer.ok() ? "" : renderer.error().message().c_str());
        m_renderer = std::move(renderer).value();
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_renderer.reset(); }
    void pixelsFollowTheEquations_data();
    void pixelsFollowTheEquations();
    void floorFollowsTheEquations_data();
    void floorFollowsTheEquations();
    void aPlaneIsOfOneColourInParallelView_data();
    void aPlaneIsOfOneColourInParallelView();
    void facesBehindTheEyeFaceIt();

private:
    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
};

void LightsTest::pixelsFollowTheEquations_data() {
    QTest::addColumn<Lights>("lights");
    QTest::addColumn<bool>("orthographic");
    QTest::newRow("directional") << directional() << false;
    QTest::newRow("a point light") << points(2, 1) << false;
    QTest::newRow("two point lights") << points(1, 2) << false;
    QTest::newRow("four point lights") << points(0, 4) << false;
    QTest::newRow("spotlight at the eye") << spot(true) << false;
    QTest::newRow("spotlight at its place") << spot(false) << false;
    QTest::newRow("all") << all() << false;
    QTest::newRow("none") << none() << false;
    QTest::newRow("directional, orthographic") << directional() << true;
    QTest::newRow("all, orthographic") << all() << true;
}

void LightsTest::pixelsFollowTheEquations() {
    QFETCH(Lights, lights);
    QFETCH(bool, orthographic);
    // The front face of a cube, seen straight on.
    MeshData cube = makeCube(1, 1.0f);
    cube.materials.resize(1);
    cube.materials[0].diffuse = kDiffuse;
    cube.materials[0].specular = kSpecular;
    cube.materials[0].shininess = kShininess;
    cube.faceMaterials.assign(cube.faceCount(), 0);
    TestScene scene;
    scene.add(*m_renderer, cube, glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, orthographic ? 4.0f : 5.0f);
    frame.camera.setProjection(orthographic ? Projection::Orthographic : Projection::Perspective);
    frame.lights = lights;
    frame.options.floor = false;
    const QImage image = picture(*m_renderer, frame, *pipeline, 1);
    int brightest = 0;
    for (int y = 45; y < kHeight - 44; y += 7) {
        for (int x = 65; x < kWidth - 64; x += 7) {
            const glm::vec2 ndc(2.0f * (float(x) + 0.5f) / kWidth - 1.0f,
                                1.0f - 2.0f * (float(y) + 0.5f) / kHeight);
            const Ray ray = frame.camera.rayThrough(ndc, float(kWidth) / kHeight);
            const glm::vec3 p = ray.origin + ray.direction * ((1.0f - ray.origin.z) / ray.direction.z);
            QVERIFY(std::max(std::abs(p.x), std::abs(p.y)) < 1.0f);
            const glm::vec3 expected = light(lights, p, glm::vec3(0, 0, 1), frame.camera);
            const QRgb shown = image.pixel(x, y);
            const QRgb wanted = qRgb(level(expected.r), level(expected.g), level(expected.b));
            QVERIFY2(levels(shown, wanted) <= 1, qPrintable(QStringLiteral("at %1, %2: %3, not %4")
                                                                .arg(x)
                                                                .arg(y)
                                                                .arg(shown, 0, 16)
                                                                .arg(wanted, 0, 16)));
            brightest = std::max(brightest, qRed(shown));
        }
    }
    QVERIFY(brightest > 60 || lights.directional.on + lights.points[2].on + lights.spot.on == 0);
}

/// Lines of sight are the same everywhere, and so is all that depends on them.
void LightsTest::aPlaneIsOfOneColourInParallelView_data() {
    QTest::addColumn<DisplayOptions>("options");
    DisplayOptions options;
    options.look = SurfaceLook::Matcap;
    QTest::newRow("matcap") << options;
    options = {};
    options.environment = true;
    QTest::newRow("environment") << options;
    options.flat = true;
    QTest::newRow("environment, flat") << options;
    options = {};
    options.change.on = true;
    QTest::newRow("change") << options;
}

void LightsTest::aPlaneIsOfOneColourInParallelView() {
    QFETCH(DisplayOptions, options);
    TestScene scene;
    scene.add(*m_renderer, makeCube(1, 1.0f), glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame frame = frameOf(scene, kWidth, kHeight);
    // The eye is at the very face.
    frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 1.05f);
    frame.camera.setProjection(Projection::Orthographic);
    frame.lights = directional();
    frame.options = options;
    frame.options.floor = false;
    if (options.change.on) {
        frame.change = ShownChange{};
    }
    const QImage image = picture(*m_renderer, frame, *pipeline, 1);
    const QRgb middle = image.pixel(kWidth / 2, kHeight / 2);
    QVERIFY(levels(middle, qRgb(0, 0, 0)) > 10);
    for (int y = 10; y < kHeight - 10; y += 5) {
        for (int x = 30; x < kWidth - 30; x += 5) {
            QVERIFY2(levels(image.pixel(x, y), middle) <= 1,
                     qPrintable(QStringLiteral("at %1, %2: %3").arg(x).arg(y).arg(image.pixel(x, y), 0, 16)));
        }
    }
}

/// Surfaces beside and behind the eye are seen as well.
void LightsTest::facesBehindTheEyeFaceIt() {
    TestScene scene;
    scene.add(*m_renderer, makeUvSphere(64, 32, 2.0f), glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.camera.setPivot(glm::vec3(0), 0.3f, 0.2f, 1.0f);
    frame.camera.setProjection(Projection::Orthographic);
    frame.lights = directional();
    frame.options.floor = false;
    const QImage smooth = picture(*m_renderer, frame, *pipeline, 1);
    frame.options.flat = true;
    const QImage flat = picture(*m_renderer, frame, *pipeline, 1);
    QVERIFY(levels(smooth.pixel(kWidth / 2, kHeight / 2), qRgb(0, 0, 0)) > 60);
    const int different = test::differing(flat, smooth, 40);
    QVERIFY2(different < kWidth * kHeight / 100, qPrintable(QString::number(different)));
}

void LightsTest::floorFollowsTheEquations_data() {
    pixelsFollowTheEquations_data();
}

void LightsTest::floorFollowsTheEquations() {
    // The floor has a light path of its own: with lights of two strengths its brightness keeps their ratio.
    QFETCH(Lights, lights);
    QFETCH(bool, orthographic);
    if (orthographic) {
        return;  // matte: no line of sight counts
    }
    TestScene scene;
    addSphere(scene, *m_renderer);
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame frame = frameOf(scene, kWidth, kHeight);
    frame.camera.setPivot(glm::vec3(0), 0.0f, 0.7f, 5.0f);
    frame.lights = lights;
    frame.lights.spot.direction = glm::vec3(-0.3f, -1.0f, -0.6f);
    frame.options.theme = Theme::Light;
    frame.targets = {};
    const QImage image = picture(*m_renderer, frame, *pipeline, 1);
    const glm::vec3 floor(0.86f, 0.87f, 0.89f);  // of the light theme
    int compared = 0;
    for (int y = 20; y < kHeight - 20; y += 3) {
        for (int x = 20; x < kWidth - 20; x += 3) {
            const glm::vec2 ndc(2.0f * (float(x) + 0.5f) / kWidth - 1.0f,
                                1.0f - 2.0f * (float(y) + 0.5f) / kHeight);
            const Ray ray = frame.camera.rayThrough(ndc, float(kWidth) / kHeight);
            if (ray.direction.y > -0.1f) {
                continue;
            }
            const glm::vec3 p =
                ray.origin + ray.direction * ((frame.floorHeight - ray.origin.y) / ray.direction.y);
            // Between the grid's lines, and where nothing fades yet.
            const auto toLine = [](float at) { return std::abs(at - std::round(at)); };
            if (glm::length(p) > 5.0f || toLine(p.x) < 0.25f || toLine(p.z) < 0.25f ||
                toLine(10.0f * p.x) < 0.4f || toLine(10.0f * p.z) < 0.4f) {
                continue;
            }
            // Matte: the same sum without highlights, with the floor's colour in place of the cube's.
            Lights matte = frame.lights;
            matte.directional.terms.specular = matte.spot.terms.specular = 0.0f;
            for (PointLight& point : matte.points) {
                point.terms.specular = 0.0f;
            }
            const glm::vec3 expected = light(matte, p, glm::vec3(0, 1, 0), frame.camera) / kDiffuse * floor;
            const QRgb wanted = qRgb(level(expected.r), level(expected.g), level(expected.b));
            QVERIFY2(levels(image.pixel(x, y), wanted) <= 2,
                     qPrintable(QStringLiteral("at %1, %2: %3, not %4")
                                    .arg(x)
                                    .arg(y)
                                    .arg(image.pixel(x, y), 0, 16)
                                    .arg(wanted, 0, 16)));
            ++compared;
        }
    }
    QVERIFY2(compared > 10, qPrintable(QString::number(compared)));
}

HITSCOPE_TEST(LightsTest, QCoreApplication)

}  // namespace hitscope::lights_test

#include "lights_test.moc"
