// SPDX-License-Identifier: GPL-3.0-or-later
// Who asks what a shot would strike, while others fly, changes none of their hits.
#include <QTest>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <vector>

#include "mesh/primitives.h"
#include "physics_support.h"
#include "session/sample_scenes.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::aiming_in_flight_test {

using namespace hitscope::test;

namespace {

/// What somebody does who aims, after step number `step`.
using Aim = std::function<void(Session& session, int step)>;

std::vector<Hit> hitsOfVolley(bool bouncesCount, const Aim& aim) {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    ProjectileSettings projectile;
    projectile.bouncesCount = bouncesCount;
    session.settings().setProjectile(projectile);
    Random random(77);
    int steps = 0;
    const auto step = [&] {
        session.simulation().stepOnce();
        aim(session, steps++);
    };
    for (int shot = 0; shot < 60; ++shot) {
        const auto target = static_cast<std::size_t>(random.between(0.0f, 15.99f));
        const glm::vec3 to = session.targets()[target]->transform.position + 1.5f * random.direction();
        glm::vec3 from = to + 6.0f * random.direction();
        from.y = std::abs(from.y) + 2.0f;
        session.simulation().shoot({from, glm::normalize(to - from)});
        for (int i = 0; i < 8; ++i) {
            step();
        }
    }
    for (int i = 0; i < 500; ++i) {
        step();
    }
    const std::span<const Hit> hits = session.hits().history().hits();
    return {hits.begin(), hits.end()};
}

}  // namespace

class AimingInFlightTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void hitsDoNotDependOnIt_data() {
        QTest::addColumn<bool>("bouncesCount");
        QTest::newRow("first hits") << false;
        QTest::newRow("bounces too") << true;
    }
    void hitsDoNotDependOnIt() {
        QFETCH(bool, bouncesCount);
        const std::vector<Hit> alone = hitsOfVolley(bouncesCount, [](Session&, int) {});
        QVERIFY(alone.size() > 30);
        for (int phase = 0; phase < 3; ++phase) {
            const std::vector<Hit> aimed = hitsOfVolley(bouncesCount, [phase](Session& session, int step) {
                if (step % 3 == phase) {
                    QVERIFY(session.simulation().updateColliders());
                }
            });
            QVERIFY(aimed == alone);
        }
        // Or in slices, as far as each time allows, with shots that are foreseen in between.
        const std::vector<Hit> aimed = hitsOfVolley(bouncesCount, [](Session& session, int step) {
            int looks = step % 4;
            static_cast<void>(session.simulation().updateColliders([&looks] { return --looks < 0; }));
            if (step % 5 == 0) {
                const glm::vec3 at =
                    session.targets()[static_cast<std::size_t>(step % 16)]->transform.position;
                const Ray ray{at + glm::vec3(0, 1, 9), glm::vec3(0, 0, -1)};
                static_cast<void>(session.simulation().predictedHit(ray, step % 2 == 0));
            }
        });
        QVERIFY(aimed == alone);
    }

    /// While something flies a stroke of hits still goes down into what it has dented, paused or not.
    void aFreshDentIsSeen() {
        Session session;
        loadMesh(session, makeHighPolySphere());
        const TargetId ball = session.targets().front()->id;
        session.simulation().shoot({{0, 50, 9}, {0, 0, 1}});
        session.simulation().stepOnce();
        QVERIFY(session.simulation().physics().isMoving());
        const Ray ray{{9, 0, 0}, {-1, 0, 0}};
        float depth = 3.0f;
        for (int i = 0; i < 5; ++i) {
            session.simulation().setPaused(i > 2);
            const std::optional<Hit> hit = session.simulation().predictedHit(ray, true);
            QVERIFY(hit && hit->target == ball && hit->point.x < depth - 0.05f);
            depth = hit->point.x;
            const auto met = session.simulation().physics().castRay(ray.origin, ray.direction, 20.0f);
            QVERIFY(met && std::abs(met->point.x - depth) < 1e-5f);
            QVERIFY(session.hits().add(*hit).ok());
        }
        // An instant shot strikes just there.
        const std::optional<Hit> next = session.simulation().predictedHit(ray, true);
        QVERIFY(next && session.simulation().hitscan(ray));
        QVERIFY(session.hits().history().hits().back().point == next->point);
        QVERIFY(session.hits().history().hits().back().triangle == next->triangle);
    }

    /// Hidden meanwhile and shown again, it has all its dents, asked for or not.
    void aTargetThatComesBackHasItsDents() {
        std::vector<std::vector<Hit>> all;
        for (const bool asks : {false, true}) {
            Session session;
            loadMesh(session, makeHighPolySphere());
            const TargetId ids[] = {session.targets().front()->id};
            ProjectileSettings projectile;
            projectile.bouncesCount = true;
            session.settings().setProjectile(projectile);
            for (int i = 0; i < 300; ++i) {
                if (i % 20 == 0 && i < 120) {
                    session.simulation().shoot({{4.0f, 0.1f * static_cast<float>(i % 7), 0}, {-1, 0, 0}});
                }
                session.simulation().stepOnce();
                if (asks) {
                    static_cast<void>(session.simulation().updateColliders());
                }
                if (i % 11 == 10) {
                    session.targets().setVisible(ids, false);
                    session.targets().setVisible(ids, true);
                }
            }
            const std::span<const Hit> hits = session.hits().history().hits();
            all.emplace_back(hits.begin(), hits.end());
        }
        QVERIFY(all[0].size() > 5);
        QVERIFY(all[0] == all[1]);
    }
};

HITSCOPE_TEST(AimingInFlightTest, QCoreApplication)

}  // namespace hitscope::aiming_in_flight_test

#include "aiming_in_flight_test.moc"
