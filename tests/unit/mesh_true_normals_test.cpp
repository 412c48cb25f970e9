// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "mesh/triangulate.h"
#include "mesh/true_normals.h"
#include "mesh_support.h"
#include "support/test_program.h"

namespace hitscope::mesh_true_normals_test {

namespace {

struct Model {
    explicit Model(MeshData data)
        : mesh(std::move(data)),
          render(buildRenderMesh(mesh)),
          normals(mesh, render),
          positions(mesh.positions.begin(), mesh.positions.end()) {}

    /// Pushes every vertex within `reach` of `centre` along `by`; returns them.
    std::vector<std::uint32_t> dent(const glm::vec3& centre, float reach, const glm::vec3& by) {
        std::vector<std::uint32_t> moved;
        for (std::uint32_t v = 0; v < positions.size(); ++v) {
            const float distance = glm::distance(positions[v], centre);
            if (distance <= reach) {
                positions[v] += by * (1.0f - 0.5f * distance / reach);
                moved.push_back(v);
            }
        }
        return moved;
    }

    std::vector<std::uint32_t> update(std::span<const std::uint32_t> moved) {
        std::vector<std::uint32_t> updated;
        normals.update(positions, moved, updated);
        return updated;
    }

    [[nodiscard]] bool isOriginal(std::size_t r) const {
        return std::memcmp(&normals.normals()[r], &render.vertices[r].normal, sizeof(glm::vec3)) == 0;
    }

    MeshData mesh;
    RenderMesh render;
    TrueNormals normals;
    std::vector<glm::vec3> positions;
};

std::vector<std::uint32_t> everyVertex(const Model& model) {
    std::vector<std::uint32_t> all(model.positions.size());
    for (std::uint32_t v = 0; v < all.size(); ++v) {
        all[v] = v;
    }
    return all;
}

/// The area-weighted normal of the faces that meet a render vertex at its own original normal, at any
/// positions.
glm::dvec3 surfaceNormal(const Model& model, std::uint32_t r, std::span<const glm::vec3> positions) {
    glm::dvec3 sum(0.0);
    for (std::size_t f = 0; f < model.mesh.faceCount(); ++f) {
        for (std::size_t c = model.mesh.faceStarts[f]; c < model.mesh.faceStarts[f + 1]; ++c) {
            const std::uint32_t other = model.render.cornerRenderVertices[c];
            if (model.render.fileVertices[other] == model.render.fileVertices[r] &&
                model.render.vertices[other].normal == model.render.vertices[r].normal) {
                sum += doubleAreaVector(positions, model.mesh.face(f));
            }
        }
    }
    return glm::normalize(sum);
}

}  // namespace

class TrueNormalsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whereNothingMovedTheFilesNormalsStay() {
        for (const MeshData& mesh : {makeHighPolySphere(), makeLowPolyCube(), makeTeapot(8)}) {
            Model model(mesh);
            const std::vector<std::uint32_t> updated = model.update(everyVertex(model));
            QCOMPARE(std::set<std::uint32_t>(updated.begin(), updated.end()).size(),
                     model.render.vertices.size());
            QCOMPARE(updated.size(), model.render.vertices.size());
            for (std::size_t r = 0; r < model.render.vertices.size(); ++r) {
                QVERIFY(model.isOriginal(r));
            }
        }
    }

    /// The paper's formula leaves these normals as they were; the surface's own tilt into the dent.
    void aHeadOnDentTurnsTheNormals() {
        Model model(makeHighPolyCube(2.5f));
        model.update(model.dent({0.0f, 2.5f, 0.0f}, 0.5f, {0.0f, -0.3f, 0.0f}));
        std::size_t turned = 0;
        for (std::uint32_t r = 0; r < model.render.vertices.size(); ++r) {
            const glm::dvec3 expected = surfaceNormal(model, r, model.positions);
            QVERIFY(glm::distance(glm::dvec3(model.normals.normals()[r]), expected) < 1e-6);
            turned += model.isOriginal(r) ? 0 : 1;
        }
        QVERIFY(turned > 20);
    }

    void hardEdgesStayHard() {
        Model model(makeHighPolyCube(2.5f));
        model.update(model.dent({2.5f, 2.5f, 0.0f}, 0.6f, {-0.2f, -0.2f, 0.0f}));
        std::size_t onEdge = 0;
        for (std::uint32_t v = 0; v < model.positions.size(); ++v) {
            const auto members = model.render.renderVerticesOf(v);
            if (members.size() == 2 && !model.isOriginal(members[0])) {
                ++onEdge;
                QVERIFY(glm::dot(model.normals.normals()[members[0]], model.normals.normals()[members[1]]) <
                        0.5f);
                for (const std::uint32_t r : members) {
                    QVERIFY(glm::distance(glm::dvec3(model.normals.normals()[r]),
                                          surfaceNormal(model, r, model.positions)) < 1e-6);
                }
            }
        }
        QVERIFY(onEdge >= 3);
    }

    void smoothNormalsTurnWithTheSurface() {
        Model model(makeTeapot(6));
        model.update(model.dent({2.0f, 1.0f, 0.0f}, 0.8f, {-0.3f, 0.1f, 0.05f}));
        model.update(model.dent({1.8f, 1.2f, 0.3f}, 0.5f, {-0.2f, -0.1f, 0.0f}));
        for (std::uint32_t r = 0; r < model.render.vertices.size(); ++r) {
            const glm::dvec3 before = surfaceNormal(model, r, model.mesh.positions);
            const glm::dvec3 now = surfaceNormal(model, r, model.positions);
            const glm::dvec3 original(model.render.vertices[r].normal);
            const glm::dvec3 normal(model.normals.normals()[r]);
            // A rotation that takes `before` to `now` keeps the angle to them, and by no more than their own.
            QVERIFY(std::abs(glm::dot(original, before) - glm::dot(normal, now)) < 1e-6);
            QVERIFY(glm::distance(original, normal) <= glm::distance(before, now) + 1e-6);
            QVERIFY(std::abs(glm::length(normal) - 1.0) < 1e-6);
        }
    }

    void updatingAroundTheDentIsEnough() {
        Model local(makeHighPolySphere(2.5f));
        Model whole(makeHighPolySphere(2.5f));
        std::mt19937 random(5);
        std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
        for (int i = 0; i < 20; ++i) {
            const glm::vec3 at =
                2.5f * glm::normalize(glm::vec3(coordinate(random), coordinate(random), 0.3f));
            const std::vector<std::uint32_t> updated = local.update(local.dent(at, 0.4f, -0.05f * at));
            whole.dent(at, 0.4f, -0.05f * at);
            QVERIFY(updated.size() < local.render.vertices.size() / 4);
        }
        whole.update(everyVertex(whole));
        for (std::size_t r = 0; r < local.render.vertices.size(); ++r) {
            QVERIFY(local.normals.normals()[r] == whole.normals.normals()[r]);
        }
    }

    void undoingTheDentGivesTheNormalsBack() {
        Model model(makeLowPolySphere());
        const std::vector<std::uint32_t> moved = model.dent({0, 2.5f, 0}, 1.0f, {0, -0.3f, 0});
        model.update(moved);
        QVERIFY(!model.isOriginal(model.render.renderVerticesOf(1).front()));
        model.positions.assign(model.mesh.positions.begin(), model.mesh.positions.end());
        model.update(moved);
        for (std::size_t r = 0; r < model.render.vertices.size(); ++r) {
            QVERIFY(model.isOriginal(r));
        }
        model.update(model.dent({0, 2.5f, 0}, 1.0f, {0, -0.3f, 0}));
        model.normals.reset();
        for (std::size_t r = 0; r < model.render.vertices.size(); ++r) {
            QVERIFY(model.isOriginal(r));
        }
    }

    void aFaceTurnedOverTurnsItsNormal() {
        Model model(test::polygon({{0, 0}, {1, 0}, {0, 1}}));
        model.positions[2].y = -1.0f;
        model.update(std::vector<std::uint32_t>{2});
        for (const glm::vec3& normal : model.normals.normals().all()) {
            QVERIFY(glm::distance(normal, glm::vec3(0, 0, -1)) < 1e-6f);
        }
    }

    void aFaceWithoutAreaKeepsItsNormal() {
        Model model(test::polygon({{0, 0}, {1, 0}, {0, 1}}));
        model.positions[2] = {0.5f, 0.0f, 0.0f};
        model.update(std::vector<std::uint32_t>{2, 2});
        QVERIFY(model.isOriginal(0) && model.isOriginal(1) && model.isOriginal(2));

        Model flat(test::polygon({{0, 0}, {1, 0}, {2, 0}}));
        flat.positions[2].y = 1.0f;
        flat.update(std::vector<std::uint32_t>{2});
        QVERIFY(flat.isOriginal(0));
    }

    void looseVerticesAreNoTrouble() {
        Model model(test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}}, {{0, 1, 2}}));
        QVERIFY(model.update(std::vector<std::uint32_t>{3}).empty());
        Model empty{MeshData()};
        QVERIFY(empty.update({}).empty());
    }
};

HITSCOPE_TEST(TrueNormalsTest, QCoreApplication)

}  // namespace hitscope::mesh_true_normals_test

#include "mesh_true_normals_test.moc"
