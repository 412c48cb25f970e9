// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/freed_memory.h"

#include <QTest>
#include <atomic>
#include <memory>

#include "mesh/primitives.h"
#include "session/session.h"
#include "session/task_list.h"
#include "session/welcome.h"
#include "support/test_program.h"

namespace hitscope::freed_memory_test {

namespace {

constexpr int kPatience = 4 * FreedMemory::kLater;  // milliseconds

ScenePlan sphere(int rings) {
    return {QStringLiteral("Sphere"), {planMesh(makeUvSphere(500, rings, 1.0f))}};
}

}  // namespace

class FreedMemoryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { m_times = 0; }

    void whenALargeMeshIsReplaced() {
        Session session;
        const FreedMemory memory(session, [this] { ++m_times; });
        session.loadScene(sphere(250));
        QVERIFY(session.targets().begin()->get()->deformed.original().vertexCount() > FreedMemory::kLarge);
        QTRY_COMPARE_WITH_TIMEOUT(m_times.load(), 1, kPatience);
        loadWelcomeScene(session);
        QTRY_COMPARE_WITH_TIMEOUT(m_times.load(), 3, kPatience);
    }

    void whenAllIsWorkedOutOfOneThatHasCome() {
        Session session;
        const FreedMemory memory(session, [this] { ++m_times; });
        auto task = std::make_unique<TaskProgress>(session.tasks(), QStringLiteral("Measuring the mesh"));
        session.loadScene(sphere(250));
        QTest::qWait(FreedMemory::kLater + FreedMemory::kSoon);
        QCOMPARE(m_times.load(), 0);
        task.reset();
        QTRY_COMPARE_WITH_TIMEOUT(m_times.load(), 1, kPatience);
        // Not after each task while it is there.
        task = std::make_unique<TaskProgress>(session.tasks(), QStringLiteral("Measuring the mesh"));
        task.reset();
        QTest::qWait(FreedMemory::kLater + FreedMemory::kSoon);
        QCOMPARE(m_times.load(), 1);
    }

    void whenAnotherLargeOneTakesItsPlace() {
        Session session;
        session.loadScene(sphere(250));
        const FreedMemory memory(session, [this] { ++m_times; });
        session.loadScene(sphere(260));
        QTRY_COMPARE_WITH_TIMEOUT(m_times.load(), 2, kPatience);
    }

    void whenItIsRemoved() {
        Session session;
        session.loadScene(sphere(250));
        const FreedMemory memory(session, [this] { ++m_times; });
        const TargetId id = session.targets().begin()->get()->id;
        session.targets().remove({&id, 1});
        QTRY_COMPARE_WITH_TIMEOUT(m_times.load(), 2, kPatience);
    }

    void notForSmallOnes() {
        Session session;
        const FreedMemory memory(session, [this] { ++m_times; });
        session.loadScene(sphere(20));
        loadWelcomeScene(session);
        QTest::qWait(FreedMemory::kLater + FreedMemory::kSoon);
        QCOMPARE(m_times.load(), 0);
    }

private:
    std::atomic<int> m_times = 0;
};

HITSCOPE_TEST(FreedMemoryTest, QCoreApplication)

}  // namespace hitscope::freed_memory_test

#include "freed_memory_test.moc"
