// SPDX-License-Identifier: GPL-3.0-or-later
// What is the uniform array pipeline's alone: how many hits it keeps, and the programs that draw with them.
#include <QTest>

#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "pipeline/hit_arrays.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::uniform_array_test {

using namespace test;

namespace {

constexpr std::size_t kLeastHits = 94;  // that fit into the uniforms that OpenGL 3.3 guarantees

PipelineOptions limits(std::optional<int> components, std::optional<int> blockBytes) {
    PipelineOptions options = pipelineOptions();
    options.vertexUniformComponents = components;
    options.uniformBlockBytes = blockBytes;
    return options;
}

/// As drivers have them: what each makes of the hits is the same.
struct Limits {
    const char* name;
    int components;
    int blockBytes;
    std::size_t hits;
};
constexpr Limits kDrivers[] = {{"much room", 16384, 65536, 600},
                               {"uniforms alone", 16384, 0, 600},
                               {"a block of 64 KiB", 4096, 65536, 600},
                               {"a block of 16 KiB", 1024, 16384, 454},
                               {"least uniforms", 1024, 0, kLeastHits}};

/// This driver's own, at most.
int uniformComponents() {
    GLint components = 0;
    glGetIntegerv(GL_MAX_VERTEX_UNIFORM_COMPONENTS, &components);
    return components;
}

/// In a test function: skips the row where this driver has fewer uniforms than the one it stands for.
#define HITSCOPE_NEEDS_UNIFORMS(limits)                           \
    do {                                                          \
        if (uniformComponents() < (limits).components) {          \
            QSKIP("this driver has fewer uniforms than the row"); \
        }                                                         \
    } while (false)

std::unique_ptr<DeformationPipeline> uniformArray(TestScene& scene,
                                                  const PipelineOptions& options = pipelineOptions()) {
    Result<std::unique_ptr<DeformationPipeline>> made = makePipeline(PipelineKind::UniformArray, options);
    if (!made) {
        qWarning("%s", made.error().message().c_str());
        return nullptr;
    }
    for (TestTarget& target : scene) {
        made.value()->addTarget(target.id, *target.buffers);
    }
    return std::move(made).value();
}

/// A program that computes what the drawing ones do, and can be read.
Result<gl::Program> drawingProgram(const DeformationPipeline& pipeline) {
    return gl::Program::build(
        {"capture.vert", {}, pipeline.drawDefines(), {"capturedPosition", "capturedNormal"}});
}

/// Every vertex of the target as the program in use draws it.
std::vector<DynamicVertex> drawn(const TestTarget& target) {
    const std::size_t count = target.mesh.vertices.size();
    const gl::Buffer buffer = gl::Buffer::make();
    const gl::Renderbuffer colour = gl::Renderbuffer::make();
    const gl::Framebuffer framebuffer = gl::Framebuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, colour.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.id());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.id());
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLsizeiptr>(count * sizeof(DynamicVertex)),
                 nullptr, GL_STREAM_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glBindVertexArray(target.buffers->captureArray());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindVertexArray(0);
    std::vector<DynamicVertex> vertices(count);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
                       static_cast<GLsizeiptr>(count * sizeof(DynamicVertex)), vertices.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return vertices;
}

}  // namespace

class UniformArrayTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
    }
    void cleanup() {
        glUseProgram(0);
        QCOMPARE(m_gl.errors(), QStringList());
    }

    void hitsThatFitInWhatTheDriverHas() {
        // 160 for all else, 15 for what goes with the arrays, nine a hit.
        QCOMPARE(hitsInUniforms(1024), kLeastHits);
        QCOMPARE(hitsInUniforms(4096), std::size_t{435});
        QCOMPARE(hitsInUniforms(16384), std::size_t{600});
        QCOMPARE(hitsInUniforms(10), std::size_t{4});  // below what OpenGL allows
        QCOMPARE(hitsInBlock(16384), std::size_t{454});
        QCOMPARE(hitsInBlock(65536), std::size_t{600});
        QCOMPARE(hitsInBlock(0), std::size_t{0});
        QVERIFY(kOtherUniformsInHits * 9 >= static_cast<std::size_t>(kOtherUniforms));
    }

    void everyHitHasConstantsOfItsOwn_data() {
        QTest::addColumn<int>("driver");
        QTest::addColumn<int>("kind");
        for (int driver = 0; driver < static_cast<int>(std::size(kDrivers)); ++driver) {
            for (const PipelineKind kind : {PipelineKind::UniformArray, PipelineKind::UniformArrayCulled}) {
                QTest::addRow("%s, %s", std::string(pipelineTraits(kind).key).c_str(), kDrivers[driver].name)
                    << driver << static_cast<int>(kind);
            }
        }
    }
    void everyHitHasConstantsOfItsOwn() {
        QFETCH(const int, driver);
        QFETCH(const int, kind);
        const Limits& has = kDrivers[driver];
        HITSCOPE_NEEDS_UNIFORMS(has);
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere")});
        const auto made =
            makePipeline(static_cast<PipelineKind>(kind), limits(has.components, has.blockBytes));
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
        DeformationPipeline& pipeline = *made.value();
        pipeline.addTarget(scene[0].id, *scene[0].buffers);
        const std::vector<Hit> hits = randomHits(scene, 19, 610, 610);
        Mirror mirror(scene);
        pipeline.append(hits);
        mirror.readBack(pipeline);
        QCOMPARE(pipeline.capacity().capacity, std::optional(has.hits));
        QCOMPARE(pipeline.capacity().byDriver, has.hits < 600);
        QCOMPARE(pipeline.capacity().dropped.size(), hits.size() - has.hits);
        QCOMPARE(differenceFromReference(mirror, scene, std::span(hits).last(has.hits)), QString());
    }

    void keepsTheLastHits_data() {
        QTest::addColumn<int>("step");
        QTest::newRow("all at once") << 1000;
        QTest::newRow("one at a time") << 1;
        QTest::newRow("in lots") << 37;
    }
    void keepsTheLastHits() {
        QFETCH(const int, step);
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere"), QStringLiteral("Low-poly cube")});
        const auto pipeline = uniformArray(scene, limits(1024, 0));
        QVERIFY(pipeline);
        QCOMPARE(pipeline->capacity().capacity, std::optional(kLeastHits));
        const std::vector<Hit> hits = randomHits(scene, 17, 400, 3);
        Mirror mirror(scene);
        for (std::size_t done = 0; done < hits.size();) {
            const std::size_t count = std::min(static_cast<std::size_t>(step), hits.size() - done);
            pipeline->append(std::span(hits).subspan(done, count));
            done += count;
            mirror.readBack(*pipeline);
            const std::size_t kept = std::min(done, kLeastHits);
            QCOMPARE(pipeline->capacity().dropped.size(), done - kept);
            if (done % 50 == 0 || done == hits.size()) {
                QCOMPARE(differenceFromReference(mirror, scene, std::span(hits).subspan(done - kept, kept)),
                         QString());
            }
        }
        pipeline->reset(std::span(hits).first(10));
        QCOMPARE(pipeline->capacity().dropped.size(), std::size_t{0});
        mirror.readBack(*pipeline);
        QCOMPARE(differenceFromReference(mirror, scene, std::span(hits).first(10)), QString());
    }

    // The paper's loop, over all hits of the scene, gives what readBack() reads.
    void drawingProgramsComputeWhatIsRead_data() {
        QTest::addColumn<int>("driver");
        for (int driver = 0; driver < static_cast<int>(std::size(kDrivers)); ++driver) {
            QTest::newRow(kDrivers[driver].name) << driver;
        }
    }
    void drawingProgramsComputeWhatIsRead() {
        QFETCH(const int, driver);
        HITSCOPE_NEEDS_UNIFORMS(kDrivers[driver]);
        TestScene scene = makeScene({QStringLiteral("Low-poly cube"), QStringLiteral("High-poly sphere")});
        const auto pipeline =
            uniformArray(scene, limits(kDrivers[driver].components, kDrivers[driver].blockBytes));
        QVERIFY(pipeline);
        Result<gl::Program> program = drawingProgram(*pipeline);
        Result<gl::Program> second = drawingProgram(*pipeline);
        QVERIFY(program.ok() && second.ok());
        const std::vector<Hit> hits = randomHits(scene, 29, 150, 4);
        Mirror mirror(scene);
        for (const std::size_t count : {0, 100, 150}) {
            pipeline->reset(std::span(hits).first(count));
            mirror.readBack(*pipeline);
            for (const gl::Program* drawing : {&program.value(), &second.value()}) {
                for (const TestTarget& target : scene) {
                    drawing->use();
                    pipeline->prepareDraw(*drawing, target.id);
                    QCOMPARE(difference(drawn(target), mirror.vertices(target.id)), QString());
                }
            }
        }
        // A target that the pipeline does not know is drawn as it is.
        program.value().use();
        pipeline->prepareDraw(program.value(), TargetId{99});
        QCOMPARE(difference(drawn(scene[1]), scene[1].mesh.vertices), QString());
    }

    // Uniforms belong to the program: whoever drew with it last left its hits there.
    void pipelinesThatShareAProgram() {
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere")});
        const auto one = uniformArray(scene);
        const auto other = uniformArray(scene);
        QVERIFY(one && other);
        const std::vector<Hit> hits = randomHits(scene, 37, 40);
        one->reset(std::span(hits).first(20));
        other->reset(std::span(hits).subspan(20));
        const Result<gl::Program> program = drawingProgram(*one);
        QVERIFY(program.ok());
        program.value().use();
        // Neither has changed since it last drew, and still each draws its own.
        Mirror mirror(scene);
        mirror.readBack(*one);
        one->prepareDraw(program.value(), scene[0].id);
        other->prepareDraw(program.value(), scene[0].id);
        QVERIFY(!difference(drawn(scene[0]), mirror.vertices(scene[0].id)).isEmpty());
        one->prepareDraw(program.value(), scene[0].id);
        QCOMPARE(difference(drawn(scene[0]), mirror.vertices(scene[0].id)), QString());
    }

    void feedbackDrawsTheBufferAsItIs() {
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere")});
        Result<std::unique_ptr<DeformationPipeline>> made =
            makePipeline(PipelineKind::TransformFeedback, pipelineOptions());
        QVERIFY(made.ok());
        DeformationPipeline& pipeline = *made.value();
        QVERIFY(!pipeline.capacity().capacity);
        pipeline.addTarget(scene[0].id, *scene[0].buffers);
        pipeline.append(randomHits(scene, 41, 30));
        const Result<gl::Program> program = drawingProgram(pipeline);
        QVERIFY(program.ok());
        program.value().use();
        pipeline.prepareDraw(program.value(), scene[0].id);
        Mirror mirror(scene);
        mirror.readBack(pipeline);
        QCOMPARE(difference(drawn(scene[0]), mirror.vertices(scene[0].id)), QString());
    }

private:
    GlFixture m_gl;
};

HITSCOPE_TEST(UniformArrayTest, QCoreApplication)

}  // namespace hitscope::uniform_array_test

#include "uniform_array_test.moc"
