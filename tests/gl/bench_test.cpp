// SPDX-License-Identifier: GPL-3.0-or-later
// The hits that benchmarks make, and the paper's own way against the reference.
#include <QTest>
#include <glm/geometric.hpp>

#include "cli/bench/random_hits.h"
#include "cli/bench/sphere.h"
#include "cli/bench_gl/paper_feedback.h"
#include "deform/deform.h"
#include "deform/reference.h"
#include "pipeline_rows.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::bench_test {

using namespace bench;

namespace {

constexpr TargetId kTarget{1};

bool same(std::span<const DynamicVertex> a, std::span<const DynamicVertex> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const DynamicVertex& x, const DynamicVertex& y) {
                          return x.position == y.position && x.normal == y.normal;
                      });
}

}  // namespace

class BenchGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void hitsLieOnTheSurface() {
        const RenderMesh mesh = buildRenderMesh(makeSphere(2000));
        RandomHits random({{kTarget, &mesh}}, DeformationConstants(), 7);
        int up = 0;
        for (const Hit& hit : random.next(1000)) {
            QCOMPARE(hit.target, kTarget);
            const float radius = glm::length(hit.point);
            QVERIFY(radius > 0.98f * kSphereRadius && radius < 1.001f * kSphereRadius);
            QVERIFY(std::abs(glm::length(hit.direction) - 1.0f) < 1e-5f);
            QVERIFY(glm::dot(hit.direction, -hit.point / radius) >
                    0.8f);  // within 30 degrees and a facet's tilt
            up += hit.point.y > 0.5f * kSphereRadius ? 1 : 0;
        }
        QVERIFY2(up > 200 && up < 300, qPrintable(QString::number(up)));  // a quarter of the surface
    }

    void seedsMakeTheHits() {
        const RenderMesh mesh = buildRenderMesh(makeSphere(200));
        const std::vector<HitTarget> targets{{kTarget, &mesh}, {TargetId{2}, &mesh}};
        const std::vector<Hit> first = RandomHits(targets, DeformationConstants(), 1).next(10);
        QVERIFY(first == RandomHits(targets, DeformationConstants(), 1).next(10));
        QVERIFY(first != RandomHits(targets, DeformationConstants(), 2).next(10));
        QCOMPARE(first[0].target, kTarget);
        QCOMPARE(first[1].target, TargetId{2});
    }

    void affectedIsCounted() {
        const RenderMesh mesh = buildRenderMesh(makeSphere(5000));
        const auto vertices = static_cast<double>(mesh.vertices.size());
        const DeformationConstants constants =
            constantsReaching(80.0, vertices, static_cast<double>(kSphereRadius));
        const std::vector<Hit> hits = RandomHits({{kTarget, &mesh}}, constants, 3).next(50);
        PageVector<DynamicVertex> moved = mesh.vertices;
        std::size_t affected = 0;
        for (const Hit& hit : hits) {
            for (DynamicVertex& vertex : moved) {
                affected += deform(vertex.position, vertex.normal, hit) ? 1 : 0;
            }
        }
        const double mean = static_cast<double>(affected) / 50.0;
        QCOMPARE(countAffected(mesh, hits), mean);
        QVERIFY2(mean > 50.0 && mean < 110.0, qPrintable(QString::number(mean)));
    }

    void paperConstantsReachEighty() {
        const DeformationConstants constants = constantsReaching(79.38, 7938.0, 2.5);
        const DeformationConstants paper;
        QVERIFY(std::abs(constants.maxDistance - paper.maxDistance) < 1e-5f);
        QVERIFY(std::abs(constants.power - paper.power) < 1e-6f);
        QVERIFY(std::abs(constants.maxMagnitude - paper.maxMagnitude) < 1e-5f);
    }

    void paperWayDeformsAsTheReference() {
        test::GlFixture gl;
        if (!gl.open()) {
            return;
        }
        HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        const RenderMesh mesh = buildRenderMesh(makeSphere(7938));
        {
            Result<PaperFeedback> paper = PaperFeedback::create(mesh.vertices, test::deformDefines());
            QVERIFY(paper);
            ReferenceDeformation reference(mesh);
            for (const Hit& hit : RandomHits({{kTarget, &mesh}}, DeformationConstants(), 5).next(20)) {
                paper.value().apply(hit);
                reference.apply({&hit, 1});
            }
            QVERIFY(!same(paper.value().vertices(), mesh.vertices));
            QVERIFY(same(paper.value().vertices(), reference.vertices()));
            paper.value().restore(mesh.vertices);
            QVERIFY(same(paper.value().vertices(), mesh.vertices));
        }
        QCOMPARE(gl.errors(), QStringList());
    }

    // What a scene draws is what the paper's way left in its buffers, target by target.
    void paperWayFillsWhatIsDrawn() {
        test::GlFixture gl;
        if (!gl.open()) {
            return;
        }
        HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        const RenderMesh meshes[2] = {buildRenderMesh(makeSphere(5000)), buildRenderMesh(makeSphere(600))};
        {
            const TargetBuffers buffers[2] = {TargetBuffers(meshes[0]), TargetBuffers(meshes[1])};
            const PaperFeedback::Drawn drawn[2] = {{&buffers[0], meshes[0].vertices},
                                                   {&buffers[1], meshes[1].vertices}};
            Result<std::vector<PaperFeedback>> papers = PaperFeedback::createOn(drawn, test::deformDefines());
            QVERIFY(papers);
            for (std::size_t target = 0; target < 2; ++target) {
                ReferenceDeformation reference(meshes[target]);
                for (const Hit& hit :
                     RandomHits({{kTarget, &meshes[target]}}, DeformationConstants(), 5).next(20)) {
                    papers.value()[target].apply(hit);
                    reference.apply({&hit, 1});
                }
                std::vector<DynamicVertex> is(meshes[target].vertices.size());
                buffers[target].read({0, buffers[target].vertexCount()}, is);
                QVERIFY(!same(is, meshes[target].vertices));
                QVERIFY(same(is, reference.vertices()));
            }
        }
        QCOMPARE(gl.errors(), QStringList());
    }
};

HITSCOPE_TEST(BenchGlTest, QCoreApplication)

}  // namespace hitscope::bench_test

#include "bench_test.moc"
