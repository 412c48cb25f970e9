// SPDX-License-Identifier: GPL-3.0-or-later
// Sections and dents against closed forms.
#include "mesh/section.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "mesh/dent.h"
#include "mesh/dent_profile.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "support/test_program.h"
#include "unit/mesh_support.h"

namespace hitscope::section_test {

namespace {

constexpr double kPi = std::numbers::pi;

double lengthOf(const SectionCurve& curve) {
    double length = 0.0;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        length += static_cast<double>(glm::distance(curve.points[i - 1], curve.points[i]));
    }
    return curve.closed
               ? length + static_cast<double>(glm::distance(curve.points.back(), curve.points.front()))
               : length;
}

/// A fine sheet with a bowl of depth D (1 - (r/R)^2)^2 pressed into it, against its normal.
struct PressedSheet {
    static constexpr double kDepth = 0.2;
    static constexpr double kRadius = 0.6;
    RenderMesh render = buildRenderMesh(makeSheet(200, 200, 2.0f, 2.0f));
    MeshSections sections{render};
    std::vector<glm::vec3> before{sections.positions().begin(), sections.positions().end()};
    std::vector<glm::vec3> after = before;
    glm::vec3 normal = render.vertices.front().normal;

    PressedSheet() {
        glm::vec3 middle(0.0f);
        for (const glm::vec3& point : before) {
            middle += point / static_cast<float>(before.size());
        }
        for (glm::vec3& point : after) {
            const auto r = static_cast<double>(glm::distance(point, middle)) / kRadius;
            if (r < 1.0) {
                point -= normal * static_cast<float>(kDepth * std::pow(1.0 - r * r, 2.0));
            }
        }
    }
    [[nodiscard]] std::uint32_t deepest() const {
        std::uint32_t deepest = 0;
        for (std::uint32_t v = 0; v < before.size(); ++v) {
            if (glm::distance(before[v], after[v]) > glm::distance(before[deepest], after[deepest])) {
                deepest = v;
            }
        }
        return deepest;
    }
};

}  // namespace

class SectionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSphereIsCutInACircle();
    void aTorusIsCutInTwo();
    void anOpenSheetIsCutInALine();
    void aPlaneThroughVerticesCutsOnce();
    void aPlaneThroughOneVertexCutsNothing();
    void missingTheMeshCutsNothing();
    void aCutLooksAtWhatIsNear();
    void movedVerticesAreCutWhereTheyAre();
    void aDentOfKnownShape();
    void aThinLimbIsAsDeepAsItMoved();
    void dentsApartAreMeasuredApart();
    void theProfileOfADent();
    void theProfileIsOfTheDentedWall();
};

void SectionTest::aSphereIsCutInACircle() {
    const RenderMesh sphere = buildRenderMesh(makeUvSphere(128, 64, 2.5f));
    const MeshSections sections(sphere);
    const Plane plane{glm::normalize(glm::vec3(1.0f, 2.0f, 0.5f)), 1.5f};
    const std::vector<SectionCurve> curves = sections.cut(plane);
    QCOMPARE(curves.size(), std::size_t{1});
    QVERIFY(curves[0].closed);
    QVERIFY(curves[0].points.size() > 100);
    const double radius = 2.0;  // sqrt(2.5^2 - 1.5^2)
    for (const glm::vec3& point : curves[0].points) {
        QVERIFY(std::abs(glm::dot(plane.normal, point) - 1.5f) < 1.0e-5f);
        const double r = static_cast<double>(glm::length(point - plane.normal * 1.5f));
        QVERIFY2(r < radius + 1.0e-4 && r > radius - 5.0e-3, qPrintable(QString::number(r)));
    }
    QVERIFY(std::abs(lengthOf(curves[0]) / (2.0 * kPi * radius) - 1.0) < 1.0e-3);
}

void SectionTest::aTorusIsCutInTwo() {
    const RenderMesh torus = buildRenderMesh(makeTorus(128, 64, 2.0f, 0.5f));
    // Through the axis: two circles of the tube, whichever way the torus lies.
    const glm::vec3 size = torus.bounds.max - torus.bounds.min;
    const glm::vec3 normal = size.x < size.y ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const std::vector<SectionCurve> curves = MeshSections(torus).cut({normal, 1.0e-3f});
    QCOMPARE(curves.size(), std::size_t{2});
    for (const SectionCurve& curve : curves) {
        QVERIFY(curve.closed);
        QVERIFY(std::abs(lengthOf(curve) / (2.0 * kPi * 0.5) - 1.0) < 5.0e-3);
    }
    // Across it: an outer and an inner circle.
    const glm::vec3 axis =
        size.x < size.y ? glm::vec3(1, 0, 0) : (size.y < size.z ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1));
    std::vector<SectionCurve> rings = MeshSections(torus).cut({axis, 1.0e-3f});
    QCOMPARE(rings.size(), std::size_t{2});
    std::sort(rings.begin(), rings.end(),
              [](const SectionCurve& a, const SectionCurve& b) { return lengthOf(a) < lengthOf(b); });
    QVERIFY(std::abs(lengthOf(rings[0]) / (2.0 * kPi * 1.5) - 1.0) < 5.0e-3);
    QVERIFY(std::abs(lengthOf(rings[1]) / (2.0 * kPi * 2.5) - 1.0) < 5.0e-3);
}

void SectionTest::anOpenSheetIsCutInALine() {
    const PressedSheet sheet;
    const Plane plane{glm::normalize(glm::cross(sheet.normal, glm::vec3(1.0f, 1.0f, 1.0f))), 0.0f};
    const std::vector<SectionCurve> curves = sheet.sections.cut(plane);
    QCOMPARE(curves.size(), std::size_t{1});
    QVERIFY(!curves[0].closed);
    const glm::vec3 way = curves[0].points.back() - curves[0].points.front();
    QVERIFY(std::abs(lengthOf(curves[0]) - static_cast<double>(glm::length(way))) < 1.0e-4);
}

void SectionTest::aPlaneThroughVerticesCutsOnce() {
    const RenderMesh cube = buildRenderMesh(makeCube(8, 1.0f));
    for (const float offset : {0.0f, 0.25f, -0.5f}) {
        const std::vector<SectionCurve> curves = MeshSections(cube).cut({glm::vec3(0, 1, 0), offset});
        QCOMPARE(curves.size(), std::size_t{1});
        QVERIFY(curves[0].closed);
        QVERIFY(std::abs(lengthOf(curves[0]) - 8.0) < 1.0e-4);
        const std::vector<glm::vec3>& points = curves[0].points;
        QVERIFY(std::adjacent_find(points.begin(), points.end()) == points.end());
        QVERIFY(points.front() != points.back());
    }
}

void SectionTest::aPlaneThroughOneVertexCutsNothing() {
    const RenderMesh sphere = buildRenderMesh(makeUvSphere(128, 64, 2.5f));
    float top = 0.0f;
    for (const DynamicVertex& vertex : sphere.vertices) {
        top = std::max(top, vertex.position.y);
    }
    QVERIFY(MeshSections(sphere).cut({{0.0f, 1.0f, 0.0f}, top}).empty());
}

void SectionTest::missingTheMeshCutsNothing() {
    const RenderMesh cube = buildRenderMesh(makeCube(4, 1.0f));
    QVERIFY(MeshSections(cube).cut({glm::vec3(0, 1, 0), 1.5f}).empty());
    QVERIFY(MeshSections(RenderMesh()).cut({}).empty());
}

void SectionTest::aCutLooksAtWhatIsNear() {
    const RenderMesh sphere = buildRenderMesh(makeUvSphere(400, 200, 2.5f));
    const MeshSections sections(sphere);
    const Plane plane{glm::vec3(0.6f, 0.0f, 0.8f), 0.7f};
    QVERIFY(sections.trianglesNear(plane) > 0);
    QVERIFY2(sections.trianglesNear(plane) < sphere.triangles.size() / 3 / 8,
             qPrintable(QString::number(sections.trianglesNear(plane))));
}

void SectionTest::movedVerticesAreCutWhereTheyAre() {
    const RenderMesh cube = buildRenderMesh(makeCube(4, 1.0f));
    MeshSections sections(cube);
    std::vector<glm::vec3> moved(sections.positions().begin(), sections.positions().end());
    for (glm::vec3& point : moved) {
        point += glm::vec3(0.0f, 5.0f, 0.0f);
    }
    sections.setPositions(moved);
    QVERIFY(sections.cut({glm::vec3(0, 1, 0), 0.1f}).empty());
    QCOMPARE(sections.cut({glm::vec3(0, 1, 0), 5.1f}).size(), std::size_t{1});
}

void SectionTest::aDentOfKnownShape() {
    const PressedSheet sheet;
    const std::span<const std::uint32_t> triangles = sheet.sections.triangles();
    const std::vector<std::uint32_t> vertices =
        dentAround(sheet.deepest(), triangles, sheet.before, sheet.after);
    const std::optional<DentMeasures> dent = measureDent(vertices, triangles, sheet.before, sheet.after);
    QVERIFY(dent);
    QCOMPARE(dent->vertices, vertices.size());
    QCOMPARE(dent->deepest, sheet.deepest());
    QVERIFY(glm::distance(dent->axis, -sheet.normal) < 1.0e-4f);
    const double radius = PressedSheet::kRadius;
    // The grid is 0.01 m; the rim's own vertices have not moved.
    QVERIFY(std::abs(dent->depth - PressedSheet::kDepth) < 1.0e-4);
    QVERIFY(std::abs(dent->rimDiameter - 2.0 * radius) < 0.03);
    QVERIFY(std::abs(dent->affectedArea / (kPi * radius * radius) - 1.0) < 0.02);
    QVERIFY(std::abs(dent->displacedVolume / (kPi * radius * radius * PressedSheet::kDepth / 3.0) - 1.0) <
            1.0e-3);
}

/// Both sides of a thin plate are pushed along it and a little across: its normals say nothing of a depth.
void SectionTest::aThinLimbIsAsDeepAsItMoved() {
    constexpr std::uint32_t kSide = 21;
    std::vector<glm::vec3> before;
    std::vector<std::uint32_t> triangles;
    for (const float height : {0.0f, -0.01f}) {
        const auto first = static_cast<std::uint32_t>(before.size());
        for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
            before.emplace_back(0.05f * static_cast<float>(i % kSide), height,
                                0.05f * static_cast<float>(i / kSide));
        }
        for (std::uint32_t i = 0; i + kSide < kSide * kSide; ++i) {
            if (i % kSide + 1 < kSide) {
                const std::uint32_t a = first + i;
                const std::uint32_t b = height == 0.0f ? a + kSide : a + 1;
                const std::uint32_t c = height == 0.0f ? a + 1 : a + kSide;
                triangles.insert(triangles.end(), {a, b, c, b, a + kSide + 1, c});
            }
        }
    }
    std::vector<glm::vec3> after = before;
    std::vector<std::uint32_t> vertices;
    const glm::vec3 push(0.1f, 0.02f, 0.0f);
    for (std::uint32_t vertex = 0; vertex < before.size(); ++vertex) {
        if (glm::distance(before[vertex], glm::vec3(0.5f, 0.0f, 0.5f)) < 0.2f) {
            after[vertex] += push;
            vertices.push_back(vertex);
        }
    }
    const std::optional<DentMeasures> dent = measureDent(vertices, triangles, before, after);
    QVERIFY(dent);
    QVERIFY(glm::distance(dent->axis, glm::normalize(push)) < 1.0e-4f);
    QVERIFY(std::abs(dent->depth - static_cast<double>(glm::length(push))) < 1.0e-5);
    QVERIFY(std::abs(dent->rimDiameter - 0.4) < 0.06);
}

void SectionTest::dentsApartAreMeasuredApart() {
    PressedSheet sheet;
    const std::span<const std::uint32_t> triangles = sheet.sections.triangles();
    const std::uint32_t deepest = sheet.deepest();
    const std::size_t one = dentAround(deepest, triangles, sheet.before, sheet.after).size();
    const std::uint32_t corner = 0;  // of the sheet, far from the bowl
    QVERIFY(dentAround(corner, triangles, sheet.before, sheet.after).empty());
    sheet.after[corner] -= sheet.normal;
    QCOMPARE(dentAround(corner, triangles, sheet.before, sheet.after), std::vector<std::uint32_t>{corner});
    QCOMPARE(dentAround(deepest, triangles, sheet.before, sheet.after).size(), one);
    QVERIFY(!measureDent({}, triangles, sheet.before, sheet.after));
}

void SectionTest::theProfileOfADent() {
    PressedSheet sheet;
    const std::span<const std::uint32_t> triangles = sheet.sections.triangles();
    const std::vector<std::uint32_t> vertices =
        dentAround(sheet.deepest(), triangles, sheet.before, sheet.after);
    const DentMeasures dent = *measureDent(vertices, triangles, sheet.before, sheet.after);
    const glm::vec3 deepest = sheet.before[dent.deepest];
    sheet.sections.setPositions(sheet.after);
    for (const float angle : {0.0f, 0.4f, 1.5707963f}) {
        const Plane plane = profilePlane(dent, deepest, angle);
        QVERIFY(std::abs(glm::dot(plane.normal, dent.axis)) < 1.0e-5f);
        const std::vector<SectionCurve> curves = sheet.sections.cut(plane);
        QCOMPARE(curves.size(), std::size_t{1});
        for (const glm::vec3& point : curves[0].points) {
            const ProfilePoint at = toProfile(plane, dent, deepest, point);
            const double r = std::abs(at.along) / PressedSheet::kRadius;
            const double should = r < 1.0 ? -PressedSheet::kDepth * std::pow(1.0 - r * r, 2.0) : 0.0;
            QVERIFY(std::abs(at.height - should) < 1.0e-3);
        }
    }
}

/// A sphere is cut in one closed line: what is shown of it ends near the dent, wherever the line starts.
void SectionTest::theProfileIsOfTheDentedWall() {
    MeshSections sections(buildRenderMesh(makeUvSphere(128, 64, 1.0f)));
    const std::vector<glm::vec3> before(sections.positions().begin(), sections.positions().end());
    for (const glm::vec3& towards : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(-0.6f, 0.8f, 0)}) {
        std::vector<glm::vec3> after = before;
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t vertex = 0; vertex < before.size(); ++vertex) {
            if (const float r = glm::distance(before[vertex], towards); r < 0.8f) {
                after[vertex] -= 0.3f * (1.0f - r / 0.8f) * towards;
                vertices.push_back(vertex);
            }
        }
        const DentMeasures dent = *measureDent(vertices, sections.triangles(), before, after);
        const glm::vec3 deepest = before[dent.deepest];
        for (const float angle : {0.0f, 0.7f, 1.5f, 2.6f}) {
            const Plane plane = profilePlane(dent, deepest, angle);
            const ProfileFrame frame = profileFrame(dent, plane, vertices, before, after);
            for (const std::vector<glm::vec3>& positions : {before, after}) {
                sections.setPositions(positions);
                const std::vector<ProfilePoint> line =
                    profileLine(sections.cut(plane), plane, dent, deepest, frame, positions[dent.deepest]);
                QVERIFY(line.size() > 20);
                const auto [left, right] = std::minmax_element(
                    line.begin(), line.end(), [](const auto& a, const auto& b) { return a.along < b.along; });
                // From rim to rim and beyond: the line is whole.
                QVERIFY(left->along < -0.45 * dent.rimDiameter && right->along > 0.45 * dent.rimDiameter);
                for (const ProfilePoint& point : line) {
                    QVERIFY2(point.height > -1.0, qPrintable(QString::number(point.height)));
                }
            }
        }
    }
}

HITSCOPE_TEST(SectionTest, QCoreApplication)

}  // namespace hitscope::section_test

#include "section_test.moc"
