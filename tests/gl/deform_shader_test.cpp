// SPDX-License-Identifier: GPL-3.0-or-later
// shaders/deform.glsl against its twin deform(), bit for bit.
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "deform/deform.h"
#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "pipeline/capture_pass.h"
#include "pipeline/hit_arrays.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::deform_shader_test {

using namespace test;

namespace {

constexpr std::size_t kHits = 64;

/// Vertices, and the hits [firstHit, lastHit) that are applied to them.
struct Run {
    VertexRange range;
    std::size_t firstHit = 0;
    std::size_t lastHit = 0;
};

/// The vertices as the shader deforms them, each run's by its hits.
std::vector<DynamicVertex> onGpu(CapturePass& pass, const RenderMesh& mesh, std::span<const Hit> hits,
                                 std::span<const Run> runs) {
    const TargetBuffers buffers(mesh);
    HitArrays arrays({HitStorage::Floats, kHits});
    for (const Hit& hit : hits) {
        arrays.add(hit);
    }
    std::vector<DynamicVertex> result(mesh.vertices.size());
    for (const Run& run : runs) {
        const CaptureRun captured{run.range};
        pass.run(
            buffers, {&captured, 1},
            [&](const gl::Program& program) {
                arrays.upload(program);
                program.set("u_firstHit", static_cast<int>(run.firstHit));
                program.set("u_lastHit", static_cast<int>(run.lastHit));
            },
            [&](std::span<const VertexRange> ranges) {
                const auto bytes = static_cast<GLsizeiptr>(ranges[0].count * sizeof(DynamicVertex));
                glBindBuffer(GL_COPY_READ_BUFFER, pass.scratch());
                glGetBufferSubData(GL_COPY_READ_BUFFER, 0, bytes, result.data() + ranges[0].first);
            });
    }
    return result;
}

std::vector<DynamicVertex> onCpu(const RenderMesh& mesh, std::span<const Hit> hits, std::span<const Run> runs,
                                 std::size_t& moved) {
    std::vector<DynamicVertex> result(mesh.vertices.begin(), mesh.vertices.end());
    for (const Run& run : runs) {
        for (DynamicVertex& vertex : std::span(result).subspan(run.range.first, run.range.count)) {
            for (std::size_t hit = run.firstHit; hit < run.lastHit; ++hit) {
                moved += deform(vertex.position, vertex.normal, hits[hit]) ? 1 : 0;
            }
        }
    }
    return result;
}

/// `value` moved by that many units in its last place.
float nudged(float value, int steps) {
    const float end =
        steps < 0 ? -std::numeric_limits<float>::infinity() : std::numeric_limits<float>::infinity();
    for (int i = 0; i < std::abs(steps); ++i) {
        value = std::nextafter(value, end);
    }
    return value;
}

}  // namespace

class DeformShaderTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (!m_gl.open()) {
            return;
        }
        HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        gl::Defines defines = hitArrayDefines({HitStorage::Floats, kHits});
        const gl::Defines exact = deformDefines();
        defines.insert(defines.end(), exact.begin(), exact.end());
        Result<CapturePass> pass = CapturePass::create(std::move(defines));
        QVERIFY2(pass.ok(), pass.ok() ? "" : pass.error().message().c_str());
        m_pass = std::make_unique<CapturePass>(std::move(pass).value());
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_pass.reset(); }

    void randomVerticesAndHits_data() {
        QTest::addColumn<float>("extent");
        QTest::newRow("close") << 0.5f;
        QTest::newRow("a target") << 2.5f;
        QTest::newRow("far coordinates") << 100.0f;
    }
    // Each vertex meets all hits in turn, so that the next hits feed on every bit of the ones before.
    void randomVerticesAndHits() {
        QFETCH(const float, extent);
        TestScene scene;
        scene.emplace_back(1u, pointCloud(31, 100'000, extent));
        const RenderMesh& mesh = scene[0].mesh;
        std::size_t moved = 0;
        for (std::uint32_t seed = 0; seed < 4; ++seed) {
            const std::vector<Hit> hits = randomHits(scene, seed, kHits, 16);
            const std::vector<Run> all = {{{0, static_cast<std::uint32_t>(mesh.vertices.size())}, 0, kHits}};
            const std::vector<DynamicVertex> expected = onCpu(mesh, hits, all, moved);
            QCOMPARE(difference(onGpu(*m_pass, mesh, hits, all), expected), QString());
        }
        QVERIFY(moved > 100);
    }

    // Vertices a few units in the last place on either side of the rim, where the function jumps by 0.1 m.
    void verticesAtTheRim() {
        constexpr std::uint32_t kVerticesPerHit = 1600;
        RenderMesh mesh = pointCloud(41, kHits * kVerticesPerHit, 1.0f);
        std::mt19937 random(43);
        std::vector<Hit> hits(kHits);
        std::vector<Run> runs;
        for (std::uint32_t i = 0; i < kHits; ++i) {
            hits[i].point = mesh.vertices[i].position * 2.5f;
            hits[i].direction = mesh.vertices[i].normal;
            hits[i].constants = testConstants(i % 16);
            for (std::uint32_t j = i * kVerticesPerHit; j < (i + 1) * kVerticesPerHit; ++j) {
                DynamicVertex& vertex = mesh.vertices[j];
                vertex.position = hits[i].point + vertex.normal * hits[i].constants.maxDistance;
                const auto axis = static_cast<int>(random() % 3);
                vertex.position[axis] = nudged(vertex.position[axis], static_cast<int>(random() % 9) - 4);
            }
            runs.push_back({{i * kVerticesPerHit, kVerticesPerHit}, i, i + 1});
        }
        std::size_t moved = 0;
        const std::vector<DynamicVertex> expected = onCpu(mesh, hits, runs, moved);
        QVERIFY(moved > mesh.vertices.size() / 10);
        QVERIFY(moved < mesh.vertices.size() - mesh.vertices.size() / 10);
        QCOMPARE(difference(onGpu(*m_pass, mesh, hits, runs), expected), QString());
    }

    // At the hit point itself the cap applies; a normal that the hit cancels stays as it was.
    void specialVertices() {
        RenderMesh mesh;
        const float cap = DeformationConstants().maxMagnitude;
        mesh.vertices = {{{0, 0, 0}, {0, 1, 0}},
                         {{1e-30f, 0, 0}, {0, 1, 0}},
                         {{0.99e-11f, 0, 0}, {1e-21f, 1, -1e-21f}},
                         {{1.01e-11f, 0, 0}, {1e-19f, 1, -1e-19f}},
                         {{0.01f, 0, 0}, {0, 0, cap}},
                         {{0, 0.5f, 0}, {0, 0, 1}},
                         {{0, 0.50000006f, 0}, {0, 0, 1}},
                         {{-0.3f, 0, 0.4f}, {0, 0, -1}},
                         {{-0.0f, -0.0f, -0.0f}, {-0.0f, 1, 0}}};
        mesh.clusters = {{0, 9, {glm::vec3(-1.0f), glm::vec3(1.0f)}}};
        const std::vector<Hit> hits = {Hit{TargetId{1}, {0, 0, 0}, {0, 0, -1}, {}}};
        const std::vector<Run> runs = {{{0, 9}, 0, 1}};
        std::size_t moved = 0;
        const std::vector<DynamicVertex> expected = onCpu(mesh, hits, runs, moved);
        const std::vector<DynamicVertex> actual = onGpu(*m_pass, mesh, hits, runs);
        QCOMPARE(difference(actual, expected), QString());
        QCOMPARE(actual[0].position.z, -cap);
        QCOMPARE(actual[4].normal, glm::vec3(0, 0, cap));
        QVERIFY(actual[5].position.z < 0);
        QCOMPARE(actual[6].position.z, 0.0f);
    }

    // Where squares are denormal, which llvmpipe flushes to zero: a hit too weak for the cap to hide it.
    void nextToTheHitPoint() {
        RenderMesh mesh = pointCloud(51, 4096, 1.0f);
        std::mt19937 random(53);
        const auto tiny = [&random] {
            const float digits = 1.0f + static_cast<float>(random() % 1000) / 100.0f;
            return std::ldexp(random() % 2 == 0 ? digits : -digits, -static_cast<int>(random() % 100) - 30);
        };
        for (DynamicVertex& vertex : mesh.vertices) {
            vertex.position = {tiny(), tiny(), tiny()};
            vertex.normal[static_cast<int>(random() % 3)] = tiny();
        }
        Hit weak;
        weak.direction = glm::normalize(glm::vec3(1, -2, 3));
        weak.constants = {.maxDistance = 0.5f, .power = 1e-14f, .maxMagnitude = 0.3f};
        Hit along = weak;
        along.direction = {0, 0, -1};
        const std::vector<Hit> hits = {weak, along, weak};
        const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
        const std::vector<Run> runs = {{{0, count}, 0, hits.size()}};
        std::size_t moved = 0;
        const std::vector<DynamicVertex> expected = onCpu(mesh, hits, runs, moved);
        QCOMPARE(moved, hits.size() * mesh.vertices.size());
        QCOMPARE(difference(onGpu(*m_pass, mesh, hits, runs), expected), QString());
    }

private:
    GlFixture m_gl;
    std::unique_ptr<CapturePass> m_pass;
};

HITSCOPE_TEST(DeformShaderTest, QCoreApplication)

}  // namespace hitscope::deform_shader_test

#include "deform_shader_test.moc"
