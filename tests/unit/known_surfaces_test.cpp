// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics, attribution and dents held against closed forms, of the very polyhedra: no limit is taken.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "deform/attribution.h"
#include "deform/reference.h"
#include "mesh/dent.h"
#include "mesh/geodesic_sphere.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "mesh/surface/surface_measurer.h"
#include "solids.h"
#include "support/test_program.h"
#include "unit/deform_support.h"

namespace hitscope::known_surfaces_test {

using namespace test;

namespace {

constexpr double kPi = std::numbers::pi;

/// A corner of a profile that is turned about an axis, in n flat steps: distance from the axis and height.
using Profile = std::vector<std::pair<double, double>>;

/// Between the planes of a closed profile's corners the solid is a frustum of a regular n-gon.
double turnedVolume(const Profile& profile, int n) {
    double sum = 0.0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const auto& [r, z] = profile[i];
        const auto& [s, w] = profile[(i + 1) % profile.size()];
        sum += (w - z) * (r * r + r * s + s * s) / 3.0;
    }
    return std::abs(0.5 * n * std::sin(2.0 * kPi / n) * sum);
}

/// Each step of the profile makes n flat trapezia.
double turnedArea(const Profile& profile, int n, bool isClosed) {
    double sum = 0.0;
    for (std::size_t i = 0; i + (isClosed ? 0 : 1) < profile.size(); ++i) {
        const auto& [r, z] = profile[i];
        const auto& [s, w] = profile[(i + 1) % profile.size()];
        const double height = std::hypot((s - r) * std::cos(kPi / n), w - z);
        sum += (r + s) * std::sin(kPi / n) * height * n;
    }
    return sum;
}

Profile halfCircle(int rings) {
    Profile profile;
    for (int ring = 0; ring <= rings; ++ring) {
        profile.emplace_back(std::sin(kPi * ring / rings), std::cos(kPi * ring / rings));
    }
    return profile;
}

Profile circle(int across, double radius, double tube) {
    Profile profile;
    for (int i = 0; i < across; ++i) {
        profile.emplace_back(radius + tube * std::cos(2.0 * kPi * i / across),
                             tube * std::sin(2.0 * kPi * i / across));
    }
    return profile;
}

/// A plate of unit cubes, 2 x + 1 by 2 y + 1, with x by y of them left out: a handle each.
MeshData sieve(int x, int y) {
    const int width = 2 * x + 1;
    const int depth = 2 * y + 1;
    PageVector<glm::vec3> positions;
    std::map<std::tuple<int, int, int>, std::uint32_t> known;
    const auto at = [&](int i, int j, int k) {
        const auto [found, isNew] =
            known.try_emplace({i, j, k}, static_cast<std::uint32_t>(positions.size()));
        if (isNew) {
            positions.emplace_back(i, j, k);
        }
        return found->second;
    };
    const auto isFull = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < width && j < depth && (i % 2 == 0 || j % 2 == 0);
    };
    std::vector<std::vector<std::uint32_t>> faces;
    for (int i = 0; i < width; ++i) {
        for (int j = 0; j < depth; ++j) {
            if (!isFull(i, j)) {
                continue;
            }
            faces.push_back({at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1)});
            faces.push_back({at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)});
            if (!isFull(i - 1, j)) {
                faces.push_back({at(i, j, 0), at(i, j, 1), at(i, j + 1, 1), at(i, j + 1, 0)});
            }
            if (!isFull(i + 1, j)) {
                faces.push_back({at(i + 1, j, 0), at(i + 1, j + 1, 0), at(i + 1, j + 1, 1), at(i + 1, j, 1)});
            }
            if (!isFull(i, j - 1)) {
                faces.push_back({at(i, j, 0), at(i + 1, j, 0), at(i + 1, j, 1), at(i, j, 1)});
            }
            if (!isFull(i, j + 1)) {
                faces.push_back({at(i, j + 1, 0), at(i, j + 1, 1), at(i + 1, j + 1, 1), at(i + 1, j + 1, 0)});
            }
        }
    }
    return meshOf(std::move(positions), faces);
}

/// The sieve's upper side alone: a flat surface with as many holes and its outer boundary.
MeshData lid(int x, int y) {
    const MeshData whole = sieve(x, y);
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::size_t f = 0; f < whole.faceCount(); ++f) {
        const auto face = whole.face(f);
        if (std::all_of(face.begin(), face.end(),
                        [&](std::uint32_t v) { return whole.positions[v].z > 0.5f; })) {
            faces.emplace_back(face.begin(), face.end());
        }
    }
    return meshOf(whole.positions, faces);
}

MeshData moved(MeshData mesh, const glm::vec3& scale, const glm::vec3& by) {
    for (glm::vec3& position : mesh.positions) {
        position = position * scale + by;
    }
    return mesh;
}

MeshData hollowBall() {
    MeshData inner = moved(makeUvSphere(24, 12, 1.0f), glm::vec3(0.5f), glm::vec3(0.0f));
    for (std::size_t f = 0; f < inner.faceCount(); ++f) {
        turnOver(inner, f);
    }
    return together(makeUvSphere(24, 12, 1.0f), inner);
}

struct Known {
    long long euler = 0;
    std::optional<long long> genus;
    std::size_t holes = 0;
    std::size_t components = 1;
    double area = 0.0;
    std::optional<double> volume;  ///< of closed surfaces
};

}  // namespace

class KnownSurfacesTest : public QObject {
    Q_OBJECT

private:
    static void check(const MeshData& mesh, const Known& known) {
        auto shared = std::make_shared<const MeshData>(mesh);
        const SurfaceMeasurer measurer(shared, SurfaceTopology::build(*shared));
        const SurfaceStatistics& is = measurer.topology().statistics();
        const SurfaceMeasures measures = measurer.measures();
        QCOMPARE(is.eulerCharacteristic, known.euler);
        QCOMPARE(is.genus, known.genus);
        QCOMPARE(is.holes, known.holes);
        QCOMPARE(is.components, known.components);
        // Positions are floats: of unit size, they are off by 3e-8 each.
        QVERIFY2(std::abs(measures.faceArea.sum / known.area - 1.0) < 2.0e-7,
                 qPrintable(QString::number(measures.faceArea.sum, 'g', 12)));
        QCOMPARE(is.isSolid(), known.volume.has_value());
        if (known.volume) {
            QVERIFY2(std::abs(measures.volume() / *known.volume - 1.0) < 2.0e-7,
                     qPrintable(QString::number(measures.volume(), 'g', 12)));
        }
    }

private Q_SLOTS:
    void box() {
        check(moved(makeCube(4, 0.5f), {2.0f, 3.0f, 4.0f}, {7.0f, -5.0f, 1.0f}), {2, 0, 0, 1, 52.0, 24.0});
    }

    void sphere() {
        const Profile profile = halfCircle(12);
        check(makeUvSphere(24, 12, 1.0f),
              {2, 0, 0, 1, turnedArea(profile, 24, false), turnedVolume(profile, 24)});
    }

    void torusOfOneHandle() {
        const Profile profile = circle(20, 2.0, 0.5);
        check(torus(40, 20, 2.0, 0.5),
              {0, 1, 0, 1, turnedArea(profile, 40, true), turnedVolume(profile, 40)});
    }

    void cylinderWithAndWithoutLids() {
        const double ring = 0.5 * 32 * std::sin(2.0 * kPi / 32);
        const double wall = turnedArea({{1.0, 0.0}, {1.0, 1.0}}, 32, false);
        check(cylinder(32, true), {2, 0, 0, 1, wall + 2.0 * ring, ring});
        check(cylinder(32, false), {0, 0, 2, 1, wall, std::nullopt});
    }

    void sieveOfSixHandles() {
        // Upper and lower side have 35 - 6 cells; the rim 24 walls, each hole 4.
        check(sieve(3, 2), {2 - 2 * 6, 6, 0, 1, 2.0 * 29 + 24 + 24, 29.0});
    }

    void flatSurfaceWithHoles() { check(lid(3, 2), {1 - 6, 0, 7, 1, 29.0, std::nullopt}); }

    void hollowBallHasTwoSides() {
        const Profile profile = halfCircle(12);
        check(hollowBall(),
              {4, 0, 0, 2, 1.25 * turnedArea(profile, 24, false), 0.875 * turnedVolume(profile, 24)});
    }

    // What CGAL 5.5.1 (Polygon_mesh_processing: area, volume, connected_components, extract_boundary_cycles)
    // gives for the same polygons, written to OFF with nine digits; for those above it gives the closed
    // forms.
    void agreesWithCgal() {
        check(makeGeodesicSphere(6, 1.0f), {2, 0, 0, 1, 12.45976306, 4.124911224});
        check(makeCylinder(32, 4, 3, 1.0f, 2.0f), {2, 0, 0, 1, 18.78908381, 6.242890075});
    }

    // Each part is min(power / r, max_magnitude) along the hit's direction, r from where the vertex is then
    // (eq. 3 and 4); the parts add up to how far it is from where it was (eq. 1).
    void attributionAddsUp() {
        const glm::dvec3 start(0.3, -0.2, 0.1);
        std::mt19937 random(19);
        std::vector<Hit> hits;
        for (int i = 0; i < 60; ++i) {
            hits.push_back(randomHit(random, 0.6f));
        }
        Attribution attribution(DynamicVertex{glm::vec3(start), {0.0f, 0.0f, 1.0f}});
        std::size_t within = 0;
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const glm::dvec3 at(attribution.vertex().position);
            const double r = glm::distance(at, glm::dvec3(hits[i].point));
            const bool reaches = attribution.add(i, hits[i]);
            QCOMPARE(reaches, r <= 0.5);
            if (reaches) {
                ++within;
                const VertexContribution& part = attribution.contributions().back();
                QCOMPARE(part.hit, i);
                const double magnitude = std::min(0.05 / r, 0.3);
                const glm::dvec3 should = magnitude * glm::dvec3(hits[i].direction);
                QVERIFY(glm::distance(glm::dvec3(part.contribution.displacement), should) < 1.0e-6);
                sum += glm::dvec3(part.contribution.displacement);
            }
        }
        QCOMPARE(attribution.contributions().size(), within);
        QVERIFY(within > 5);
        QVERIFY(glm::distance(start + sum, glm::dvec3(attribution.vertex().position)) < 1.0e-5);
    }

    // One hit on a flat sheet: a displacement of c within r0 = p / c and of p / r from there to R, so the
    // volume is pi c r0^2 + 2 pi p (R - r0) times the cosine of the hit's angle.
    void theDentOfOneHit_data() {
        QTest::addColumn<double>("angle");
        QTest::addRow("head-on") << 0.0;
        QTest::addRow("at an angle") << 0.5;
    }
    void theDentOfOneHit() {
        QFETCH(const double, angle);
        const RenderMesh mesh = buildRenderMesh(makeSheet(300, 300, 1.5f, 1.5f));
        const glm::vec3 normal = mesh.vertices.front().normal;
        const glm::vec3 aside = glm::normalize(glm::cross(normal, glm::vec3(0.3f, 0.5f, 0.7f)));
        Hit hit;
        hit.point = mesh.bounds.centre();
        hit.direction =
            static_cast<float>(std::sin(angle)) * aside - static_cast<float>(std::cos(angle)) * normal;
        ReferenceDeformation reference(mesh);
        reference.apply({&hit, 1});
        const MeshSections sections(mesh);
        std::vector<glm::vec3> after(sections.positions().size());
        for (std::size_t r = 0; r < mesh.vertices.size(); ++r) {
            after[mesh.fileVertices[r]] = reference.vertices()[r].position;
        }
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t v = 0; v < after.size(); ++v) {
            if (after[v] != sections.positions()[v]) {
                vertices.push_back(v);
            }
        }
        const auto dent = measureDent(vertices, sections.triangles(), sections.positions(), after);
        QVERIFY(dent);
        const double reach = 0.5;
        const double power = 0.05;
        const double cap = 0.3;
        const double flat = power / cap;
        const double volume =
            (kPi * cap * flat * flat + 2.0 * kPi * power * (reach - flat)) * std::cos(angle);
        QVERIFY(glm::distance(dent->axis, -normal) < 1.0e-5f);
        QVERIFY(std::abs(dent->depth - cap * std::cos(angle)) < 1.0e-5);
        // The grid is 0.005 m.
        QVERIFY(std::abs(dent->rimDiameter - 2.0 * reach) < 0.02);
        QVERIFY(std::abs(dent->affectedArea / (kPi * reach * reach) - 1.0) < 0.01);
        QVERIFY2(std::abs(dent->displacedVolume / volume - 1.0) < 0.01,
                 qPrintable(QString::number(dent->displacedVolume / volume)));
    }
};

HITSCOPE_TEST(KnownSurfacesTest, QCoreApplication)

}  // namespace hitscope::known_surfaces_test

#include "known_surfaces_test.moc"
