// SPDX-License-Identifier: GPL-3.0-or-later
// Blue noise over surfaces, and the hits that are made of it.
#include "deform/scattered_hits.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "deform/fingerprint.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::scattered_hits_test {

namespace {

constexpr double kSphereArea = 4.0 * 3.14159265 * 2.5 * 2.5;

struct Surface {
    explicit Surface(MeshData data) : mesh(std::move(data)), render(buildRenderMesh(mesh)) {}
    [[nodiscard]] ScatterSurface all() const { return {render, mesh.positions, {}}; }

    MeshData mesh;
    RenderMesh render;
};

std::vector<Hit> scattered(const ScatterSurface& surface, const ScatterPlan& plan) {
    const Result<ScatteredHits> hits = scatteredHits(surface, plan, {});
    return hits ? hits.value().hits : std::vector<Hit>();
}

double leastDistance(const std::vector<Hit>& hits) {
    double least = 1.0e9;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            least = std::min(least, static_cast<double>(glm::distance(hits[i].point, hits[k].point)));
        }
    }
    return least;
}

std::uint64_t printOf(const std::vector<Hit>& hits) {
    const TargetId none;
    return hitsFingerprint(hits, {&none, 1});
}

ScatterPlan planOf(std::uint32_t count, std::uint64_t seed = 1) {
    ScatterPlan plan;
    plan.count = count;
    plan.seed = seed;
    return plan;
}

}  // namespace

class ScatteredHitsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theSameSeedGivesTheSameBitsEverywhere() {
        const Surface cube(makeCube(8, 5.0f));
        ScatterPlan plan = planOf(200, 7);
        plan.sizeSpread = 0.5;
        plan.cone = 0.5;
        const std::vector<Hit> hits = scattered(cube.all(), plan);
        QCOMPARE(hits.size(), std::size_t{200});
        QCOMPARE(printOf(scattered(cube.all(), plan)), printOf(hits));
        // What came of it where this was written: another machine, compiler or library makes no other.
        QCOMPARE(QString::fromStdString(fingerprintText(printOf(hits))), QStringLiteral("5283f0f96d29978d"));
        plan.seed = 8;
        QVERIFY(printOf(scattered(cube.all(), plan)) != printOf(hits));
    }

    void placesKeepApart() {
        const Surface sphere(makeHighPolySphere(2.5f));
        for (const std::uint32_t count : {20u, 300u, 2000u}) {
            const std::vector<Hit> hits = scattered(sphere.all(), planOf(count));
            QCOMPARE(hits.size(), std::size_t{count});
            // Random places would be as near as a tenth of this.
            QVERIFY2(leastDistance(hits) > 0.6 * widestSpacing(kSphereArea, count),
                     qPrintable(QString::number(leastDistance(hits) / widestSpacing(kSphereArea, count))));
        }
    }

    void everyAreaGetsItsShare() {
        // Two sheets, one four times as large, of as many triangles.
        MeshData mesh = makeSheet(10, 10, 1.0f, 1.0f);
        const MeshData other = makeSheet(10, 10, 2.0f, 2.0f);
        const auto before = static_cast<std::uint32_t>(mesh.positions.size());
        std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
        std::vector<std::uint32_t> triangles;
        const RenderMesh one = buildRenderMesh(mesh);
        const RenderMesh two = buildRenderMesh(other);
        for (const std::uint32_t corner : one.triangles) {
            triangles.push_back(one.fileVertices[corner]);
        }
        for (const glm::vec3& position : other.positions) {
            positions.push_back(position + glm::vec3(50.0f, 0.0f, 0.0f));
        }
        for (const std::uint32_t corner : two.triangles) {
            triangles.push_back(before + two.fileVertices[corner]);
        }
        std::vector<std::uint32_t> all(triangles.size() / 3);
        std::iota(all.begin(), all.end(), 0u);
        const std::vector<SurfaceSample> samples = sampleSurface({positions, triangles, all}, 500, 3);
        const auto small = std::count_if(samples.begin(), samples.end(),
                                         [](const SurfaceSample& sample) { return sample.point.x < 10.0f; });
        QVERIFY2(std::abs(static_cast<double>(small) / 500.0 - 0.2) < 0.02,
                 qPrintable(QString::number(small)));
    }

    void hitsGoIntoTheSurfaceWithinTheirCone() {
        const Surface sphere(makeHighPolySphere(2.5f));
        ScatterPlan plan = planOf(400);
        for (const Hit& hit : scattered(sphere.all(), plan)) {
            QVERIFY(glm::dot(hit.direction, -glm::normalize(hit.point)) > 0.999f);
            QVERIFY(checkedHit(hit).ok());
        }
        plan.cone = 0.5;
        float widest = 1.0f;
        for (const Hit& hit : scattered(sphere.all(), plan)) {
            widest = std::min(widest, glm::dot(hit.direction, -glm::normalize(hit.point)));
        }
        QVERIFY(widest > std::cos(0.52f) && widest < std::cos(0.45f));
    }

    void aGivenDirectionStrikesWhatFacesIt() {
        const Surface sphere(makeHighPolySphere(2.5f));
        ScatterPlan plan = planOf(300);
        plan.isInward = false;
        plan.direction = {0.0f, -3.0f, 0.0f};
        const std::vector<Hit> hits = scattered(sphere.all(), plan);
        QCOMPARE(hits.size(), std::size_t{300});
        for (const Hit& hit : hits) {
            QVERIFY(hit.point.y > -0.01f);
            QCOMPARE(hit.direction, glm::vec3(0.0f, -1.0f, 0.0f));
        }
    }

    void sizesAreSpread() {
        const Surface sphere(makeHighPolySphere(2.5f));
        ScatterPlan plan = planOf(400);
        plan.sizeSpread = 0.4;
        float least = 1.0f;
        float most = 0.0f;
        for (const Hit& hit : scattered(sphere.all(), plan)) {
            const float factor = hit.constants.maxDistance / 0.5f;
            least = std::min(least, factor);
            most = std::max(most, factor);
            QVERIFY(std::abs(hit.constants.power - 0.05f * factor * factor) < 1e-6f);
        }
        QVERIFY(least >= 0.6f && least < 0.63f && most <= 1.4f && most > 1.37f);
    }

    void onlySelectedFacesAreStruckAndDensityCounts() {
        const Surface sheet(makeSheet(20, 20, 4.0f, 4.0f));
        std::vector<std::uint32_t> left;
        for (std::uint32_t i = 0; i < sheet.mesh.positions.size(); ++i) {
            if (sheet.mesh.positions[i].x <= 0.001f) {
                left.push_back(i);
            }
        }
        ScatterPlan plan;
        plan.byDensity = true;
        plan.density = 25.0;
        const auto hits = scatteredHits({sheet.render, sheet.mesh.positions, left}, plan, {});
        QVERIFY(hits.ok());
        QVERIFY(std::abs(hits.value().area - 8.0) < 1e-4);
        QCOMPARE(hits.value().hits.size(), std::size_t{200});
        for (const Hit& hit : hits.value().hits) {
            QVERIFY(hit.point.x <= 0.001f);
        }
    }

    void whatCannotBeIsRefusedInWords() {
        const Surface sheet(makeSheet(4, 4, 1.0f, 1.0f));
        const std::vector<std::uint32_t> one{0};
        QVERIFY(!scatteredHits({sheet.render, sheet.mesh.positions, one}, {}, {}).ok());
        ScatterPlan plan;
        plan.byDensity = true;
        plan.density = 0.1;
        QVERIFY(!scatteredHits(sheet.all(), plan, {}).ok());
        plan.density = 1.0e9;
        QVERIFY(!scatteredHits(sheet.all(), plan, {}).ok());
        const auto stopped = scatteredHits(sheet.all(), {}, {}, [](double) { return false; });
        QVERIFY(stopped.ok() && stopped.value().hits.empty());
    }
};

HITSCOPE_TEST(ScatteredHitsTest, QCoreApplication)

}  // namespace hitscope::scattered_hits_test

#include "scattered_hits_test.moc"
