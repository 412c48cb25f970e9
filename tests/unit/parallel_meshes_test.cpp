// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of a large mesh is the same in every bit, however many processors share the work.
#include <QTest>
#include <cstring>
#include <new>

#include "core/parallel.h"
#include "mesh/primitives.h"
#include "mesh/render_mesh.h"
#include "mesh/true_normals.h"
#include "physics/triangle_tree.h"
#include "support/test_program.h"

namespace hitscope::parallel_meshes_test {

namespace {

/// 60,000 vertices with several materials, seams in its texture, computed normals here and there, notched
/// faces and vertices that no face uses.
MeshData largeMesh() {
    MeshData mesh = makeUvSphere(400, 150, 1.0f);
    mesh.materials.resize(3);
    mesh.faceMaterials.clear();
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        mesh.faceMaterials.push_back(f % 7 == 0 ? kNoIndex : (f / 1000) % 3);
    }
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    mesh.cornerTexcoords.clear();
    for (std::uint32_t c = 0; c < mesh.cornerVertices.size(); ++c) {
        mesh.cornerTexcoords.push_back(mesh.cornerVertices[c] % 11 == 0 ? c % 3 : 0);
    }
    for (std::uint32_t c = 0; c < mesh.cornerNormals.size(); c += 5) {
        mesh.cornerNormals[c] = kNoIndex;
    }
    for (std::size_t v = 0; v < mesh.vertexCount(); v += 97) {
        mesh.positions[v] *= 0.2f;
    }
    mesh.positions.insert(mesh.positions.end(), 100, glm::vec3(0.5f));
    mesh.colours.clear();
    return mesh;
}

template <class Values>
bool sameBytes(const Values& a, const Values& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), std::span(a).size_bytes()) == 0;
}

QStringList differences(const RenderMesh& a, const RenderMesh& b) {
    const std::pair<const char*, bool> parts[] = {
        {"vertices", sameBytes(a.vertices, b.vertices)},
        {"drawnVertices", a.drawnVertices == b.drawnVertices},
        {"texcoords", sameBytes(a.texcoords, b.texcoords)},
        {"fileVertices", sameBytes(a.fileVertices, b.fileVertices)},
        {"cornerRenderVertices", sameBytes(a.cornerRenderVertices, b.cornerRenderVertices)},
        {"triangles", sameBytes(a.triangles, b.triangles)},
        {"triangleFaces", sameBytes(a.triangleFaces, b.triangleFaces)},
        {"edges", sameBytes(a.edges, b.edges)},
        {"draws", sameBytes(a.draws, b.draws)},
        {"clusters", sameBytes(a.clusters, b.clusters)},
        {"fileVertexStarts", sameBytes(a.fileVertexStarts, b.fileVertexStarts)},
        {"fileVertexRender", sameBytes(a.fileVertexRender, b.fileVertexRender)}};
    QStringList differing;
    for (const auto& [name, same] : parts) {
        if (!same) {
            differing << QLatin1String(name);
        }
    }
    return differing;
}

std::vector<glm::vec3> positionsOf(const RenderMesh& mesh) {
    std::vector<glm::vec3> positions;
    for (const DynamicVertex& vertex : mesh.vertices) {
        positions.push_back(vertex.position);
    }
    return positions;
}

/// Boxes and triangles in the order in which the tree has them.
std::vector<float> contentOf(const physics::TriangleTree& tree) {
    std::vector<float> content;
    tree.visit(
        glm::vec3(0.0f),
        [&content](const Bounds& box) {
            content.insert(content.end(), {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z});
            return true;
        },
        [&content](const physics::TriangleTree::Visited& visited) {
            content.push_back(static_cast<float>(visited.triangle));
            content.insert(content.end(), visited.corners.begin(), visited.corners.end());
        });
    return content;
}

}  // namespace

class ParallelMeshesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { pretendedProcessors() = 0; }
    void renderMeshIsTheSame();
    void treeIsTheSame_data();
    void treeIsTheSame();
    void copiesOfTreesAreApart();
    void copiesOfTrueNormalsAreApart();
    void whatIsThrownComesThrough();
};

void ParallelMeshesTest::renderMeshIsTheSame() {
    const MeshData mesh = largeMesh();
    QVERIFY(validate(mesh).ok());
    pretendedProcessors() = 1;
    const RenderMesh alone = buildRenderMesh(mesh);
    QVERIFY(alone.vertices.size() > mesh.vertexCount());
    for (const std::size_t processors : {2u, 3u, 8u}) {
        pretendedProcessors() = processors;
        QCOMPARE(differences(buildRenderMesh(mesh), alone), QStringList());
    }
}

void ParallelMeshesTest::treeIsTheSame_data() {
    QTest::addColumn<int>("triangles");
    for (const int triangles : {1, 4, 5, 9, 1023, 40'001, 100'000}) {
        QTest::addRow("%d", triangles) << triangles;
    }
}

void ParallelMeshesTest::treeIsTheSame() {
    QFETCH(int, triangles);
    const RenderMesh mesh = buildRenderMesh(largeMesh());
    const std::span<const std::uint32_t> corners =
        std::span(mesh.triangles).first(std::size_t{3} * static_cast<std::size_t>(triangles));
    pretendedProcessors() = 1;
    const std::vector<float> alone = contentOf({positionsOf(mesh), corners});
    for (const std::size_t processors : {2u, 3u, 8u}) {
        pretendedProcessors() = processors;
        QCOMPARE(contentOf({positionsOf(mesh), corners}), alone);
    }
}

void ParallelMeshesTest::copiesOfTreesAreApart() {
    const RenderMesh mesh = buildRenderMesh(makeUvSphere(40, 20, 1.0f));
    std::vector<glm::vec3> positions = positionsOf(mesh);
    const physics::TriangleTree original(positions, mesh.triangles);
    physics::TriangleTree dented = original;
    std::vector<physics::TriangleTree::MovedRun> all;
    for (std::uint32_t run = 0; run <= positions.size() / physics::RunPositions::kRun; ++run) {
        all.push_back({run, original.bounds()});
    }
    const std::vector<float> before = contentOf(original);
    for (glm::vec3& position : positions) {
        position *= 3.0f;
    }
    dented.refit(physics::RunPositions(positions), all);
    QCOMPARE(contentOf(original), before);
    QVERIFY(dented.bounds().max.x > 2.5f);
}

void ParallelMeshesTest::copiesOfTrueNormalsAreApart() {
    const MeshData mesh = makeUvSphere(40, 20, 1.0f);
    const RenderMesh render = buildRenderMesh(mesh);
    const TrueNormals shape(mesh, render);
    TrueNormals target = shape;
    const std::vector<glm::vec3> before = shape.normals().all();
    PageVector<glm::vec3> positions = mesh.positions;
    positions[100] *= 0.5f;
    const std::vector<std::uint32_t> moved{100};
    std::vector<std::uint32_t> updated;
    target.update(positions, moved, updated);
    QVERIFY(!updated.empty());
    QVERIFY(std::equal(before.begin(), before.end(), shape.normals().all().begin()));
    QVERIFY(!std::equal(before.begin(), before.end(), target.normals().all().begin()));
    const TrueNormals copy = target;
    target.reset();
    QVERIFY(std::equal(before.begin(), before.end(), target.normals().all().begin()));
    QVERIFY(!std::equal(before.begin(), before.end(), copy.normals().all().begin()));
}

void ParallelMeshesTest::whatIsThrownComesThrough() {
    for (const bool there : {false, true}) {
        const auto fail = [](bool fails) {
            if (fails) {
                throw std::bad_alloc();
            }
        };
        QVERIFY_EXCEPTION_THROWN(bothAtOnce([&] { fail(there); }, [&] { fail(!there); }), std::bad_alloc);
    }
}

HITSCOPE_TEST(ParallelMeshesTest, QCoreApplication)

}  // namespace hitscope::parallel_meshes_test

#include "parallel_meshes_test.moc"
