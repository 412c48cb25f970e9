// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "mesh/triangulate.h"
#include "support/test_program.h"

namespace hitscope::mesh_triangulate_test {

using Outline = std::vector<glm::dvec2>;

namespace {

double doubleArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double doubleArea(const Outline& outline) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        sum += doubleArea(outline[0], outline[i], outline[i + 1]);
    }
    return sum;
}

Outline star(int points, double inner) {
    Outline outline;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * i / points;
        const double radius = i % 2 == 0 ? 1.0 : inner;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
}

Outline comb(int teeth) {
    Outline outline{{2.0 * teeth, 0.0}, {2.0 * teeth, 1.0}};
    for (int i = teeth - 1; i >= 0; --i) {
        outline.insert(outline.end(), {{2 * i + 1.5, 1.0}, {2 * i + 1.0, 9.0}, {2 * i + 0.5, 1.0}});
    }
    outline.insert(outline.end(), {{0.0, 1.0}, {0.0, 0.0}});
    return outline;
}

Outline spiral(int turns) {
    Outline outline;
    const int steps = 24 * turns;
    for (int i = 0; i <= steps; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 24.0;
        outline.emplace_back((1.0 + angle) * std::cos(angle), (1.0 + angle) * std::sin(angle));
    }
    for (int i = steps; i >= 0; --i) {
        const double angle = 2.0 * std::numbers::pi * i / 24.0;
        outline.emplace_back((0.0 + angle) * std::cos(angle), (0.0 + angle) * std::sin(angle));
    }
    return outline;
}

/// The outline in some plane of space.
std::vector<glm::vec3> inSpace(const Outline& outline, const glm::dvec3& u, const glm::dvec3& v) {
    std::vector<glm::vec3> positions;
    for (const glm::dvec2& point : outline) {
        positions.emplace_back(point.x * u + point.y * v);
    }
    return positions;
}

std::vector<std::uint32_t> indices(std::size_t count) {
    std::vector<std::uint32_t> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = static_cast<std::uint32_t>(i);
    }
    return result;
}

}  // namespace

class TriangulateTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void simplePolygonsAreCoveredOnce_data() {
        QTest::addColumn<Outline>("outline");
        QTest::newRow("square") << Outline{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
        QTest::newRow("arrowhead") << Outline{{0, 2}, {0, 0}, {-2, 0}, {0, -4}, {2, 0}};
        QTest::newRow("concave quad") << Outline{{0, 0}, {2, -3}, {0, 4}, {-2, -3}};
        QTest::newRow("concave quad, other corner first") << Outline{{2, -3}, {0, 4}, {-2, -3}, {0, 0}};
        QTest::newRow("u") << Outline{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
        QTest::newRow("corners on a line")
            << Outline{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
        QTest::newRow("triangle with many points on a side")
            << Outline{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {0, 3}};
        QTest::newRow("star") << star(5, 0.3);
        QTest::newRow("thin star") << star(100, 0.02);
        QTest::newRow("comb") << comb(50);
        QTest::newRow("spiral") << spiral(5);
        QTest::newRow("circle") << star(64, 1.0);
        // A square frame, its hole joined to the outside by a cut: two places are named twice.
        QTest::newRow("hole with a cut")
            << Outline{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    }
    void simplePolygonsAreCoveredOnce() {
        QFETCH(Outline, outline);
        const glm::dvec3 axes[][2] = {{{1, 0, 0}, {0, 1, 0}},
                                      {{0, 1, 0}, {1, 0, 0}},  // seen from behind
                                      {{0, 1, 0}, {0, 0, 1}},
                                      {{0.6, 0.8, 0}, {0, 0.1, 2}},
                                      {{1, 0, 0}, {0, 0, 1}}};
        for (const auto& [u, v] : axes) {
            std::vector<std::uint32_t> triangles;
            Triangulator().triangulate(inSpace(outline, u, v), indices(outline.size()), triangles);
            QCOMPARE(triangles.size(), 3 * (outline.size() - 2));
            double sum = 0.0;
            for (std::size_t t = 0; t < triangles.size(); t += 3) {
                const double area =
                    doubleArea(outline[triangles[t]], outline[triangles[t + 1]], outline[triangles[t + 2]]);
                QVERIFY(area > -1e-5);  // none is turned over: with the sum right, nothing is covered twice
                sum += area;
            }
            QVERIFY(std::abs(sum - doubleArea(outline)) < 1e-4 * doubleArea(outline));
        }
    }

    void quadsAreSplitOnTheShorterDiagonal() {
        std::vector<std::uint32_t> triangles;
        Triangulator().triangulate(inSpace({{0, 0}, {1, -1}, {4, 0}, {1, 1}}, {1, 0, 0}, {0, 1, 0}),
                                   indices(4), triangles);
        QCOMPARE(triangles, (std::vector<std::uint32_t>{0, 1, 3, 1, 2, 3}));
    }

    void degeneratePolygonsGiveTheirTriangles_data() {
        QTest::addColumn<Outline>("outline");
        QTest::newRow("a point") << Outline(20, {1, 1});
        QTest::newRow("a line") << Outline{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 0}, {1, 0}};
        QTest::newRow("crossing quad") << Outline{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
        QTest::newRow("pentagram") << Outline{{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}};
        QTest::newRow("huge") << Outline{{0, 0}, {3e38, 0}, {1e38, 1e38}, {0, 3e38}, {-1e38, -1e38}};
        QTest::newRow("tiny") << Outline{{0, 0}, {1e-44, 0}, {0, 0}, {0, 1e-44}};
    }
    void degeneratePolygonsGiveTheirTriangles() {
        QFETCH(Outline, outline);
        std::vector<std::uint32_t> triangles;
        Triangulator().triangulate(inSpace(outline, {1, 0, 0}, {0, 1, 0}), indices(outline.size()),
                                   triangles);
        QCOMPARE(triangles.size(), 3 * (outline.size() - 2));
        for (const std::uint32_t corner : triangles) {
            QVERIFY(corner < outline.size());
        }
    }

    void randomPolygonsNameEveryCorner() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
        Triangulator triangulator;
        for (int round = 0; round < 500; ++round) {
            Outline outline(4 + random() % 30);
            for (glm::dvec2& point : outline) {
                point = {coordinate(random), coordinate(random)};
            }
            std::vector<std::uint32_t> triangles;
            triangulator.triangulate(inSpace(outline, {1, 0, 0}, {0, 1, 0}), indices(outline.size()),
                                     triangles);
            QCOMPARE(triangles.size(), 3 * (outline.size() - 2));
            QCOMPARE(std::set<std::uint32_t>(triangles.begin(), triangles.end()).size(), outline.size());
        }
    }

    /// A hostile polygon ends as a fan instead of keeping the program busy for hours.
    void workIsLimited() {
        const Outline outline = comb(100000);
        std::vector<std::uint32_t> triangles;
        Triangulator().triangulate(inSpace(outline, {1, 0, 0}, {0, 1, 0}), indices(outline.size()),
                                   triangles);
        QCOMPARE(triangles.size(), 3 * (outline.size() - 2));
    }

    void areaVectorsCountHolesAndTurns() {
        const Outline outline{{0, 2}, {0, 0}, {-2, 0}, {0, -4}, {2, 0}};
        QVERIFY(doubleAreaVector(inSpace(outline, {1, 0, 0}, {0, 1, 0}), indices(5)) == glm::dvec3(0, 0, 20));
        QVERIFY(doubleAreaVector(inSpace(outline, {0, 1, 0}, {1, 0, 0}), indices(5)) ==
                glm::dvec3(0, 0, -20));
    }
};

HITSCOPE_TEST(TriangulateTest, QCoreApplication)

}  // namespace hitscope::mesh_triangulate_test

#include "mesh_triangulate_test.moc"
