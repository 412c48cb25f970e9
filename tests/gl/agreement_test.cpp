// SPDX-License-Identifier: GPL-3.0-or-later
// After 10,000 random hits on each primitive, the teapot and a sphere of 1,000,000 vertices every pipeline's
// positions and normals are the reference's, bit for bit; the uniform arrays' over the hits they keep.
#include <QTest>

#include "deform/reference.h"
#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::agreement_test {

using namespace test;

namespace {

constexpr std::size_t kHits = 10'000;

TestScene sceneOf(const QString& name) {
    TestScene scene;
    if (name == QStringLiteral("teapot")) {
        scene.emplace_back(1u, buildRenderMesh(makeTeapot(16)));
    } else if (name == QStringLiteral("1,000,000 vertices")) {
        scene.emplace_back(1u, buildRenderMesh(makeUvSphere(1414, 708, 2.5f)));
    } else {
        scene = makeScene({name});
    }
    return scene;
}

}  // namespace

class AgreementTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void tenThousandHits_data() {
        QTest::addColumn<QString>("mesh");
        for (const char* name : {"Low-poly cube", "High-poly cube", "Low-poly sphere", "High-poly sphere",
                                 "teapot", "1,000,000 vertices"}) {
            QTest::newRow(name) << QString::fromUtf8(name);
        }
    }
    void tenThousandHits() {
        QFETCH(const QString, mesh);
        TestScene scene = sceneOf(mesh);
        std::vector<Hit> hits = randomHits(scene, 97, kHits, 5);
        if (scene[0].mesh.vertices.size() > 500'000) {
            // Hits of the paper's size would each move 10,000 of these vertices, and take minutes.
            for (Hit& hit : hits) {
                hit.constants = {0.1f, 0.002f, 0.06f};
            }
        }
        ReferenceDeformation all(scene[0].mesh);
        all.apply(hits);
        for (const PipelineTraits& traits : allPipelines()) {
            if (whyUnavailable(traits.kind)) {
                continue;
            }
            const auto pipeline = pipelineOn(traits.kind, scene);
            QVERIFY(pipeline);
            Mirror mirror(scene);
            for (std::size_t first = 0; first < kHits; first += 500) {
                pipeline->append(std::span(hits).subspan(first, 500));
            }
            mirror.readBack(*pipeline);
            const CapacityReport capacity = pipeline->capacity();
            if (!capacity.capacity) {
                QCOMPARE(difference(mirror.vertices(scene[0].id), all.vertices()), QString());
            } else {
                QCOMPARE(capacity.used, std::size_t{600});
                ReferenceDeformation last(scene[0].mesh);
                last.apply(std::span(hits).last(600));
                QCOMPARE(difference(mirror.vertices(scene[0].id), last.vertices()), QString());
            }
            scene[0].buffers->restoreOriginal();
        }
    }

private:
    GlFixture m_gl;
};

HITSCOPE_TEST(AgreementTest, QCoreApplication)

}  // namespace hitscope::agreement_test

#include "agreement_test.moc"
