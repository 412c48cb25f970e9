// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <QSignalSpy>
#include <QTest>

#include "mesh/primitives.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"

namespace hitscope::session_test {

class SessionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void paperRowsHoldThePapersMeshes_data() {
        QTest::addColumn<int>("row");
        for (int row = 0; row < static_cast<int>(paperRows().size()); ++row) {
            QTest::addRow("%d", row) << row;
        }
    }
    void paperRowsHoldThePapersMeshes() {
        QFETCH(int, row);
        const PaperRow& paper = paperRows()[static_cast<std::size_t>(row)];
        Session session;
        loadPaperRow(session, row);
        QCOMPARE(session.targets().size(), static_cast<std::size_t>(paper.targets()));
        std::map<std::size_t, int> counts;
        for (const std::unique_ptr<Target>& target : session.targets()) {
            ++counts[target->deformed.original().vertexCount()];
        }
        QCOMPARE(counts[386], paper.lowPolyCubes);
        QCOMPARE(counts[6146], paper.highPolyCubes);
        QCOMPARE(counts[382], paper.lowPolySpheres);
        QCOMPARE(counts[7938], paper.highPolySpheres);
    }

    void targetsStandOnTheFloorFifteenMetresApart() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        const std::span<const std::unique_ptr<Target>> targets = session.targets().all();
        QVERIFY(targets.size() > 1);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            QVERIFY(std::abs(targets[i]->worldBounds().min.y - session.targets().floorHeight()) < 1e-4f);
            for (std::size_t j = 0; j < i; ++j) {
                QVERIFY(glm::distance(targets[i]->transform.position, targets[j]->transform.position) >
                        14.99f);
            }
        }
    }

    void shotBecomesHitOnTheTargetItWasAimedAt() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        const Target& aimedAt = *session.targets()[6];
        const glm::vec3 eye = aimedAt.transform.position + glm::vec3(0, 1, 6);
        QSignalSpy appended(&session.hits(), &SessionHits::appended);
        session.simulation().shoot({eye, glm::normalize(aimedAt.transform.position - eye)});
        QVERIFY(session.simulation().isMoving());
        for (int i = 0; i < 60; ++i) {
            session.simulation().advance(1.0 / 60.0);
        }
        QCOMPARE(appended.count(), 1);
        const Hit& hit = session.hits().history().hits()[0];
        QCOMPARE(hit.target, aimedAt.id);
        QCOMPARE(session.targets().selected(), aimedAt.id);
        QVERIFY(std::abs(glm::length(hit.direction) - 1.0f) < 1e-5f);
        QVERIFY(hit.speed > 25.0f && hit.speed < 31.0f);
    }

    void projectilesDisappearAfterTheirLifetime() {
        Session session;
        loadTeapot(session);
        session.simulation().shoot({{0, 10, 0}, {0, 1, 0}});
        for (int i = 0; i < 60 * 6; ++i) {
            session.simulation().advance(1.0 / 60.0);
        }
        QVERIFY(!session.simulation().isMoving());
    }

    void demoShotsAreRepeatableAndLand() {
        Session first;
        loadTeapot(first);
        shootAll(first, demoShots(first, 50, 7));
        Session second;
        loadTeapot(second);
        shootAll(second, demoShots(second, 50, 7));
        QVERIFY2(first.hits().history().size() >= 45,
                 qPrintable(QString::number(first.hits().history().size())));
        QCOMPARE(first.hits().history().size(), second.hits().history().size());
        for (std::size_t i = 0; i < first.hits().history().size(); ++i) {
            QCOMPARE(first.hits().history().hits()[i].point, second.hits().history().hits()[i].point);
            QCOMPARE(first.hits().history().hits()[i].direction, second.hits().history().hits()[i].direction);
        }
    }

    void refusesBadHits() {
        Session session;
        loadTeapot(session);
        Hit hit;
        hit.target = session.targets()[0]->id;
        hit.direction = glm::vec3(0.0f);
        QVERIFY(!session.hits().add(hit));
        hit.direction = {1, 0, 0};
        hit.point.x = std::nanf("");
        QVERIFY(!session.hits().add(hit));
        hit.point.x = 0.0f;
        hit.target = TargetId{999};
        QVERIFY(!session.hits().add(hit));
        QCOMPARE(session.hits().history().size(), std::size_t{0});
    }

    void constantsApplyToPastHitsOnlyWhenAsked() {
        Session session;
        loadTeapot(session);
        Hit hit;
        hit.target = session.targets()[0]->id;
        hit.direction = {1, 0, 0};
        QVERIFY(session.hits().add(hit));
        DeformationConstants constants;
        constants.power = 0.2f;
        QVERIFY(session.settings().setConstants(constants));
        QCOMPARE(session.hits().history().hits()[0].constants.power, 0.05f);
        session.hits().giveConstantsToAll();
        QCOMPARE(session.hits().history().hits()[0].constants.power,
                 session.settings().constantsOn(*session.targets().front()).power);
        session.undo();
        QCOMPARE(session.hits().history().hits()[0].constants.power, 0.05f);
        constants.power = -1.0f;
        QVERIFY(!session.settings().setConstants(constants));
        QCOMPARE(session.hits().history().hits()[0].constants.power, 0.05f);
    }

    void newSceneStartsAnEmptyHistory() {
        Session session;
        loadTeapot(session);
        Hit hit;
        hit.target = session.targets()[0]->id;
        QVERIFY(session.hits().add(hit));
        loadMesh(session, makeLowPolyCube());
        QCOMPARE(session.hits().history().size(), std::size_t{0});
        QCOMPARE(session.targets().size(), std::size_t{1});
        session.undo();
        QCOMPARE(session.hits().history().size(), std::size_t{1});
    }

    void timeBeginsWithTheScene() {
        Session session;
        loadTeapot(session);
        const auto time = [&session] { return session.simulation().physics().clock().time(); };
        session.simulation().setTime(700.0);
        Hit hit;
        hit.target = session.targets()[0]->id;
        hit.time = 650.0;
        QVERIFY(session.hits().add(hit));
        loadTeapot(session);
        QCOMPARE(time(), 0.0);
        session.simulation().advance(0.1);
        session.undo();
        QCOMPARE(time(), 650.0);  // the next hit is later than those there are
        session.redo();
        session.simulation().setTime(800.0);
        session.undo();
        QCOMPARE(time(), 800.0);
    }
};

HITSCOPE_TEST(SessionTest, QCoreApplication)

}  // namespace hitscope::session_test

#include "session_test.moc"
