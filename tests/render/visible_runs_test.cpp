// SPDX-License-Identifier: GPL-3.0-or-later
// Edges and triangles beside the picture are passed over: fewer are drawn, and the picture stays the same.
#include "render/seen/visible_runs.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "drawn_share_support.h"
#include "gl/pipeline_rows.h"
#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render/original_shape.h"
#include "render_support.h"
#include "secretive_pipeline.h"
#include "support/baseline.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::visible_runs_test {

using namespace test;

namespace {

constexpr float kRadius = 2.5f;

/// A fence: quads of a hundred metres' height, a tenth wide.
MeshData fence() {
    constexpr std::uint32_t kColumns = 200;
    MeshData mesh;
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
        const float x = 0.1f * (static_cast<float>(column) - 0.5f * kColumns);
        mesh.positions.insert(mesh.positions.end(), {{x, -50.0f, 0.0f}, {x, 50.0f, 0.0f}});
    }
    mesh.faceStarts = {0};
    for (std::uint32_t column = 0; column < kColumns; ++column) {
        const std::uint32_t low = 2 * column;
        mesh.cornerVertices.insert(mesh.cornerVertices.end(), {low, low + 2, low + 3, low + 1});
        mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.cornerVertices.size()));
    }
    return mesh;
}

}  // namespace

class VisibleRunsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase();
    void theSamePicture_data();
    void theSamePicture();
    void whatCrossesThePicture_data();
    void whatCrossesThePicture();
    void originalsToo();
    void nothingBehindTheEye();
    void notKnownWhereExaggerated();

private:
    Frame near(int step) const {
        Frame frame = frameOf(*m_scene, 240, 160);
        const float turn = 0.5f + 0.35f * static_cast<float>(step);
        const glm::vec3 side(std::sin(turn), 0.3f, std::cos(turn));
        frame.camera.setPivot(kRadius * glm::normalize(side), turn, 0.2f, 0.5f);
        return frame;
    }
    [[nodiscard]] std::size_t indicesOf(const Frame& frame, const DeformationPipeline& pipeline) const {
        const TargetBuffers& buffers = *frame.targets[0].buffers;
        return countOf(frame, pipeline, buffers.edgeRuns(), buffers.edgeIndexCount());
    }
    [[nodiscard]] std::size_t trianglesOf(const Frame& frame, const DeformationPipeline& pipeline) const {
        const TargetBuffers& buffers = *frame.targets[0].buffers;
        return countOf(frame, pipeline, buffers.triangleRuns(), buffers.triangleIndexCount());
    }
    /// More than all: what is seen is not known.
    [[nodiscard]] static std::size_t countOf(const Frame& frame, const DeformationPipeline& pipeline,
                                             const ClusterRuns& runs, std::uint32_t all) {
        const float aspect = static_cast<float>(frame.width) / static_cast<float>(frame.height);
        const DrawItem& item = frame.targets[0];
        const render::Sight sight(frame.camera.projection(aspect) * frame.camera.view() * item.model, {});
        const auto seen = render::visibleRuns(item, frame, pipeline, sight, runs, {0, all});
        return seen ? hitscope::countOf(*seen) : std::size_t{all} + 1;
    }

    GlFixture m_gl;
    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<TestScene> m_scene;
};

void VisibleRunsTest::initTestCase() {
    m_renderer = openRenderer(m_gl);
    if (!m_renderer) {
        return;
    }
    m_scene = std::make_unique<TestScene>();
    m_scene->add(*m_renderer, makeUvSphere(160, 100, kRadius), glm::vec3(0));
}

void VisibleRunsTest::cleanupTestCase() {
    m_scene.reset();
    m_renderer.reset();
}

void VisibleRunsTest::theSamePicture_data() {
    QTest::addColumn<PipelineKind>("kind");
    QTest::addColumn<WireframeMode>("mode");
    for (const PipelineKind kind : {PipelineKind::TransformFeedback, PipelineKind::UniformArray}) {
        const char* name = kind == PipelineKind::UniformArray ? "uniform array" : "feedback";
        QTest::addRow("%s, over", name) << kind << WireframeMode::Over;
        QTest::addRow("%s, only", name) << kind << WireframeMode::Only;
        QTest::addRow("%s, surfaces", name) << kind << WireframeMode::Off;
    }
}

void VisibleRunsTest::theSamePicture() {
    QFETCH(PipelineKind, kind);
    QFETCH(WireframeMode, mode);
    HITSCOPE_NEEDS_EXACT_ARITHMETIC();  // or the programs put an edge a pixel apart
    const auto pipeline = m_scene->pipeline(kind, deepDents());
    Secretive secretive(*pipeline);
    const std::size_t all = m_scene->items()[0].buffers->edgeIndexCount();
    for (int step = 0; step < 6; ++step) {
        Frame frame = near(step);
        frame.options.wireframe = mode;
        const QImage shown = picture(*m_renderer, frame, *pipeline);
        QCOMPARE(differing(shown, picture(*m_renderer, frame, secretive), blendedLevels()), 0);
        const std::size_t drawn = indicesOf(frame, *pipeline);
        QVERIFY2(drawn > 100 && drawn < 3 * all / 4, qPrintable(QString::number(drawn)));
        const std::size_t corners = trianglesOf(frame, *pipeline);
        QVERIFY2(
            corners > 100 && corners < 3 * std::size_t{m_scene->items()[0].buffers->triangleIndexCount()} / 4,
            qPrintable(QString::number(corners)));
    }
}

void VisibleRunsTest::whatCrossesThePicture_data() {
    QTest::addColumn<WireframeMode>("mode");
    QTest::newRow("edges") << WireframeMode::Only;
    QTest::newRow("triangles") << WireframeMode::Off;
}

void VisibleRunsTest::whatCrossesThePicture() {
    QFETCH(WireframeMode, mode);
    // Its ends lie beside it.
    TestScene scene;
    scene.add(*m_renderer, fence(), glm::vec3(0));
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    Secretive secretive(*pipeline);
    Frame frame = frameOf(scene, 240, 160);
    frame.camera.setPivot(glm::vec3(0), 0.0f, 0.0f, 2.0f);
    frame.options.wireframe = mode;
    const QImage shown = picture(*m_renderer, frame, *pipeline);
    QCOMPARE(differing(shown, picture(*m_renderer, frame, secretive)), 0);
    frame.targets = {};
    QVERIFY(differing(shown, picture(*m_renderer, frame, *pipeline)) > 1000);
}

void VisibleRunsTest::originalsToo() {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, deepDents());
    std::vector<DrawItem> items(m_scene->items().begin(), m_scene->items().end());
    items[0].original = true;
    Frame frame = near(0);
    frame.targets = items;
    const render::OriginalShape shape;
    const std::size_t drawn = indicesOf(frame, shape);
    QVERIFY2(drawn > 100 && drawn < std::size_t{3} * items[0].buffers->edgeIndexCount() / 4,
             qPrintable(QString::number(drawn)));
}

void VisibleRunsTest::nothingBehindTheEye() {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, {});
    Frame frame = near(0);
    frame.camera.setPivot(glm::vec3(0.0f, 0.0f, -20.0f), 0.0f, 0.0f, 1.0f);
    QVERIFY(frame.camera.forward().z < -0.9f);
    QCOMPARE(indicesOf(frame, *pipeline), std::size_t{0});
}

void VisibleRunsTest::notKnownWhereExaggerated() {
    const auto pipeline = m_scene->pipeline(PipelineKind::TransformFeedback, deepDents());
    Frame frame = near(0);
    frame.options.beforeAfter.exaggeration = 5.0f;
    QVERIFY(indicesOf(frame, *pipeline) > m_scene->items()[0].buffers->edgeIndexCount());
}

HITSCOPE_TEST(VisibleRunsTest, QCoreApplication)

}  // namespace hitscope::visible_runs_test

#include "visible_runs_test.moc"
