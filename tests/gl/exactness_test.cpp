// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/measure_exactness.h"

#include <epoxy/gl.h>

#include <QTest>
#include <array>

#include "gl/objects.h"
#include "gl/pipeline_rows.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::exactness_test {

namespace {

using Defines = std::vector<std::pair<std::string, std::string>>;

/// A renderer that takes the root as many graphics processors do, a little off.
const Defines::value_type kSlantedRoot = {"sqrt(x)", "(inversesqrt(x) * (x) * (1.0 + 2e-7))"};
/// One with a fused fma: in double every residual is exact. (llvmpipe's own rounds twice.)
const Defines::value_type kFusedFma = {"fma(a, b, c)",
                                       "float(double(a) * double(b) + double(c))\n"
                                       "#extension GL_ARB_gpu_shader_fp64 : enable"};
/// And one whose fma corrects nothing.
const Defines::value_type kNoFma = {"fma(a, b, c)", "((a) * (b) * 1.0000002 + (c))"};

/// Of every renderer but the one whose arithmetic is known not to be exact, and those of graphics processors.
bool mustBeExact() {
    const QByteArray renderer = qgetenv("HITSCOPE_TEST_RENDERER");
    return renderer != "nosse" && renderer != "own";
}

std::array<GLint, 6> bindings() {
    std::array<GLint, 6> values{};
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &values[0]);
    glGetIntegerv(GL_CURRENT_PROGRAM, &values[1]);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &values[2]);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &values[3]);
    glGetIntegerv(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, &values[4]);
    values[5] = glIsEnabled(GL_RASTERIZER_DISCARD);
    return values;
}

}  // namespace

class ExactnessTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    /// Exact or not, and then for a reason: a renderer that is exact by itself is not corrected.
    void whatIsMeasuredIsThere() {
        const Result<Exactness> measured = measureExactness();
        QVERIFY2(measured.ok(), measured.ok() ? "" : measured.error().message().c_str());
        const Exactness& exactness = measured.value();
        if (!mustBeExact() && (!exactness.isExact() || exactness.byFma)) {
            QSKIP(describe(exactness).c_str());
        }
        QVERIFY2(exactness.isExact(), describe(exactness).c_str());
        QVERIFY(!exactness.byFma);
        QVERIFY(definesOf(exactness).empty());
        QVERIFY(exactness.compared.vertices >= 4096);
        QCOMPARE(exactness.compared.different, std::size_t{0});
        QCOMPARE(exactness.compared.largest, 0.0f);
    }

    void aSlantedRootIsCorrectedByFma() {
        if (!epoxy_has_gl_extension("GL_ARB_gpu_shader_fp64")) {
            QSKIP("there are no doubles in this renderer's shaders");
        }
        if (!mustBeExact()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
        const Result<Exactness> measured = measureExactness({kSlantedRoot, kFusedFma});
        QVERIFY2(measured.ok(), measured.ok() ? "" : measured.error().message().c_str());
        const Exactness& exactness = measured.value();
        QVERIFY2(exactness.isExact(), describe(exactness).c_str());
        QVERIFY(exactness.byFma);
        QCOMPARE(exactness.compared.different, std::size_t{0});
        QCOMPARE(definesOf(exactness), (Defines{{"HITSCOPE_EXACT_BY_FMA", "1"}}));
    }

    /// What is exact without correction stays so with it.
    void theCorrectionOfAnExactRendererChangesNothing() {
        if (!epoxy_has_gl_extension("GL_ARB_gpu_shader_fp64")) {
            QSKIP("there are no doubles in this renderer's shaders");
        }
        if (!mustBeExact()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
        const Result<Exactness> measured = measureExactness({kFusedFma, {"HITSCOPE_EXACT_BY_FMA", "1"}});
        QVERIFY2(measured.ok(), measured.ok() ? "" : measured.error().message().c_str());
        QVERIFY2(measured.value().isExact(), describe(measured.value()).c_str());
    }

    void whatCannotBeCorrectedIsTold() {
        const Result<Exactness> measured = measureExactness({kSlantedRoot, kNoFma});
        QVERIFY2(measured.ok(), measured.ok() ? "" : measured.error().message().c_str());
        const Exactness& exactness = measured.value();
        QVERIFY(!exactness.isExact());
        QVERIFY(!exactness.byFma);
        QVERIFY(definesOf(exactness).empty());
        QVERIFY(exactness.compared.different > exactness.compared.vertices / 10);
        QVERIFY(exactness.compared.different <= exactness.compared.vertices);
        QVERIFY(exactness.compared.largest > 0.0f);
    }

    void aRefusedShaderIsAnError() {
        const Result<Exactness> measured = measureExactness({{"deform", "0"}});
        QVERIFY(!measured.ok());
        QVERIFY(measured.error().message().find("selftest.vert") != std::string::npos);
    }

    void theCallersStateStays() {
        const std::array<GLint, 6> before = bindings();
        QVERIFY(measureExactness().ok());
        QCOMPARE(bindings(), before);

        const gl::Framebuffer framebuffer = gl::Framebuffer::make();
        const gl::VertexArray array = gl::VertexArray::make();
        const gl::Buffer buffer = gl::Buffer::make();
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.id());
        glBindVertexArray(array.id());
        glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
        glEnable(GL_RASTERIZER_DISCARD);
        const std::array<GLint, 6> bound = bindings();
        QVERIFY(measureExactness().ok());
        QCOMPARE(bindings(), bound);
        glDisable(GL_RASTERIZER_DISCARD);
    }

    void inWords() {
        QCOMPARE(describe(Exactness{{4096, 0, 0.0f}}), std::string("bit-exact in 4,096 vertices compared"));
        QCOMPARE(
            describe(Exactness{{4096, 0, 0.0f}, true}),
            std::string("bit-exact in 4,096 vertices compared, with division and square root corrected"));
        QCOMPARE(describe(Exactness{{4096, 12, 0.1f}}),
                 std::string("not bit-exact: 12 of 4,096 vertices differ, by up to 0.1 m"));
        QCOMPARE(describe(Exactness{{1234567, 1000, 0.0f}}),
                 std::string("not bit-exact: 1,000 of 1,234,567 vertices differ, in their normals only"));
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(ExactnessTest, QCoreApplication)

}  // namespace hitscope::exactness_test

#include "exactness_test.moc"
