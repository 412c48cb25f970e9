// SPDX-License-Identifier: GPL-3.0-or-later
// Shots that are taken back while they fly.
#include <QSignalSpy>
#include <QTest>
#include <glm/gtc/quaternion.hpp>

#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::recalled_shots_test {

class RecalledShotsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        m_session->loadScene({QStringLiteral("Cube"), {planMesh(makeCube(8, 1.0f))}, {}});
        m_slow = m_session->settings().projectile();
        m_slow.speed = 10.0f;
        m_slow.radius = 0.1f;
        m_slow.gravity = 0.0f;
        m_slow.lifetime = 30.0f;
    }

    void whatFliesHitsNothing() {
        m_session->simulation().hitscan({{0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, -1.0f}});
        fire({{0.0f, 0.5f, 9.0f}, {0.0f, 0.0f, -1.0f}});
        m_session->simulation().advance(0.2);
        QVERIFY(m_session->simulation().hasShotsInAir());
        QVERIFY(m_session->simulation().recallShots());
        QVERIFY(!m_session->simulation().hasShotsInAir());
        QCOMPARE(m_session->simulation().physics().projectileCount(), std::size_t{0});
        m_session->simulation().advance(2.0);
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        QVERIFY(!m_session->simulation().recallShots());
        QVERIFY(!m_session->simulation().isMoving());
    }

    void whatHasHitStays() {
        QSignalSpy went(&m_session->simulation(), &Simulation::shotsWent);
        fire({{0.0f, 0.0f, 3.0f}, {0.0f, 0.0f, -1.0f}});
        for (int step = 0; step < 200 && m_session->hits().history().size() == 0; ++step) {
            m_session->simulation().advance(0.02);
        }
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        fire({{0.0f, 0.5f, 9.0f}, {0.0f, 0.0f, -1.0f}});
        const std::size_t flying = m_session->simulation().physics().projectileCount();
        QVERIFY(m_session->simulation().recallShots());
        QCOMPARE(m_session->simulation().physics().projectileCount(), flying - 1);
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        for (const QList<QVariant>& said : went) {
            QVERIFY(said[0].value<ShotCount>().past == 0);  // what was taken back has not missed
        }
    }

    void whatIsStillToComeGoesToo() {
        std::vector<ScheduledShot> shots;
        for (int shot = 0; shot < 5; ++shot) {
            shots.push_back({0.5 * shot, {{0.0f, 0.5f, 9.0f}, {0.0f, 0.0f, -1.0f}}, m_slow, false});
        }
        m_session->simulation().schedule(shots);
        m_session->simulation().advance(0.6);
        QVERIFY(m_session->simulation().recallShots());
        QCOMPARE(m_session->simulation().shotsToCome(), std::size_t{0});
        m_session->simulation().advance(4.0);
        QCOMPARE(m_session->hits().history().size(), std::size_t{0});
    }

private:
    void fire(const Ray& ray) { m_session->simulation().fire({0.0, ray, m_slow, false}); }

    std::unique_ptr<Session> m_session;
    ProjectileSettings m_slow;
};

HITSCOPE_TEST(RecalledShotsTest, QCoreApplication)

}  // namespace hitscope::recalled_shots_test

#include "recalled_shots_test.moc"
