// SPDX-License-Identifier: GPL-3.0-or-later
// Every way to draw the targets, against pictures that were looked at.
#include <epoxy/gl.h>

#include <QTest>
#include <algorithm>
#include <optional>

#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render_support.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::modes_test {

using namespace test;

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// Without the faces that have a corner above `height` (metres, local).
MeshData withoutTop(const MeshData& mesh, float height) {
    MeshData open = mesh;
    open.faceStarts = {0};
    open.cornerVertices.clear();
    open.cornerNormals.clear();
    open.cornerTexcoords.clear();
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        if (std::any_of(face.begin(), face.end(),
                        [&](std::uint32_t vertex) { return mesh.positions[vertex].y > height; })) {
            continue;
        }
        for (std::uint32_t corner = mesh.faceStarts[f]; corner < mesh.faceStarts[f + 1]; ++corner) {
            open.cornerVertices.push_back(mesh.cornerVertices[corner]);
            open.cornerNormals.push_back(mesh.cornerNormals[corner]);
        }
        open.faceStarts.push_back(static_cast<std::uint32_t>(open.cornerVertices.size()));
    }
    return open;
}

/// So wide and deep that the faces turn.
std::vector<Hit> deepDents() {
    std::vector<Hit> hits = dents({1}, 12);
    for (Hit& hit : hits) {
        hit.constants = {1.4f, 0.5f, 0.6f};
    }
    return hits;
}

/// A texture whose quarters and rows tell where a pixel is from.
MeshData withTexture(MeshData mesh) {
    constexpr int kSide = 32;
    Image image{kSide, kSide, std::vector<std::uint8_t>()};
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto stripe = static_cast<std::uint8_t>((y / 4) % 2 == 0 ? 60 : 220);
            const bool left = x < kSide / 2;
            image.pixels.insert(image.pixels.end(), {static_cast<std::uint8_t>(left ? 240 : 30), stripe,
                                                     static_cast<std::uint8_t>(left ? 40 : 230), 255});
        }
    }
    mesh.images = {image};
    Material material;
    material.diffuseImage = 0;
    mesh.materials = {material};
    mesh.faceMaterials.assign(mesh.faceCount(), 0);
    return mesh;
}

class ModesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup();
    void cleanupTestCase();
    void looksAsItDid_data();
    void looksAsItDid();
    void noModeLooksLikeAnother();
    void pipelinesAgree_data() { looksAsItDid_data(); }
    void pipelinesAgree();
    void linesAreAsWideAsThePixelRatioSays_data();
    void linesAreAsWideAsThePixelRatioSays();
    void linesPassTheEye();
    void farNeedlesAreFew();
    void shadowsFollow();

private:
    Frame frame(const DisplayOptions& options) const {
        Frame made = frameOf(sceneOf(options), kWidth, kHeight);
        made.camera.zoom(options.dots ? 0.45f : 0.75f);
        made.options = options;
        if (options.change.on) {
            const ChangeMapOptions& map = options.change;
            made.change = ShownChange{map.quantity, map.style().map, map.style().fixed,
                                      map.isolines ? 0.1f * map.style().fixed.high : 0.0f};
        }
        if (QLatin1String(QTest::currentDataTag()) == QLatin1String("only-dense")) {
            made.pixelRatio = 30.0f;  // edges count as shorter than a pixel
        }
        if (options.backFaces) {
            made.camera.orbit(0.0f, 0.4f);  // so that one looks into the bowl
        }
        return made;
    }

    template <class Row>
    static void addLooks(const Row& row);
    /// What a frame with these options shows.
    TestScene& sceneOf(const DisplayOptions& options) const {
        return options.backFaces  ? *m_bowl
               : isOf("textured") ? *m_textured
               : isOf("coloured") ? *m_coloured
                                  : *m_scene;
    }
    [[nodiscard]] const std::vector<Hit>& hitsOf(const DisplayOptions& options) const {
        return options.normals == NormalMode::True || isOf("textured") ? m_deepHits : m_hits;
    }
    static bool isOf(const char* kind) { return QByteArray(QTest::currentDataTag()).startsWith(kind); }
    /// Triangles that the pictures with and without needles differ by; none where the renderer counts none.
    std::optional<int> needleTriangles(Frame frame);

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<TestScene> m_scene;
    std::unique_ptr<TestScene> m_bowl;  ///< open at the top
    std::unique_ptr<TestScene> m_textured;
    std::unique_ptr<TestScene> m_coloured;
    std::vector<Hit> m_hits = dents({1}, 12);
    std::vector<Hit> m_deepHits = deepDents();  ///< for what normals show
};

void ModesTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
    if (!m_renderer) {
        return;
    }
    m_scene = std::make_unique<TestScene>();
    const glm::vec3 place(0.0f, 2.5f, 0.0f);
    m_scene->add(*m_renderer, makeUvSphere(24, 16, 2.5f), place);
    m_scene->showTrueNormals(m_deepHits);
    m_textured = std::make_unique<TestScene>();
    m_textured->add(*m_renderer, withTexture(makeUvSphere(24, 16, 2.5f)), place);
    m_textured->showTrueNormals(m_deepHits);
    m_coloured = std::make_unique<TestScene>();
    m_coloured->add(*m_renderer, withColours(makeUvSphere(24, 16, 2.5f)), place);
    m_bowl = std::make_unique<TestScene>();
    m_bowl->add(*m_renderer, withoutTop(makeUvSphere(24, 16, 2.5f), 1.0f), place);
}

void ModesTest::cleanup() {
    QCOMPARE(m_gl.errors(), QStringList());
}

void ModesTest::cleanupTestCase() {
    m_textured.reset();
    m_coloured.reset();
    m_bowl.reset();
    m_scene.reset();
    m_renderer.reset();
}

/// row: takes a name and how the options change.
template <class Row>
void ModesTest::addLooks(const Row& row) {
    row("look-matcap", [](DisplayOptions& o) { o.look = SurfaceLook::Matcap; });
    row("look-clay", [](DisplayOptions& o) {
        o.look = SurfaceLook::Clay;
        o.theme = Theme::Light;
    });
    row("look-metal", [](DisplayOptions& o) { o.look = SurfaceLook::Metal; });
    row("environment", [](DisplayOptions& o) { o.environment = true; });
    row("environment-metal", [](DisplayOptions& o) {
        o.environment = true;
        o.look = SurfaceLook::Metal;
        o.theme = Theme::Light;
    });
}

void ModesTest::looksAsItDid_data() {
    QTest::addColumn<DisplayOptions>("options");
    const auto row = [](const char* name, auto&& change) {
        DisplayOptions options;
        options.normals = NormalMode::Paper;
        change(options);
        QTest::newRow(name) << options;
    };
    row("plain", [](DisplayOptions&) {});
    row("true-normals", [](DisplayOptions& o) { o.normals = NormalMode::True; });
    row("true-needles", [](DisplayOptions& o) {
        o.normals = NormalMode::True;
        o.needles = true;
    });
    row("textured", [](DisplayOptions&) {});
    row("textured-true-normals", [](DisplayOptions& o) { o.normals = NormalMode::True; });
    row("coloured", [](DisplayOptions&) {});
    row("plain-light", [](DisplayOptions& o) { o.theme = Theme::Light; });
    row("over", [](DisplayOptions& o) { o.wireframe = WireframeMode::Over; });
    row("only", [](DisplayOptions& o) { o.wireframe = WireframeMode::Only; });
    row("only-dense", [](DisplayOptions& o) {
        o.wireframe = WireframeMode::Only;
        o.theme = Theme::Light;
    });
    row("flat", [](DisplayOptions& o) { o.flat = true; });
    row("back-faces", [](DisplayOptions& o) { o.backFaces = true; });
    row("needles", [](DisplayOptions& o) { o.needles = true; });
    row("dots", [](DisplayOptions& o) { o.dots = true; });
    row("map-displacement", [](DisplayOptions& o) { o.change.on = true; });
    row("map-isolines", [](DisplayOptions& o) {
        o.change.on = true;
        o.change.isolines = true;
        o.change.style().map = ColourMap::Cividis;
    });
    row("map-signed", [](DisplayOptions& o) {
        o.change.on = true;
        o.change.quantity = ChangeQuantity::AlongNormal;
        o.theme = Theme::Light;
    });
    row("ghost-wire", [](DisplayOptions& o) { o.beforeAfter.ghost = GhostMode::Wire; });
    row("ghost-translucent", [](DisplayOptions& o) { o.beforeAfter.ghost = GhostMode::Translucent; });
    row("wipe", [](DisplayOptions& o) {
        o.beforeAfter.wipe = true;
        o.beforeAfter.exaggeration = 12.0f;  // dents that are seen in so small a picture
    });
    row("exaggerated", [](DisplayOptions& o) { o.beforeAfter.exaggeration = 12.0f; });
    row("cut", [](DisplayOptions& o) { o.cut.on = true; });
    row("cut-filled", [](DisplayOptions& o) {
        o.cut.on = true;
        o.cut.fill = true;
        o.theme = Theme::Light;
    });
    addLooks(row);
    row("shadows", [](DisplayOptions& o) { o.shadows = true; });
    row("shadows-light", [](DisplayOptions& o) {
        o.shadows = true;
        o.theme = Theme::Light;
    });
}

void ModesTest::looksAsItDid() {
    QFETCH(DisplayOptions, options);
    HITSCOPE_NEEDS_SAMPLES();
    const auto pipeline = sceneOf(options).pipeline(PipelineKind::TransformFeedback, hitsOf(options));
    const QImage shown = picture(*m_renderer, frame(options), *pipeline);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    const int reach = name == QStringLiteral("dots") ? 1 : 0;
    const QString difference = differenceFromBaseline(shown, name, reach);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
    if (name != QStringLiteral("plain")) {
        Frame plain = frame(options);
        plain.options =
            DisplayOptions{.normals = NormalMode::Paper, .textures = false, .vertexColours = false};
        plain.change = std::nullopt;
        QVERIFY(differing(shown, picture(*m_renderer, plain, *pipeline), kDifferentLevels) > 200);
    }
}

void ModesTest::noModeLooksLikeAnother() {
    // What is let through of one picture must not be another: else one way to draw could take another's
    // place.
    std::vector<std::pair<QString, QImage>> pictures;
    for (const QString& file :
         QDir(QStringLiteral(HITSCOPE_BASELINES)).entryList({QStringLiteral("*.png")})) {
        pictures.emplace_back(file, QImage(QDir(QStringLiteral(HITSCOPE_BASELINES)).filePath(file)));
    }
    QVERIFY(pictures.size() > 24);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const QImage& one = pictures[i].second;
            const QImage& other = pictures[k].second;
            if (one.size() != other.size()) {
                continue;
            }
            const int apart = differing(one, other, kDifferentLevels);
            QVERIFY2(apart > 2.0 * kMostDifferent * one.width() * one.height(),
                     qPrintable(QStringLiteral("%1 and %2: %3 pixels")
                                    .arg(pictures[i].first, pictures[k].first)
                                    .arg(apart)));
        }
    }
}

void ModesTest::pipelinesAgree() {
    QFETCH(DisplayOptions, options);
    const auto feedback = sceneOf(options).pipeline(PipelineKind::TransformFeedback, hitsOf(options));
    const QImage first = picture(*m_renderer, frame(options), *feedback);
    const auto uniforms = sceneOf(options).pipeline(PipelineKind::UniformArray, hitsOf(options));
    QCOMPARE(differing(first, picture(*m_renderer, frame(options), *uniforms)), 0);
}

void ModesTest::linesAreAsWideAsThePixelRatioSays_data() {
    QTest::addColumn<float>("ratio");
    QTest::newRow("1") << 1.0f;
    QTest::newRow("1.5") << 1.5f;
    QTest::newRow("2") << 2.0f;
}

void ModesTest::linesAreAsWideAsThePixelRatioSays() {
    // The upright edges of a cube's front: their light, added up across, is their width.
    QFETCH(float, ratio);
    TestScene scene;
    scene.add(*m_renderer, makeCube(1, 1.0f), glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Frame cube = frameOf(scene, 240, 180);
    cube.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 6.0f);
    cube.pixelRatio = ratio;
    cube.options.floor = false;
    cube.options.wireframe = WireframeMode::Only;
    const QImage lines = picture(*m_renderer, cube, *pipeline, 1);
    cube.targets = {};
    const QImage background = picture(*m_renderer, cube, *pipeline, 1);
    double sum = 0.0;
    for (int x = 60; x < 90; ++x) {
        sum += qGreen(lines.pixel(x, 90)) - qGreen(background.pixel(x, 90));
    }
    const double full = 0.85 * (0.85 * 255.0 - qGreen(background.pixel(75, 90)));  // the theme's line
    // The far edge is dimmed and lies inside; it adds a sixth.
    QVERIFY2(std::abs(sum / full - 1.16 * 1.2 * ratio) < 0.2 * ratio,
             qPrintable(QString::number(sum / full)));
}

void ModesTest::linesPassTheEye() {
    // From within a target edges go on behind the eye: what is in front of it is there, and nothing else.
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    Frame inside = frame(DisplayOptions{.wireframe = WireframeMode::Only, .floor = false, .needles = true});
    inside.camera.setPivot(glm::vec3(0.0f, 2.5f, -1.0f), 0.0f, 0.1f, 0.9f);
    const QImage shown = picture(*m_renderer, inside, *pipeline);
    inside.targets = {};
    const int lines = differing(shown, picture(*m_renderer, inside, *pipeline), kDifferentLevels);
    QVERIFY2(lines > 300 && lines < kWidth * kHeight / 2, qPrintable(QString::number(lines)));
}

std::optional<int> ModesTest::needleTriangles(Frame frame) {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    int triangles[2] = {};
    for (const bool needles : {false, true}) {
        frame.options.needles = needles;
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_PRIMITIVES_GENERATED, query);
        static_cast<void>(picture(*m_renderer, frame, *pipeline));  // fails the test where it does
        glEndQuery(GL_PRIMITIVES_GENERATED);
        glGetQueryObjectiv(query, GL_QUERY_RESULT, &triangles[needles ? 1 : 0]);
        glDeleteQueries(1, &query);
    }
    return triangles[0] == 0 ? std::nullopt : std::optional(triangles[1] - triangles[0]);
}

void ModesTest::farNeedlesAreFew() {
    // Seen from far away, needles that could be told apart would lie further apart in the buffer than GL
    // allows.
    Frame view = frame(DisplayOptions{});
    view.camera.setSceneRadius(5000.0f);
    view.camera.zoom(0.2f);
    const std::optional<int> near = needleTriangles(view);
    if (!near && !QTest::currentTestFailed()) {
        QSKIP("this renderer does not count triangles");
    }
    view.camera.zoom(1000.0f);
    const std::optional<int> far = needleTriangles(view);
    // Two triangles a needle; the sphere has some 400 vertices.
    QVERIFY(near && far);
    QVERIFY2(*near > 200 && *far > 0 && *far < 30, qPrintable(QStringLiteral("%1, %2").arg(*near).arg(*far)));
}

void ModesTest::shadowsFollow() {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    Frame shadowed = frame(DisplayOptions{.shadows = true});
    shadowed.meshRevision = 1;
    const QImage before = picture(*m_renderer, shadowed, *pipeline);
    QCOMPARE(differing(before, picture(*m_renderer, shadowed, *pipeline)), 0);
    // Another light, another shadow; and none without the light.
    shadowed.lights.directional.direction.x *= -1.0f;
    QVERIFY(differing(before, picture(*m_renderer, shadowed, *pipeline), kDifferentLevels) > 500);
    shadowed.lights.directional.on = false;
    Frame plain = shadowed;
    plain.options.shadows = false;
    QCOMPARE(differing(picture(*m_renderer, shadowed, *pipeline), picture(*m_renderer, plain, *pipeline)), 0);
    // A target that moves takes its shadow along.
    shadowed.lights.directional.on = true;
    shadowed.lights.directional.direction.x *= -1.0f;
    std::vector<DrawItem> items(m_scene->items().begin(), m_scene->items().end());
    items[0].model[3].y += 40.0f;  // out of the picture, and its shadow out of the way
    shadowed.targets = items;
    shadowed.camera.orbit(0.0f, 0.6f);
    const QImage without = picture(*m_renderer, shadowed, *pipeline);
    shadowed.options.shadows = false;
    QVERIFY(differing(without, picture(*m_renderer, shadowed, *pipeline), kDifferentLevels) < 100);
}

HITSCOPE_TEST(ModesTest, QCoreApplication)

}  // namespace hitscope::modes_test

#include "modes_test.moc"
