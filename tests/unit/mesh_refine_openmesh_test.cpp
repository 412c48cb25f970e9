// SPDX-License-Identifier: GPL-3.0-or-later
// Refining as OpenMesh does it.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LongestEdgeT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "mesh_refine_support.h"
#include "support/test_program.h"

namespace hitscope::mesh_refine_openmesh_test {

using namespace refine_test;

namespace {

using Half = OpenMesh::TriMesh_ArrayKernelT<>;
struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

HalfEdgeMesh halfEdges(const MeshData& mesh) {
    HalfEdgeMesh made;
    std::vector<OpenMesh::VertexHandle> handles;
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 at(p);
        handles.push_back(made.add_vertex({at.x, at.y, at.z}));
    }
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        made.add_face(handles[face[0]], handles[face[1]], handles[face[2]]);
    }
    return made;
}

/// The farthest that a vertex of one is from the nearest of the other.
double farthest(const MeshData& mesh, const HalfEdgeMesh& other) {
    double most = 0.0;
    for (const glm::vec3& p : mesh.positions) {
        double least = 1e300;
        for (const auto vertex : other.vertices()) {
            const auto& q = other.point(vertex);
            least = std::min(least, glm::distance(glm::dvec3(p), glm::dvec3(q[0], q[1], q[2])));
        }
        most = std::max(most, least);
    }
    return most;
}

}  // namespace

class RefineOpenMeshTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void butterflyIsAsOpenMeshDoesIt_data();
    void butterflyIsAsOpenMeshDoesIt();
    void longestEdgeIsAsOpenMeshDoesIt();
};

void RefineOpenMeshTest::butterflyIsAsOpenMeshDoesIt_data() {
    QTest::addColumn<MeshData>("mesh");
    QTest::addRow("tetrahedron") << tetrahedron();
    QTest::addRow("torus") << triangulated(torus(9, 7, 2.0, 0.7));
    QTest::addRow("open cylinder") << triangulated(cylinder(10, false));
    QTest::addRow("sphere") << triangulated(withoutNormals(makeUvSphere(11, 6, 1.0f)));
}

void RefineOpenMeshTest::butterflyIsAsOpenMeshDoesIt() {
    QFETCH(const MeshData, mesh);
    HalfEdgeMesh theirs = halfEdges(mesh);
    OpenMesh::Subdivider::Uniform::ModifiedButterflyT<HalfEdgeMesh, double> butterfly;
    butterfly.attach(theirs);
    butterfly(1);
    butterfly.detach();
    // So short that one pass at least is made.
    double shortest = 1e300;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        double longest = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            longest = std::max(longest, glm::distance(glm::dvec3(mesh.positions[mesh.face(f)[i]]),
                                                      glm::dvec3(mesh.positions[mesh.face(f)[(i + 1) % 3]])));
        }
        shortest = std::min(shortest, longest);
    }
    const RefinedMesh ours =
        refined(mesh, options(RefineMethod::Butterfly, static_cast<float>(0.999 * shortest)));
    // The first pass cuts all: its vertices are those of OpenMesh.
    QVERIFY(ours.mesh.vertexCount() >= theirs.n_vertices());
    MeshData first = ours.mesh;
    first.positions.resize(theirs.n_vertices());
    QVERIFY2(farthest(first, theirs) < 1e-6, qPrintable(QString::number(farthest(first, theirs))));
}

void RefineOpenMeshTest::longestEdgeIsAsOpenMeshDoesIt() {
    // Of edges that all have different lengths: which of two equal ones comes first is anybody's choice.
    MeshData mesh = triangulated(torus(7, 5, 2.0, 0.7));
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        mesh.positions[v] += 0.01f * glm::vec3(std::sin(7.0f * static_cast<float>(v)),
                                               std::cos(11.0f * static_cast<float>(v)), 0.0f);
    }
    HalfEdgeMesh theirs = halfEdges(mesh);
    OpenMesh::Subdivider::Uniform::LongestEdgeT<HalfEdgeMesh, double> longest;
    longest.set_max_edge_length(0.4);
    longest.attach(theirs);
    longest(1);
    longest.detach();
    const RefinedMesh ours = refined(mesh, options(RefineMethod::LongestEdge, 0.4f));
    QCOMPARE(ours.mesh.faceCount(), theirs.n_faces());
    QCOMPARE(ours.mesh.vertexCount(), theirs.n_vertices());
    QVERIFY(farthest(ours.mesh, theirs) < 1e-6);
}

HITSCOPE_TEST(RefineOpenMeshTest, QCoreApplication)

}  // namespace hitscope::mesh_refine_openmesh_test

#include "mesh_refine_openmesh_test.moc"
