// SPDX-License-Identifier: GPL-3.0-or-later
// Shots that are due are fired as time allows, and make the same hits; what became of them is counted.
#include <QSignalSpy>
#include <QTest>
#include <glm/geometric.hpp>

#include "mesh/primitives.h"
#include "session/paced_advance.h"
#include "session/session.h"
#include "session/shots/shot_script.h"
#include "session/task_list.h"
#include "support/test_program.h"

namespace hitscope::shot_slices_test {

namespace {

constexpr Ray kAxis{{0, 0, 12}, {0, 0, -1}};

/// 60 instant shots at once, while others fly.
void scheduleBoth(Session& session) {
    ShotScript flights;
    flights.shots = burst(kAxis, 40, 0.15f, 3, 0.004);
    schedule(session, flights);
    ShotScript instant;
    instant.isInstant = true;
    instant.shots = burst(kAxis, 60, 0.15f, 5);
    schedule(session, instant);
}

std::vector<Hit> hitsOf(const Session& session) {
    const std::span<const Hit> hits = session.hits().history().hits();
    return {hits.begin(), hits.end()};
}

/// A clock that says that each look at it takes so long, seconds.
PaceClock slowClock(double each) {
    return [each, now = 0.0]() mutable { return now += each; };
}

}  // namespace

class ShotSlicesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void slicesMakeTheSameHits_data() {
        QTest::addColumn<double>("each");
        QTest::newRow("a shot a frame") << 0.1;
        QTest::newRow("some shots a frame") << 0.003;
        QTest::newRow("all in a frame") << 0.0;
    }
    void slicesMakeTheSameHits() {
        QFETCH(double, each);
        Session whole;
        loadMesh(whole, makeHighPolySphere(2.5f));
        scheduleBoth(whole);
        for (int i = 0; i < 1500; ++i) {
            whole.simulation().stepOnce();
        }
        QVERIFY(whole.hits().history().size() > 40);
        Session sliced;
        loadMesh(sliced, makeHighPolySphere(2.5f));
        scheduleBoth(sliced);
        std::size_t most = 0;
        while (sliced.simulation().isMoving()) {
            const std::size_t waiting = sliced.simulation().shotsToCome();
            advanceWithin(sliced, 1.0 / 240.0, kMostPhysics, slowClock(each));
            most = std::max(most, waiting - sliced.simulation().shotsToCome());
        }
        QCOMPARE(most, each == 0.1 ? std::size_t{1} : most);
        QVERIFY(each == 0.0 ? most >= 60 : most <= 16);
        QVERIFY(hitsOf(sliced) == hitsOf(whole));
    }

    void progressAndCancel() {
        Session session;
        loadMesh(session, makeHighPolySphere(2.5f));
        ShotScript script;
        script.isInstant = true;
        script.shots = burst(kAxis, 100, 0.05f, 5);
        schedule(session, script);
        QVERIFY(session.tasks().current() == nullptr);
        // The dent of a shot is worked out in slices, too, before the next one strikes it.
        int frames = 0;
        for (; session.hits().history().size() < 30 && frames < 1000; ++frames) {
            const std::size_t before = session.hits().history().size();
            advanceWithin(session, 1.0 / 240.0, kMostPhysics, slowClock(1.0));
            QVERIFY(session.hits().history().size() <= before + 1);
        }
        QCOMPARE(session.hits().history().size(), std::size_t{30});
        QVERIFY2(frames >= 30, qPrintable(QString::number(frames)));
        const TaskList::Task* task = session.tasks().current();
        QVERIFY(task != nullptr && task->cancel);
        QVERIFY(task->fraction > 0.25 && task->fraction < 0.35);
        QCOMPARE(session.simulation().physics().clock().time(), 0.0);  // no step before all are fired
        QSignalSpy went(&session.simulation(), &Simulation::shotsWent);
        session.tasks().cancel(task->id);
        QVERIFY(session.tasks().current() == nullptr);
        QCOMPARE(session.simulation().shotsToCome(), std::size_t{0});
        QCOMPARE(session.hits().history().size(), std::size_t{30});
        const auto count = went.last().first().value<ShotCount>();
        QVERIFY(count.isOver());
        QCOMPARE(count.shots, std::size_t{30});
        QCOMPARE(count.hits, std::size_t{30});
    }

    void shotsAreCountedByWhatTheyStrike() {
        Session session;
        loadMesh(session, makeHighPolySphere(2.5f));
        QSignalSpy went(&session.simulation(), &Simulation::shotsWent);
        const auto last = [&] { return went.last().first().value<ShotCount>(); };
        session.simulation().shoot(kAxis);
        QCOMPARE(last().flying, std::size_t{1});
        QVERIFY(!last().isOver());
        while (!last().isOver()) {
            session.simulation().stepOnce();
        }
        QCOMPARE(last().hits, std::size_t{1});
        QCOMPARE(last().lastHit, session.targets().front()->id);
        const qsizetype told = went.size();
        while (session.simulation().isMoving()) {
            session.simulation().stepOnce();
        }
        QCOMPARE(went.size(), told);  // where it bounces to is no news
        session.simulation().shoot({{20, 3, 20}, {0, -1, 0}});
        while (last().landed == 0) {
            session.simulation().stepOnce();
        }
        QVERIFY(!last().isOver());
        while (!last().isOver()) {
            session.simulation().stepOnce();
        }
        QCOMPARE(last().landed, std::size_t{1});
        session.simulation().shoot({{20, 900, 20}, {0, 1, 0}});
        while (!last().isOver()) {
            session.simulation().stepOnce();
        }
        QCOMPARE(last().past, std::size_t{1});
        QVERIFY(!session.simulation().hitscan({{20, 3, 20}, {0, 1, 0}}));
        QCOMPARE(last().past, std::size_t{1});
        QVERIFY(!session.simulation().hitscan({{20, 3, 20}, {0, -1, 0}}));
        QCOMPARE(last().landed, std::size_t{1});
        // A burst of which some miss; those that are pushed out by later ones are counted as well.
        ShotScript script;
        script.projectile.mostAlive = 50;
        script.shots = burst(kAxis, 120, 0.6f, 9);
        const std::size_t before = session.hits().history().size();
        schedule(session, script);
        while (session.simulation().isMoving()) {
            session.simulation().stepOnce();
        }
        QVERIFY(last().isOver());
        QCOMPARE(last().shots, std::size_t{120});
        QCOMPARE(last().hits, session.hits().history().size() - before);
        QCOMPARE(last().hits + last().landed + last().past, std::size_t{120});
    }
};

HITSCOPE_TEST(ShotSlicesTest, QCoreApplication)

}  // namespace hitscope::shot_slices_test

#include "shot_slices_test.moc"
