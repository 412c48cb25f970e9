// SPDX-License-Identifier: GPL-3.0-or-later
// The hits that benchmarks make, and the paper's own way against the reference.
#include <QTest>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "cli/bench/bench_room.h"
#include "cli/bench/check_report.h"
#include "cli/bench/hit_size.h"
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

    // More vertices than one poll asks for.
    void followedHitsHaveArrivedWithTheirSample() {
        test::GlFixture gl;
        if (!gl.open()) {
            return;
        }
        const Result<std::unique_ptr<BenchRoom>> room = BenchRoom::open(16, 16);
        QVERIFY(room);
        HitOptions options;
        options.pipelines = {PipelineKind::TransformFeedback};
        options.hitsAFrame = {1, 1000};
        options.yardsticks = false;
        Result<std::unique_ptr<HitSizeBench>> bench = HitSizeBench::create(*room.value(), 100'000, options);
        QVERIFY(bench);
        const std::vector<Variant> variants = bench.value()->variants();
        const std::vector<HitFigure> figures = bench.value()->figures(std::vector<Samples>(variants.size()));
        QCOMPARE(variants.size(), std::size_t{4});
        for (std::size_t i = 0; i < variants.size(); ++i) {
            QVERIFY(variants[i].prepare());
            QVERIFY(!bench.value()->isReadBackPending());
            QVERIFY(variants[i].run());
            QCOMPARE(bench.value()->isReadBackPending(),
                     figures[i].method != HitFigure::Method::WithReadBack);
        }
        QVERIFY(noGlErrors());
    }

    // What --strict of bench check asks.
    void promisesThatCannotBeMeasuredAreNotKept() {
        test::GlFixture gl;
        if (!gl.open()) {
            return;
        }
        const Result<std::unique_ptr<BenchRoom>> room = BenchRoom::open(16, 16);
        QVERIFY(room);
        using Rows = Result<std::vector<CheckRow>>;
        const auto check = [](const char* name, const Rows& rows) {
            return Check{name, name, 1.0, [rows](const BenchRoom&, const Plan&) { return rows; }};
        };
        TimeRatio half;
        half.value = 0.5;
        half.rounds.add(0.5);
        const Check kept = check("kept", std::vector<CheckRow>{{{}, half}});
        const Check notHere = check("not here", std::vector<CheckRow>());
        const Check failed = check("failed", Error{"It does not fit into memory.", "", ""});
        const auto areKept = [&room](const std::vector<Check>& checks) {
            Report report;
            const Result<bool> all = reportChecks(checks, *room.value(), Plan(), report);
            return all && report.records.size() == checks.size() ? std::optional(all.value()) : std::nullopt;
        };
        QCOMPARE(areKept({kept, notHere}), std::optional(true));
        QCOMPARE(areKept({failed, kept}), std::optional(false));
    }
};

HITSCOPE_TEST(BenchGlTest, QCoreApplication)

}  // namespace hitscope::bench_test

#include "bench_test.moc"
