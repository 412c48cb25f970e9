// SPDX-License-Identifier: GPL-3.0-or-later
// What is the uniform array pipeline's alone: how many hits it keeps, and the programs that draw with them.
#include <QTest>

#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "pipeline/hit_arrays.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope {

using namespace test;

namespace {

constexpr PipelineOptions kLeastLimits{1024, {}};  // what OpenGL 3.3 guarantees

std::unique_ptr<DeformationPipeline> uniformArray(TestScene& scene, const PipelineOptions& limits = {}) {
    Result<std::unique_ptr<DeformationPipeline>> made = makePipeline(PipelineKind::UniformArray, limits);
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

    void hitsThatFitInWhatTheDriverHas_data() {
        QTest::addColumn<int>("components");
        QTest::addColumn<bool>("registers");
        QTest::addColumn<std::size_t>("hits");
        // Tight: 160 + 16 * 3 + 3 others, 25 for four hits. Registers: 160 + 16 * 4 + 12, 36 for four hits.
        QTest::newRow("least") << 1024 << false << std::size_t{128};
        QTest::newRow("least, in registers") << 1024 << true << std::size_t{84};
        QTest::newRow("common") << 4096 << false << std::size_t{600};
        QTest::newRow("common, in registers") << 4096 << true << std::size_t{428};
        QTest::newRow("software") << 16384 << false << std::size_t{600};
        QTest::newRow("below what OpenGL allows") << 10 << false << std::size_t{4};
    }
    void hitsThatFitInWhatTheDriverHas() {
        QFETCH(const int, components);
        QFETCH(const bool, registers);
        QFETCH(const std::size_t, hits);
        QCOMPARE(hitsThatFit(components, registers ? UniformPacking::Registers : UniformPacking::Tight),
                 hits);
    }

    void otherUniformsInHitsAreEnough() {
        QVERIFY(kOtherUniformsInHits * 25 / 4 >= static_cast<std::size_t>(kOtherUniforms));
        QVERIFY(kOtherUniformsInHits * 36 / 4 >= static_cast<std::size_t>(kOtherUniforms));
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
        const auto pipeline = uniformArray(scene, kLeastLimits);
        QVERIFY(pipeline);
        QCOMPARE(pipeline->capacity().capacity, std::optional<std::size_t>(128));
        const std::vector<Hit> hits = randomHits(scene, 17, 400, 3);
        Mirror mirror(scene);
        for (std::size_t done = 0; done < hits.size();) {
            const std::size_t count = std::min(static_cast<std::size_t>(step), hits.size() - done);
            pipeline->append(std::span(hits).subspan(done, count));
            done += count;
            mirror.readBack(*pipeline);
            const std::size_t kept = std::min<std::size_t>(done, 128);
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

    // Of the hits with more different constants than the palette holds, the newest count.
    void keepsHitsWhoseConstantsFit() {
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere")});
        const auto pipeline = uniformArray(scene);
        QVERIFY(pipeline);
        std::vector<Hit> hits = randomHits(scene, 19, 100);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            hits[i].constants = testConstants(i / 5);  // 20 different, 5 hits each
        }
        Mirror mirror(scene);
        pipeline->reset(hits);
        mirror.readBack(*pipeline);
        QCOMPARE(pipeline->capacity().dropped.size(), std::size_t{20});
        QCOMPARE(differenceFromReference(mirror, scene, std::span(hits).subspan(20)), QString());
        const std::vector<Hit> more(1, hits.back());
        pipeline->append(more);
        QCOMPARE(pipeline->capacity().dropped.size(), std::size_t{20});
    }

    // The paper's loop, over all hits of the scene, gives what readBack() reads.
    void drawingProgramsComputeWhatIsRead_data() {
        QTest::addColumn<bool>("least");
        QTest::newRow("all that the driver has") << false;
        QTest::newRow("least limits") << true;
    }
    void drawingProgramsComputeWhatIsRead() {
        QFETCH(const bool, least);
        TestScene scene = makeScene({QStringLiteral("Low-poly cube"), QStringLiteral("High-poly sphere")});
        const auto pipeline = uniformArray(scene, least ? kLeastLimits : PipelineOptions{});
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
        Result<std::unique_ptr<DeformationPipeline>> made = makePipeline(PipelineKind::TransformFeedback);
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

}  // namespace hitscope

HITSCOPE_TEST(hitscope::UniformArrayTest, QCoreApplication)
#include "uniform_array_test.moc"
