// SPDX-License-Identifier: GPL-3.0-or-later
// Dents that overlap, told apart by the hits that made them.
#include "deform/dent_owners.h"

#include <QTest>
#include <algorithm>
#include <numeric>

#include "deform/reference.h"
#include "mesh/dent.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::dent_owners_test {

namespace {

Hit hitAt(float x, float y, float depth) {
    Hit hit;
    hit.target = TargetId{1};
    hit.point = {x, 0.0f, y};
    hit.direction = {0.0f, -1.0f, 0.0f};
    hit.constants = {.maxDistance = 0.5f, .power = 0.05f, .maxMagnitude = depth};
    return hit;
}

/// A flat sheet in the plane y = 0, whichever way makeSheet() lays it.
MeshData flat() {
    MeshData mesh = makeSheet(100, 100, 4.0f, 4.0f);
    const bool isUpright = std::any_of(mesh.positions.begin(), mesh.positions.end(),
                                       [](const glm::vec3& at) { return at.y != 0.0f; });
    for (glm::vec3& at : mesh.positions) {
        at = isUpright ? glm::vec3(at.x, 0.0f, -at.y) : at;
    }
    mesh.normals.clear();
    mesh.cornerNormals.clear();
    return mesh;
}

struct Dented {
    explicit Dented(const std::vector<Hit>& made) : mesh(flat()), render(buildRenderMesh(mesh)), hits(made) {
        ReferenceDeformation reference(render);
        reference.apply(hits);
        after.assign(mesh.positions.begin(), mesh.positions.end());
        for (std::size_t i = 0; i < render.vertices.size(); ++i) {
            after[render.fileVertices[i]] = reference.vertices()[i].position;
        }
        for (const std::uint32_t corner : render.triangles) {
            triangles.push_back(render.fileVertices[corner]);
        }
        for (std::uint32_t i = 0; i < after.size(); ++i) {
            if (after[i] != mesh.positions[i]) {
                whole.push_back(i);
            }
        }
        dents = dentsOfHits(hits);
        owners = dentOwners(render, whole, hits, dents);
    }
    [[nodiscard]] std::vector<std::uint32_t> partOf(std::uint32_t dent) const {
        std::vector<std::uint32_t> part;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            if (owners[i] == dent) {
                part.push_back(whole[i]);
            }
        }
        return part;
    }
    [[nodiscard]] DentMeasures measured(const std::vector<std::uint32_t>& part) const {
        return measureDent(part, triangles, mesh.positions, after, whole).value();
    }

    MeshData mesh;
    RenderMesh render;
    std::vector<Hit> hits;
    std::vector<glm::vec3> after;
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> whole;
    std::vector<std::uint32_t> dents;
    std::vector<std::uint32_t> owners;
};

}  // namespace

class DentOwnersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Two hits 0.9 m apart whose reaches of 0.5 m overlap: each keeps the depth that it was given.
    void overlappingHitsOfKnownDepthAreToldApart() {
        const Dented dented({hitAt(-0.45f, 0.0f, 0.3f), hitAt(0.45f, 0.0f, 0.25f)});
        QCOMPARE(dented.dents, (std::vector<std::uint32_t>{0, 1}));
        const DentMeasures first = dented.measured(dented.partOf(0));
        const DentMeasures second = dented.measured(dented.partOf(1));
        QVERIFY2(std::abs(first.depth - 0.3) < 1e-3, qPrintable(QString::number(first.depth)));
        QVERIFY2(std::abs(second.depth - 0.25) < 1e-3, qPrintable(QString::number(second.depth)));
        for (const std::uint32_t vertex : dented.partOf(0)) {
            QVERIFY(dented.mesh.positions[vertex].x < 0.03f);
        }
        for (const std::uint32_t vertex : dented.partOf(1)) {
            QVERIFY(dented.mesh.positions[vertex].x > -0.03f);
        }
        QVERIFY(std::none_of(dented.owners.begin(), dented.owners.end(),
                             [](std::uint32_t owner) { return owner == kNoIndex; }));
    }

    void partsAddUpToTheWhole() {
        const Dented dented({hitAt(-0.3f, 0.0f, 0.3f), hitAt(0.3f, 0.1f, 0.2f), hitAt(0.0f, 0.4f, 0.1f)});
        const DentMeasures whole = dented.measured(dented.whole);
        double area = 0.0;
        double volume = 0.0;
        std::size_t vertices = 0;
        for (const std::uint32_t dent : {0u, 1u, 2u}) {
            const DentMeasures part = dented.measured(dented.partOf(dent));
            area += part.affectedArea;
            volume += part.displacedVolume;
            vertices += part.vertices;
        }
        QCOMPARE(vertices, whole.vertices);
        QVERIFY(std::abs(area / whole.affectedArea - 1.0) < 1e-9);
        QVERIFY(std::abs(volume / whole.displacedVolume - 1.0) < 1e-9);
        QVERIFY(whole.displacedVolume > 0.0);
    }

    void hitsAtOnePlaceAndStrokesAreOneDent() {
        QCOMPARE(dentsOfHits(std::vector{hitAt(0.0f, 0.0f, 0.3f), hitAt(1.0f, 0.0f, 0.3f),
                                         hitAt(0.03f, 0.02f, 0.3f), hitAt(0.2f, 0.0f, 0.3f)}),
                 (std::vector<std::uint32_t>{0, 1, 0, 3}));
        std::vector<Hit> stroke{hitAt(0.0f, 0.0f, 0.3f), hitAt(5.0f, 0.0f, 0.3f), hitAt(0.4f, 0.0f, 0.3f),
                                hitAt(0.8f, 0.0f, 0.3f)};
        for (const std::size_t i : {0, 2, 3}) {
            stroke[i].group = {4, HitGroupKind::Stroke};
        }
        QCOMPARE(dentsOfHits(stroke), (std::vector<std::uint32_t>{0, 1, 0, 0}));
        stroke[2].group = {4, HitGroupKind::Scatter};
        QCOMPARE(dentsOfHits(stroke), (std::vector<std::uint32_t>{0, 1, 2, 0}));
    }

    /// Within the cap of both a vertex goes to the nearer one, though both move it as far.
    void betweenTwoCapsTheNearerHitHasIt() {
        const Dented dented({hitAt(-0.12f, 0.0f, 0.05f), hitAt(0.12f, 0.0f, 0.05f)});
        const auto left = dented.partOf(0);
        const auto right = dented.partOf(1);
        QVERIFY(std::abs(static_cast<double>(left.size()) - static_cast<double>(right.size())) <
                0.1 * static_cast<double>(left.size()));
    }
};

HITSCOPE_TEST(DentOwnersTest, QCoreApplication)

}  // namespace hitscope::dent_owners_test

#include "dent_owners_test.moc"
