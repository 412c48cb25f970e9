// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on each pipeline: it is what really comes of hits, edits and read-back on this renderer.
#include "pipeline/pipeline_trial.h"

#include <QTest>

#include "gl/context.h"
#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "pipeline/measure_exactness.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::pipeline_trial_test {

using namespace test;

namespace {

constexpr std::size_t kCountedWell = 4096;  // vertices of one draw, by some drivers

PipelineOptions ownOptions() {
    PipelineOptions options;
    options.deformDefines = definesOf(measureExactness().value());
    return options;
}

PipelineOptions withDefine(const char* name, const char* text) {
    PipelineOptions options;
    options.deformDefines = {{name, text}};
    return options;
}

bool deformsOnGpu(PipelineKind kind) {
    return kind != PipelineKind::Reference && !whyUnavailable(kind);
}

}  // namespace

class PipelineTrialTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void verdictIsWhatComesOut_data() { addPipelines(); }
    void verdictIsWhatComesOut() {
        QFETCH(const int, kind);
        const auto pipelineKind = static_cast<PipelineKind>(kind);
        const PipelineOptions options = ownOptions();
        const PipelineVerdict verdict = tryPipeline(pipelineKind, options);
        if (const auto reason = whyUnavailable(pipelineKind)) {
            QCOMPARE(verdict.whyNot, *reason);
            QVERIFY(!verdict.isExact());
            return;
        }
        QCOMPARE(verdict.whyNot, std::string());
        QVERIFY(verdict.compared.vertices > 3 * kCountedWell);
        // Another scene, with other hits.
        TestScene scene = makeScene({QStringLiteral("High-poly sphere")});
        auto made = makePipeline(pipelineKind, options);
        QVERIFY(made.ok());
        made.value()->addTarget(scene[0].id, *scene[0].buffers);
        const std::vector<Hit> hits = randomHits(scene, 3, 90, 90);
        Mirror mirror(scene);
        made.value()->append(hits);
        mirror.readBack(*made.value());
        const QString difference = differenceFromReference(mirror, scene, hits);
        QVERIFY2(verdict.isExact() == difference.isEmpty(), qPrintable(difference));
        if (measureExactness().value().isExact()) {
            QVERIFY2(verdict.isExact(), describe(verdict).c_str());
        }
        if (pipelineKind == PipelineKind::Reference) {
            QVERIFY(verdict.isExact());
        }
    }

    // A root that is a little off.
    void inexactArithmeticIsSeen_data() { addPipelines(); }
    void inexactArithmeticIsSeen() {
        QFETCH(const int, kind);
        const PipelineVerdict verdict = tryPipeline(
            static_cast<PipelineKind>(kind), withDefine("sqrt(x)", "(inversesqrt(x) * (x) * (1.0 + 2e-7))"));
        if (!deformsOnGpu(static_cast<PipelineKind>(kind))) {
            QVERIFY(verdict.isExact() || !verdict.whyNot.empty());
            return;
        }
        QVERIFY(!verdict.isExact());
        QVERIFY(verdict.compared.different > 100);
        QVERIFY(verdict.compared.different <= verdict.compared.vertices);
        QVERIFY(verdict.compared.largest > 0.0f);
    }

    // A driver that loses count in the middle of a draw.
    void vertexLateInADrawIsSeen() {
        const PipelineVerdict verdict =
            tryPipeline(PipelineKind::TransformFeedback,
                        withDefine("texelFetch(s, i)", "texelFetch(s, gl_VertexID < 4096 ? (i) : 0)"));
        QVERIFY(verdict.whyNot.empty());
        QVERIFY(!verdict.isExact());
    }

    void refusedProgramIsSaid_data() { addPipelines(); }
    void refusedProgramIsSaid() {
        QFETCH(const int, kind);
        const PipelineVerdict verdict =
            tryPipeline(static_cast<PipelineKind>(kind), withDefine("deform", "0"));
        QCOMPARE(verdict.whyNot.empty(), static_cast<PipelineKind>(kind) == PipelineKind::Reference);
        QCOMPARE(describe(verdict).starts_with("not compared: "), !verdict.whyNot.empty());
        static_cast<void>(gl::takeErrors());
    }

    void callersStateStays() {
        const gl::VertexArray array = gl::VertexArray::make();
        const gl::Buffer buffer = gl::Buffer::make();
        glBindVertexArray(array.id());
        glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
        for (const PipelineTraits& traits : allPipelines()) {
            static_cast<void>(tryPipeline(traits.kind));
            GLint boundArray = 0;
            GLint boundBuffer = 0;
            glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &boundArray);
            glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &boundBuffer);
            QCOMPARE(static_cast<GLuint>(boundArray), array.id());
            QCOMPARE(static_cast<GLuint>(boundBuffer), buffer.id());
            QCOMPARE(glIsEnabled(GL_RASTERIZER_DISCARD), static_cast<GLboolean>(GL_FALSE));
        }
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    void whatStandsIn() {
        const PipelineVerdict exact{{100, 0, 0.0f}, {}};
        const PipelineVerdict differs{{100, 3, 0.5f}, {}};
        RendererVerdict verdict;
        QVERIFY(!verdict.insteadOf(PipelineKind::TransformFeedback));  // not known yet
        verdict.pipelines = {{PipelineKind::UniformArray, exact},
                             {PipelineKind::TransformFeedback, exact},
                             {PipelineKind::Reference, exact}};
        QVERIFY(!verdict.insteadOf(PipelineKind::TransformFeedback));
        verdict.pipelines[PipelineKind::TransformFeedback] = differs;
        // Not one that forgets hits.
        QCOMPARE(verdict.insteadOf(PipelineKind::TransformFeedback), std::optional(PipelineKind::Reference));
        verdict.pipelines[PipelineKind::Compute] = exact;
        QCOMPARE(verdict.insteadOf(PipelineKind::TransformFeedback), std::optional(PipelineKind::Compute));
        verdict.pipelines[PipelineKind::Compute] = {{}, "There are no compute shaders."};
        verdict.pipelines[PipelineKind::Reference] = differs;
        QVERIFY(!verdict.insteadOf(PipelineKind::TransformFeedback));
    }

    void inWords() {
        RendererVerdict verdict;
        QCOMPARE(describe(verdict, PipelineKind::Compute), std::string("Compute: not compared yet"));
        verdict.pipelines[PipelineKind::Compute] = {{16140, 0, 0.0f}, {}};
        QCOMPARE(describe(verdict, PipelineKind::Compute),
                 std::string("Compute: bit-exact in 16,140 vertices compared"));
        verdict.pipelines[PipelineKind::Compute].compared = {16140, 12, 3.3f};
        QCOMPARE(describe(verdict, PipelineKind::Compute),
                 std::string("Compute: not bit-exact: 12 of 16,140 vertices differ, by up to 3.3 m"));
        QCOMPARE(describe(PickingVerdict{1000, 0, false, {}}), std::string("right in 1,000 pixels compared"));
        QCOMPARE(describe(PickingVerdict{1000, 0, true, {}}),
                 std::string("right in 1,000 pixels compared, through a geometry shader"));
        QCOMPARE(describe(PickingVerdict{1000, 7, false, {}}),
                 std::string("wrong in 7 of 1,000 pixels compared"));
    }

private:
    GlFixture m_gl;
};

HITSCOPE_TEST(PipelineTrialTest, QCoreApplication)

}  // namespace hitscope::pipeline_trial_test

#include "pipeline_trial_test.moc"
