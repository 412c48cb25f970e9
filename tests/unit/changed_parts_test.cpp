// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/changed_parts.h"

#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <random>

#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "mesh/true_normals.h"
#include "support/test_program.h"

namespace hitscope::changed_parts_test {

namespace {

MeshData mixedMaterials() {
    MeshData mesh = makeCube(20, 1.0f);
    mesh.materials.resize(2);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        mesh.faceMaterials.push_back(static_cast<std::uint32_t>(f % 2));
    }
    return mesh;
}

/// Which triangles (size 3) or edges (size 2) runs hold; empty: they overlap or leave the buffer.
std::vector<bool> heldBy(std::span<const IndexRun> runs, std::size_t size, std::size_t indices) {
    std::vector<bool> held(indices / size, false);
    for (const IndexRun& run : runs) {
        if (run.first % size != 0 || run.end % size != 0 || run.first > run.end || run.end > indices) {
            return {};
        }
        for (std::size_t element = run.first / size; element < run.end / size; ++element) {
            if (held[element]) {
                return {};
            }
            held[element] = true;
        }
    }
    return held;
}

}  // namespace

class ChangedPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void holdsWhatMoved_data() {
        QTest::addColumn<MeshData>("mesh");
        QTest::newRow("sphere with a seam") << makeUvSphere(64, 40, 2.5f);
        QTest::newRow("cube with hard edges") << makeCube(24, 1.0f);
        QTest::newRow("two materials") << mixedMaterials();
        QTest::newRow("teapot") << makeTeapot(10);
    }
    void holdsWhatMoved() {
        QFETCH(MeshData, mesh);
        const auto render = std::make_shared<const RenderMesh>(buildRenderMesh(mesh));
        TrueNormals normals(mesh, *render);
        ChangedParts parts(render);
        QVERIFY(parts.triangles().empty());
        QVERIFY(parts.edges().empty());
        std::mt19937 random(5);
        std::vector<bool> moved(mesh.vertexCount(), false);
        for (int dent = 0; dent < 6; ++dent) {
            const std::uint32_t centre = static_cast<std::uint32_t>(random() % mesh.vertexCount());
            const float reach = dent == 0 ? 0.0f : 0.12f * mesh.bounds().diagonal();
            std::vector<std::uint32_t> now;
            for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
                if (glm::distance(mesh.positions[v], mesh.positions[centre]) <= reach) {
                    now.push_back(v);
                    moved[v] = true;
                }
            }
            std::vector<std::uint32_t> concerned;
            normals.update(mesh.positions, now, concerned);
            parts.note(concerned);
            check(*render, moved, parts);
        }
    }

private:
    static void check(const RenderMesh& render, const std::vector<bool>& moved, const ChangedParts& parts) {
        const auto compare = [&](std::span<const std::uint32_t> indices, std::size_t size,
                                 std::span<const IndexRun> runs) {
            const std::vector<bool> held = heldBy(runs, size, indices.size());
            QCOMPARE(held.size(), indices.size() / size);
            std::size_t needed = 0;
            for (std::size_t element = 0; element < held.size(); ++element) {
                bool changed = false;
                for (std::size_t corner = 0; corner < size; ++corner) {
                    changed = changed || moved[render.fileVertices[indices[element * size + corner]]];
                }
                needed += changed ? 1 : 0;
                QVERIFY(!changed || held[element]);
            }
            const auto drawn = static_cast<std::size_t>(std::count(held.begin(), held.end(), true));
            QVERIFY2(drawn < 2 * needed + 60, qPrintable(QStringLiteral("%1 of %2").arg(drawn).arg(needed)));
        };
        compare(render.triangles, 3, parts.triangles());
        compare(render.edges, 2, parts.edges());
    }
};

HITSCOPE_TEST(ChangedPartsTest, QCoreApplication)

}  // namespace hitscope::changed_parts_test

#include "changed_parts_test.moc"
