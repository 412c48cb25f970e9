// SPDX-License-Identifier: GPL-3.0-or-later
// How a section is laid out, how deep it lies, and where a plane is, against closed forms.
#include "mesh/section_view.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "mesh/primitives.h"
#include "mesh/render_mesh.h"
#include "support/test_program.h"
#include "view/cutting_plane.h"

namespace hitscope::section_view_test {

namespace {

SectionCurve circle(float radius, int points, const glm::vec3& middle = glm::vec3(0.0f)) {
    SectionCurve curve;
    curve.closed = true;
    for (int i = 0; i < points; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(points);
        curve.points.push_back(middle + radius * glm::vec3(0.0f, std::cos(angle), std::sin(angle)));
    }
    return curve;
}

bool isNear(const glm::vec3& a, const glm::vec3& b) {
    return glm::distance(a, b) < 1.0e-5f;
}

}  // namespace

class SectionViewTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void axesKeepTheirOwnCoordinates() {
        struct Row {
            glm::vec3 towards;
            char right;
            bool rightMirrored;
            char up;
            bool upMirrored;
        };
        const Row rows[] = {{{1, 0, 0}, 'z', true, 'y', false},  {{-1, 0, 0}, 'z', false, 'y', false},
                            {{0, 0, 1}, 'x', false, 'y', false}, {{0, 0, -1}, 'x', true, 'y', false},
                            {{0, 1, 0}, 'x', false, 'z', true},  {{0, -1, 0}, 'x', true, 'z', true}};
        for (const Row& row : rows) {
            const SectionView view = sectionView(row.towards);
            QCOMPARE(view.right.name, row.right);
            QCOMPARE(view.right.mirrored, row.rightMirrored);
            QCOMPARE(view.up.name, row.up);
            QCOMPARE(view.up.mirrored, row.upMirrored);
            const glm::vec3 place(1.5f, -2.5f, 3.5f);
            QCOMPARE(view(place).x, static_cast<double>(row.right == 'x' ? place.x : place.z));
            QCOMPARE(view(place).y, static_cast<double>(row.up == 'y' ? place.y : place.z));
        }
    }

    void anyDirectionIsSeenUpright() {
        std::mt19937 random(5);
        std::normal_distribution<float> part;
        for (int i = 0; i < 200; ++i) {
            const glm::vec3 towards = glm::normalize(glm::vec3(part(random), part(random), part(random)));
            const SectionView view = sectionView(towards);
            const glm::vec3 right = view.right.direction * (view.right.mirrored ? -1.0f : 1.0f);
            const glm::vec3 up = view.up.direction * (view.up.mirrored ? -1.0f : 1.0f);
            QVERIFY(isNear(glm::cross(right, up), towards));
            QVERIFY(std::abs(glm::dot(right, towards)) < 1.0e-5f);
            QVERIFY(up.y > 0.0f);
        }
    }

    void concentricCirclesAreAsDeepAsTheyAreApart() {
        const std::vector<SectionCurve> before{circle(2.0f, 720)};
        const std::vector<SectionCurve> after{circle(1.7f, 97)};
        const SectionDepths depths = sectionDepths(before, after);
        QCOMPARE(depths.depths.size(), std::size_t{1});
        for (std::size_t i = 0; i < 97; ++i) {
            QVERIFY(std::abs(depths.depths[0][i] - 0.3f) < 1.0e-4f);
            QVERIFY(glm::distance(glm::normalize(depths.nearest[0][i]), glm::normalize(after[0].points[i])) <
                    5.0e-3f);
        }
    }

    void whatHasNotMovedIsNotDeep() {
        const std::vector<SectionCurve> before{circle(2.0f, 200), circle(0.5f, 60, {0.0f, 9.0f, 0.0f})};
        std::vector<SectionCurve> after = before;
        after[1].points[7] *= glm::vec3(1.0f, 1.0f, 0.5f);
        const SectionDepths depths = sectionDepths(before, after);
        for (std::size_t curve = 0; curve < 2; ++curve) {
            for (std::size_t i = 0; i < depths.depths[curve].size(); ++i) {
                QCOMPARE(depths.depths[curve][i] > 0.0f, curve == 1 && i == 7);
            }
        }
        QCOMPARE(depths.curve, std::size_t{1});
        QCOMPARE(depths.point, std::size_t{7});
        QCOMPARE(*depths.greatest, depths.depths[1][7]);
    }

    void theNearestPlaceIsTheNearest() {
        // Boxes of segments against every segment.
        std::mt19937 random(11);
        std::normal_distribution<float> part;
        SectionCurve wild;
        for (int i = 0; i < 300; ++i) {
            wild.points.emplace_back(0.0f, part(random), part(random));
        }
        const std::vector<SectionCurve> before{wild};
        SectionCurve asked;
        for (int i = 0; i < 200; ++i) {
            asked.points.emplace_back(0.0f, 2.0f * part(random), 2.0f * part(random));
        }
        const std::vector<SectionCurve> after{asked};
        const SectionDepths depths = sectionDepths(before, after);
        for (std::size_t i = 0; i < asked.points.size(); ++i) {
            float least = 1.0e9f;
            for (std::size_t s = 1; s < wild.points.size(); ++s) {
                for (int step = 0; step <= 100; ++step) {
                    const glm::vec3 on =
                        glm::mix(wild.points[s - 1], wild.points[s], 0.01f * static_cast<float>(step));
                    least = std::min(least, glm::distance(on, asked.points[i]));
                }
            }
            QVERIFY(depths.depths[0][i] <= least + 1.0e-5f);
            QVERIFY(depths.depths[0][i] >= least - 0.05f);
        }
    }

    void withoutAnOriginalThereAreNoDepths() {
        const std::vector<SectionCurve> after{circle(1.0f, 12)};
        const SectionDepths depths = sectionDepths({}, after);
        QVERIFY(!depths.greatest);
        QVERIFY(depths.depths.empty() && depths.nearest.empty());
    }

    void movedVerticesAreCutAsIfSetAnew() {
        const RenderMesh mesh = buildRenderMesh(makeUvSphere(48, 32, 1.0f));
        MeshSections moved(mesh);
        MeshSections set(mesh);
        std::vector<glm::vec3> places(moved.positions().begin(), moved.positions().end());
        std::mt19937 random(3);
        std::uniform_int_distribution<std::uint32_t> any(0, static_cast<std::uint32_t>(places.size()) - 1);
        for (int round = 0; round < 20; ++round) {
            std::vector<MovedVertex> moves;
            for (int i = 0; i < 30; ++i) {
                const std::uint32_t vertex = any(random);
                places[vertex] *= round % 2 == 0 ? 0.5f : 1.9f;
                moves.push_back({vertex, places[vertex]});
            }
            moved.move(moves);
            set.setPositions(places);
            const Plane plane{glm::normalize(glm::vec3(1.0f, 0.2f * static_cast<float>(round), 0.5f)), 0.1f};
            const auto a = moved.cut(plane);
            const auto b = set.cut(plane);
            QCOMPARE(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                QVERIFY(a[i].points == b[i].points && a[i].closed == b[i].closed);
            }
            QCOMPARE(moved.trianglesNear(plane), set.trianglesNear(plane));
        }
    }

    void planesHideTheirOpenSide() {
        CuttingPlane cut;
        cut.normal = glm::normalize(glm::vec3(1.0f, 2.0f, -0.5f));
        cut.offset = 0.7f;
        const glm::vec3 beyond = 0.8f * cut.normal;
        QVERIFY(!cut.hides(beyond));  // off
        cut.on = true;
        QVERIFY(cut.hides(beyond) && !cut.hides(0.6f * cut.normal));
        cut.flipped = true;
        QVERIFY(!cut.hides(beyond) && cut.hides(0.6f * cut.normal));
    }

    void raysStartWhereTargetsAreShown() {
        CuttingPlane cut;
        cut.offset = 1.0f;
        const Ray in{{5.0f, 2.0f, 0.0f}, {-1.0f, 0.0f, 0.0f}};
        QCOMPARE(shownPart(cut, in, 10.0f)->length, 10.0f);
        cut.on = true;
        QVERIFY(isNear(shownPart(cut, in, 10.0f)->ray.origin, {1.0f, 2.0f, 0.0f}));
        QCOMPARE(shownPart(cut, in, 10.0f)->length, 6.0f);
        QVERIFY(!shownPart(cut, in, 3.0f));
        QVERIFY(!shownPart(cut, {in.origin, {0.0f, 1.0f, 0.0f}}, 10.0f));
        const Ray out{{-2.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
        QVERIFY(isNear(shownPart(cut, out, 10.0f)->ray.origin, out.origin));
        QCOMPARE(shownPart(cut, out, 10.0f)->length, 3.0f);
        cut.flipped = true;
        QCOMPARE(shownPart(cut, in, 10.0f)->length, 4.0f);
    }

    void offsetsSpanTheBox() {
        Bounds box;
        box.add({-1.0f, 2.0f, 3.0f});
        box.add({1.0f, 4.0f, 9.0f});
        const OffsetRange x = offsetRange(box, {1.0f, 0.0f, 0.0f});
        QCOMPARE(x.low, -1.0f);
        QCOMPARE(x.high, 1.0f);
        const glm::vec3 slanted = glm::normalize(glm::vec3(1.0f, 1.0f, 1.0f));
        QVERIFY(std::abs(offsetRange(box, slanted).high - glm::dot(slanted, box.max)) < 1.0e-5f);
        CuttingPlane cut;
        cut.normal = slanted;
        cut.offset = 5.0f;
        const PlaneFrame pane = planeFrame(cut, box);
        QVERIFY(std::abs(glm::dot(pane.middle, slanted) - 5.0f) < 1.0e-4f);
        QVERIFY(std::abs(glm::dot(pane.right, slanted)) < 1.0e-4f);
        QVERIFY(isNear(glm::normalize(glm::cross(pane.right, pane.up)), slanted));
    }
};

HITSCOPE_TEST(SectionViewTest, QCoreApplication)

}  // namespace hitscope::section_view_test

#include "section_view_test.moc"
