// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every pipeline: whatever is done in whatever order, each target is its original with its
// hits applied in order, in every bit as the C++ reference has it.
#include <QTest>
#include <cstring>
#include <glm/geometric.hpp>

#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::pipelines_test {

using namespace test;

namespace {

void addPipelineRows(const QString& suffix = {}) {
    for (const PipelineTraits& traits : allPipelines()) {
        const QString name = QString::fromUtf8(traits.name);
        QTest::newRow(qPrintable(name + suffix)) << static_cast<int>(traits.kind);
    }
}

}  // namespace

class PipelinesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void equalsReference_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("hits");
        QTest::addColumn<int>("constants");
        QTest::addColumn<QStringList>("meshes");
        const auto add = [](const QByteArray& name, PipelineKind kind, int hits, int constants,
                            const QStringList& meshes) {
            QTest::newRow(name.constData()) << static_cast<int>(kind) << hits << constants << meshes;
        };
        const QStringList sphere{QStringLiteral("High-poly sphere")};
        const QStringList cube{QStringLiteral("High-poly cube")};
        const QStringList four{QStringLiteral("Low-poly cube"), QStringLiteral("High-poly sphere"),
                               QStringLiteral("Low-poly sphere"), QStringLiteral("High-poly cube")};
        for (const PipelineTraits& traits : allPipelines()) {
            const QByteArray key(traits.key.data(), static_cast<qsizetype>(traits.key.size()));
            const bool isLimited = !traits.keepsAll;
            add(key + ", sphere", traits.kind, isLimited ? 600 : 1500, 1, sphere);
            add(key + ", cube, many constants", traits.kind, isLimited ? 600 : 1500, isLimited ? 600 : 1500,
                cube);
            add(key + ", four targets", traits.kind, isLimited ? 600 : 2000, 7, four);
        }
    }
    void equalsReference() {
        QFETCH(const int, kind);
        QFETCH(const int, hits);
        QFETCH(const int, constants);
        QFETCH(const QStringList, meshes);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene(meshes);
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        const std::vector<Hit> history =
            randomHits(scene, 7, static_cast<std::size_t>(hits), static_cast<std::size_t>(constants));
        Mirror mirror(scene);
        pipeline->reset(history);
        mirror.readBack(*pipeline);
        QCOMPARE(differenceFromReference(mirror, scene, history), QString());
        QCOMPARE(pipeline->capacity().dropped.size(), std::size_t{0});
        QVERIFY(!difference(mirror.vertices(scene[0].id), scene[0].mesh.vertices).isEmpty());
    }

    void hitsOnOneSpotEqualReference_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    // A vertex reached by more hits than fit into one capture takes them all in order.
    void hitsOnOneSpotEqualReference() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        std::vector<Hit> hits = randomHits(scene, 11, 300, 5);
        for (Hit& hit : hits) {
            hit.point = scene[0].mesh.vertices[100].position + 0.1f * hit.direction;
        }
        Mirror mirror(scene);
        pipeline->append(hits);
        mirror.readBack(*pipeline);
        QCOMPARE(differenceFromReference(mirror, scene, hits), QString());
    }

    void splitNormalsLeaveNoCracks_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    void splitNormalsLeaveNoCracks() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly cube")});
        const RenderMesh& mesh = scene[0].mesh;
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        Mirror mirror(scene);
        pipeline->reset(randomHits(scene, 3, 600));
        mirror.readBack(*pipeline);
        const std::span<const DynamicVertex> vertices = mirror.vertices(scene[0].id);
        std::size_t shared = 0;
        for (std::uint32_t v = 0; v + 1 < mesh.fileVertexStarts.size(); ++v) {
            const std::span<const std::uint32_t> copies = mesh.renderVerticesOf(v);
            for (const std::uint32_t copy : copies) {
                QCOMPARE(std::memcmp(&vertices[copy].position, &vertices[copies[0]].position, 12), 0);
            }
            shared += copies.size() > 1 ? 1 : 0;
        }
        QCOMPARE(shared, std::size_t{12 * 31 + 8});  // the cube's edges and corners
    }

    void anySequenceEqualsAFreshReset_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    void anySequenceEqualsAFreshReset() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere"), QStringLiteral("High-poly cube")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        const std::vector<Hit> hits = randomHits(scene, 5, 400, 3);
        const std::span<const Hit> all(hits);
        Mirror mirror(scene);
        const auto check = [&](std::size_t count) {
            mirror.readBack(*pipeline);
            return differenceFromReference(mirror, scene, all.first(count));
        };

        for (std::size_t i = 0; i < 10; ++i) {  // one at a time, as they arrive
            pipeline->append(all.subspan(i, 1));
            QCOMPARE(check(i + 1), QString());
        }
        pipeline->append(all.subspan(10, 90));  // several appends before one read
        pipeline->append(all.subspan(100, 0));
        pipeline->append(all.subspan(100, 200));
        QCOMPARE(check(300), QString());
        pipeline->reset(all.first(299));  // undo: what the last hit moved is delivered, too
        QCOMPARE(check(299), QString());
        pipeline->append(all.subspan(299));
        pipeline->reset(all.first(20));  // never read: goes back without having been seen
        pipeline->append(all.subspan(20, 5));
        QCOMPARE(check(25), QString());
        pipeline->reset({});
        QCOMPARE(check(0), QString());
        QCOMPARE(mirror.readBack(*pipeline), std::size_t{0});
    }

    void onlyWhatMayHaveChangedIsRead_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    void onlyWhatMayHaveChangedIsRead() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        Mirror mirror(scene);
        pipeline->reset({});
        QCOMPARE(mirror.readBack(*pipeline), std::size_t{0});
        const std::vector<Hit> hits = randomHits(scene, 9, 2);
        pipeline->append(std::span(hits).first(1));
        const std::size_t first = mirror.readBack(*pipeline);
        QVERIFY(first > 0 && first < scene[0].mesh.vertices.size() / 3);
        QCOMPARE(mirror.readBack(*pipeline), std::size_t{0});
        pipeline->append(std::span(hits).subspan(1));
        QVERIFY(mirror.readBack(*pipeline) < scene[0].mesh.vertices.size() / 3);
        QCOMPARE(differenceFromReference(mirror, scene, hits), QString());
    }

    void workStaysWithTheHits_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<bool>("read");
        for (const PipelineTraits& traits : allPipelines()) {
            const QByteArray name(traits.key.data(), static_cast<qsizetype>(traits.key.size()));
            QTest::newRow(qPrintable(name + ", read after each hit"))
                << static_cast<int>(traits.kind) << true;
        }
        QTest::newRow("transform-feedback, a history at once")
            << static_cast<int>(PipelineKind::TransformFeedback) << false;
    }
    // However many hits came before, a hit reaches only what is near it.
    void workStaysWithTheHits() {
        QFETCH(const int, kind);
        QFETCH(const bool, read);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        const std::vector<Hit> hits = randomHits(scene, 47, 500);
        Mirror mirror(scene);
        if (!read) {
            pipeline->append(hits);
            mirror.readBack(*pipeline);
        }
        std::size_t delivered = 0;
        for (const Hit& hit : read ? hits : randomHits(scene, 53, 50)) {
            pipeline->append(std::span(&hit, 1));
            delivered += mirror.readBack(*pipeline);
        }
        QVERIFY(delivered / (read ? hits.size() : 50) < scene[0].mesh.vertices.size() / 3);
    }

    void vertexPushedFarOutIsFound_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    // Each hit strikes where the one before has left the vertex, metres outside the original mesh.
    void vertexPushedFarOutIsFound() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        const std::size_t vertex = 10;
        const glm::vec3 outwards = scene[0].mesh.vertices[vertex].normal;
        std::vector<Hit> hits;
        Mirror mirror(scene);
        for (int i = 0; i < 40; ++i) {
            const glm::vec3 there = mirror.vertices(scene[0].id)[vertex].position;
            hits.push_back({scene[0].id, there, outwards, {}});
            pipeline->append(std::span(hits).last(1));
            mirror.readBack(*pipeline);
        }
        QCOMPARE(differenceFromReference(mirror, scene, hits), QString());
        QVERIFY(glm::length(mirror.vertices(scene[0].id)[vertex].position) > 10.0f);
    }

    void targetsComeAndGo_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    void targetsComeAndGo() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("Low-poly cube"), QStringLiteral("Low-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        std::vector<Hit> hits = randomHits(scene, 13, 100);
        std::vector<Hit> withUnknown = hits;
        withUnknown.insert(withUnknown.begin() + 50, Hit{TargetId{99}, {}, {0, 0, -1}, {}});
        Mirror mirror(scene);
        pipeline->reset(withUnknown);
        mirror.readBack(*pipeline);
        QCOMPARE(differenceFromReference(mirror, scene, hits), QString());

        pipeline->removeTarget(scene[0].id);
        pipeline->append(hits);  // the cube's are now on an unknown target
        mirror.readBack(*pipeline);
        std::vector<Hit> expected = hits;
        for (const Hit& hit : hits) {
            if (hit.target == scene[1].id) {
                expected.push_back(hit);
            }
        }
        QCOMPARE(differenceFromReference(mirror, scene, expected), QString());
    }

    void whatWasAskedOfATargetThatIsGoneIsDropped_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    /// Another one has its number before it arrives.
    void whatWasAskedOfATargetThatIsGoneIsDropped() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene gone = makeScene({QStringLiteral("Low-poly cube")});
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), gone);
        QVERIFY(pipeline);
        Mirror before(gone);
        pipeline->append(randomHits(gone, 1, 50));
        before.poll(*pipeline);
        pipeline->reset({});
        pipeline->removeTarget(gone[0].id);
        pipeline->addTarget(scene[0].id, *scene[0].buffers);
        Mirror mirror(scene);
        mirror.readBack(*pipeline);
        QCOMPARE(differenceFromReference(mirror, scene, {}), QString());
    }

    void callersStateIsKept_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    void callersStateIsKept() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("Low-poly cube")});
        const gl::Framebuffer framebuffer = gl::Framebuffer::make();
        const gl::VertexArray vertexArray = gl::VertexArray::make();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glBindVertexArray(vertexArray.id());
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        pipeline->reset(randomHits(scene, 1, 10));
        Mirror mirror(scene);
        mirror.readBack(*pipeline);
        const auto bound = [](GLenum name) {
            GLint value = -1;
            glGetIntegerv(name, &value);
            return static_cast<GLuint>(value);
        };
        QCOMPARE(bound(GL_DRAW_FRAMEBUFFER_BINDING), framebuffer.id());
        QCOMPARE(bound(GL_READ_FRAMEBUFFER_BINDING), framebuffer.id());
        QCOMPARE(bound(GL_VERTEX_ARRAY_BINDING), vertexArray.id());
        QCOMPARE(bound(GL_CURRENT_PROGRAM), GLuint{0});
        QCOMPARE(glIsEnabled(GL_RASTERIZER_DISCARD), GLboolean{GL_FALSE});
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glBindVertexArray(0);
    }

    void hugeMeshGoesInPieces_data() {
        QTest::addColumn<int>("kind");
        addPipelineRows();
    }
    // More vertices than one capture holds, all of them reached by every hit.
    void hugeMeshGoesInPieces() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene;
        scene.emplace_back(1u, pointCloud(21, (1u << 20) + 1000u, 1.0f));
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        std::vector<Hit> hits = randomHits(scene, 23, 2);
        for (Hit& hit : hits) {
            hit.constants.maxDistance = 5.0f;
        }
        Mirror mirror(scene);
        for (const Hit& hit : hits) {
            pipeline->append(std::span(&hit, 1));
            QCOMPARE(mirror.readBack(*pipeline), scene[0].mesh.vertices.size());
        }
        QCOMPARE(differenceFromReference(mirror, scene, hits), QString());
    }

private:
    GlFixture m_gl;
};

HITSCOPE_TEST(PipelinesTest, QCoreApplication)

}  // namespace hitscope::pipelines_test

#include "pipelines_test.moc"
