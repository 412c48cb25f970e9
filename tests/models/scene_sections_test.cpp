// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of a session's targets, against circles and against cuts made from scratch; what is said of them.
#include "analysis/scene_sections.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "deform/reference.h"
#include "mesh/primitives.h"
#include "models/section_report.h"
#include "session/primitive_target.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::scene_sections_test {

namespace {

constexpr float kRadius = 2.5f;

/// What a faultless pipeline would deliver.
void readBack(Session& session) {
    test::readBackOf(session).restart();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        ReferenceDeformation reference(target->deformed.render());
        reference.apply(session.hits().history().hitsOn(target->id));
        test::readBackOf(session).take(target->id, 0, reference.vertices());
    }
    test::readBackOf(session).finish();
}

Hit hitAt(const Target& target, const glm::vec3& from) {
    Hit hit;
    hit.target = target.id;
    hit.point = kRadius * glm::normalize(from);
    hit.direction = -glm::normalize(from);
    return hit;
}

CuttingPlane across(const glm::vec3& normal, float offset) {
    CuttingPlane cut;
    cut.on = true;
    cut.normal = glm::normalize(normal);
    cut.offset = offset;
    return cut;
}

bool isSettled(const SceneSections& sections) {
    return sections.section() != nullptr && !sections.isBusy();
}

bool isSame(const std::vector<SectionCurve>& a, const std::vector<SectionCurve>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const SectionCurve& one, const SectionCurve& other) {
                          return one.closed == other.closed && one.points == other.points;
                      });
}

}  // namespace

class SceneSectionsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadMesh(*m_session, makeUvSphere(96, 64, kRadius));
        m_sections = std::make_unique<SceneSections>(*m_session);
    }
    void cleanup() {
        m_sections.reset();
        m_session.reset();
    }

    void aSphereIsCutInACircle() {
        const glm::vec3 middle = target().transform.position;
        const glm::vec3 normal = glm::normalize(glm::vec3(1.0f, 0.4f, -0.3f));
        cut(across(normal, 0.6f + glm::dot(normal, middle)));
        QCOMPARE(section().targets.size(), std::size_t{1});
        const auto& original = section().targets[0].original;
        QCOMPARE(original.size(), std::size_t{1});
        QVERIFY(original[0].closed && original[0].points.size() > 60);
        const float radius = std::sqrt(kRadius * kRadius - 0.36f);
        for (const glm::vec3& point : original[0].points) {
            QVERIFY(std::abs(glm::dot(normal, point - middle) - 0.6f) < 1.0e-4f);
            const float away = glm::distance(point, middle + 0.6f * normal);
            QVERIFY(away <= radius + 1.0e-4f && away > radius * 0.995f);
        }
        QVERIFY(isSame(original, section().targets[0].deformed));
        QCOMPARE(section().targets[0].depths.greatest.value(), 0.0f);
        QVERIFY(!deepestOf(section(), {}));
    }

    void withoutAPlaneThereIsNothing() {
        m_sections->setCut(CuttingPlane(), 1.0f);
        QVERIFY(!m_sections->isBusy());
        readBack(*m_session);
        QVERIFY(!m_sections->isBusy());
        cut(across({1.0f, 0.0f, 0.0f}, 0.0f));
        QSignalSpy changed(m_sections.get(), &SceneSections::changed);
        m_sections->setCut(CuttingPlane(), 1.0f);
        QVERIFY(!m_sections->section() && !m_sections->isBusy());
        QCOMPARE(changed.count(), 1);
    }

    void ofWhatSomebodyElseHas() {
        DeformedMesh other(target().deformed.sharedOriginal(), target().deformed.sharedRender());
        PageVector<DynamicVertex> vertices = target().deformed.render().vertices;
        for (DynamicVertex& vertex : vertices) {
            vertex.position *= 1.25f;
        }
        std::vector<std::uint32_t> moved;
        other.write(0, vertices, moved);
        bool isThere = true;
        SceneSections sections(
            *m_session, [&](const Target&) -> const DeformedMesh* { return isThere ? &other : nullptr; });
        sections.setCut(across({1.0f, 0.0f, 0.0f}, target().transform.position.x), 1.0f);
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(sections), kPatience);
        const SectionCurve& deformed = sections.section()->targets.at(0).deformed.at(0);
        for (const glm::vec3& point : deformed.points) {
            const float away = glm::distance(point, target().transform.position);
            QVERIFY(std::abs(away - 1.25f * kRadius) < 0.01f);
        }
        // It is as it was again.
        isThere = false;
        sections.note(target().id, moved);
        QTRY_VERIFY_WITH_TIMEOUT(isSettled(sections), kPatience);
        const TargetSection& again = sections.section()->targets.at(0);
        QVERIFY(isSame(again.original, again.deformed));
    }

    void followsHitsUndoAndThePlane() {
        cut(across({0.0f, 0.0f, 1.0f}, target().transform.position.z));
        for (int i = 0; i < 6; ++i) {
            QVERIFY(m_session->hits().add(hitAt(target(), {std::cos(1.1f * static_cast<float>(i)),
                                                           std::sin(1.1f * static_cast<float>(i)), 0.02f})));
            readBack(*m_session);
            QVERIFY(m_sections->isBusy());
        }
        settle();
        compareWithFresh(1.0f);
        QVERIFY(section().targets[0].depths.greatest.value() > 0.25f);
        m_session->undo();
        readBack(*m_session);
        settle();
        compareWithFresh(1.0f);
        for (int i = 0; i < 10; ++i) {
            m_sections->setCut(across({0.1f, 0.2f, 1.0f}, 0.1f * static_cast<float>(i)), 1.0f);
        }
        settle();
        QCOMPARE(section().cut.offset, 0.9f);
        compareWithFresh(1.0f);
        m_session->hits().clear();
        readBack(*m_session);
        settle();
        QCOMPARE(section().targets[0].depths.greatest.value(), 0.0f);
    }

    void hitsBeforeThePlaneCountToo() {
        QVERIFY(m_session->hits().add(hitAt(target(), {0.0f, 1.0f, 0.0f})));
        readBack(*m_session);
        cut(across({1.0f, 0.0f, 0.0f}, target().transform.position.x));
        compareWithFresh(1.0f);
        // The one hit goes straight in by what it does at most.
        QVERIFY(std::abs(section().targets[0].depths.greatest.value() - 0.3f) < 0.02f);
        const auto deepest = deepestOf(section(), {});
        QVERIFY(deepest);
        QVERIFY(deepest->place.y - target().transform.position.y > 2.1f);
    }

    void exaggerationIsForTheEyeOnly() {
        QVERIFY(m_session->hits().add(hitAt(target(), {0.0f, 1.0f, 0.0f})));
        readBack(*m_session);
        cut(across({1.0f, 0.0f, 0.0f}, target().transform.position.x));
        const float depth = section().targets[0].depths.greatest.value();
        m_sections->setCut(section().cut, 4.0f);
        settle();
        QCOMPARE(section().targets[0].depths.greatest.value(), depth);
        compareWithFresh(4.0f);
        const SectionDepths drawn = sectionDepths(section().lines->original, section().lines->deformed);
        QVERIFY(drawn.greatest.value() > 2.0f * depth);
        m_sections->setCut(section().cut, 1.0f);
        settle();
        compareWithFresh(1.0f);
    }

    void onlyVisibleTargetsWhereTheyAre() {
        ScenePlan plan;
        plan.targets.push_back(planPrimitive({PrimitiveKind::UvSphere, 48, 5.0f}));
        plan.targets.push_back(planPrimitive({PrimitiveKind::UvSphere, 48, 5.0f}));
        plan.targets[1].transform.position = {8.0f, 0.0f, 0.3f};
        plan.targets[1].transform.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3)));
        cut(across({0.0f, 0.0f, 1.0f}, 0.0f));
        m_session->loadScene(std::move(plan));
        settle();
        QCOMPARE(section().targets.size(), std::size_t{2});
        const glm::vec3 second = m_session->targets()[1]->transform.position;
        for (const glm::vec3& point : section().targets[1].original[0].points) {
            QVERIFY(std::abs(glm::distance(point, second) - kRadius) < 0.03f);
        }
        const TargetId first = m_session->targets()[0]->id;
        m_session->targets().setVisible(std::vector{first}, false);
        settle();
        QCOMPARE(section().targets.size(), std::size_t{1});
        QVERIFY(section().targets[0].target != first);
        m_session->targets().remove(std::vector{section().targets[0].target});
        settle();
        QVERIFY(section().targets.empty());
        QVERIFY(section().lines->original.empty());
    }

    void readingsAreOfThePlaceUnderTheCursor() {
        QVERIFY(m_session->hits().add(hitAt(target(), {0.0f, 1.0f, 0.0f})));
        readBack(*m_session);
        const glm::vec3 middle = target().transform.position;
        cut(across({1.0f, 0.0f, 0.0f}, middle.x));
        const glm::dvec2 centre = sectionView(section().cut.openSide())(middle);
        const auto top = readSection(section(), {}, centre + glm::dvec2(0.0, 2.0));
        QVERIFY(top && std::abs(top->depth.value() - 0.3) < 0.02);
        QVERIFY(std::abs(static_cast<double>(glm::distance(top->place, top->nearest.value())) -
                         top->depth.value()) < 0.02);
        const auto bottom = readSection(section(), {}, centre - glm::dvec2(0.3, 5.0));
        QVERIFY(bottom && bottom->depth.value() == 0.0 && bottom->place.y < middle.y - 2.4f);
        QVERIFY(placeText(sectionView({1, 0, 0}), {1.0f, 2.0f, -3.0f}) ==
                QStringLiteral("z -3.000, y 2.000"));
        QVERIFY(!readSection(section(), {TargetId{99}}, centre));
        QCOMPARE(sectionScope(section(), target().id).only, target().id);
        QCOMPARE(sectionScope(section(), TargetId{99}).only, TargetId{});
    }

    void csvAndTextSayAll() {
        QVERIFY(m_session->hits().add(hitAt(target(), {0.0f, 1.0f, 0.0f})));
        readBack(*m_session);
        cut(across({1.0f, 0.0f, 0.0f}, target().transform.position.x));
        const QList<QByteArray> lines = sectionCsv(section(), {}).trimmed().split('\n');
        const TargetSection& only = section().targets[0];
        QCOMPARE(static_cast<std::size_t>(lines.size()),
                 1 + only.original[0].points.size() + only.deformed[0].points.size());
        QCOMPARE(lines[0], QByteArray("state,target,line,closed,x_m,y_m,z_m,right_m,up_m,depth_m"));
        double greatest = 0.0;
        for (const QByteArray& line : lines.mid(1)) {
            const QList<QByteArray> cells = line.split(',');
            QCOMPARE(cells.size(), 10);
            QCOMPARE(cells[9].isEmpty(), cells[0] == "original");
            QCOMPARE(cells[7], cells[6]);
            QCOMPARE(cells[8], cells[5]);
            greatest = std::max(greatest, cells[9].toDouble());
        }
        QVERIFY(std::abs(greatest - static_cast<double>(only.depths.greatest.value())) < 1.0e-6);
        const QString text = sectionText(section(), {});
        QVERIFY(text.contains(QStringLiteral("Greatest depth\t0.")));
        QVERIFY(text.contains(QStringLiteral("Length, original\t15.7")));  // 2 pi 2.5, in chords
    }

    /// A plane that only the deformed surface reaches, as where it bulged: nothing is known of its depth.
    void withoutAnOriginalThereIsNoDepth() {
        cut(across({1.0f, 0.0f, 0.0f}, target().transform.position.x));
        SceneSection made = section();
        made.targets[0].original.clear();
        made.targets[0].depths = sectionDepths({}, made.targets[0].deformed);
        QVERIFY(!deepestOf(made, {}));
        const auto reading = readSection(made, {}, glm::dvec2(0.0));
        QVERIFY(reading && !reading->depth && !reading->nearest);
        for (const QByteArray& line : sectionCsv(made, {}).trimmed().split('\n').mid(1)) {
            QVERIFY(line.endsWith(','));
        }
        QVERIFY(sectionText(made, {}).contains(
            QStringLiteral("Greatest depth\tnone, the plane does not cut the original")));
    }

private:
    [[nodiscard]] const Target& target() const { return *m_session->targets().front(); }
    [[nodiscard]] const SceneSection& section() const { return *m_sections->section(); }
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(isSettled(*m_sections), kPatience); }
    void cut(const CuttingPlane& plane) {
        m_sections->setCut(plane, 1.0f);
        settle();
    }
    /// With what a picture works out for itself.
    void compareWithFresh(float exaggeration) {
        const auto fresh = sectionLines(*m_session, section().cut, exaggeration);
        QVERIFY(isSame(fresh->original, section().lines->original));
        QVERIFY(isSame(fresh->deformed, section().lines->deformed));
        QVERIFY(!fresh->deformed.empty());
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneSections> m_sections;
};

HITSCOPE_TEST(SceneSectionsTest, QCoreApplication)

}  // namespace hitscope::scene_sections_test

#include "scene_sections_test.moc"
