// SPDX-License-Identifier: GPL-3.0-or-later
// Targets added, changed and removed one by one, and undone.
#include <QSignalSpy>
#include <QTest>
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::session_targets_test {

namespace {

TargetPlan cubePlan(const QString& name = QStringLiteral("Cube"), float halfExtent = 1.0f) {
    TargetPlan plan = planMesh(makeCube(2, halfExtent));
    plan.name = name;
    return plan;
}

void hit(Session& session, TargetId target, float x) {
    Hit made;
    made.target = target;
    made.point.x = x;
    QVERIFY(session.hits().add(made).ok());
}

QStringList names(const Session& session) {
    QStringList list;
    for (const auto& target : session.targets()) {
        list << target->name;
    }
    return list;
}

std::vector<Hit> hits(const Session& session) {
    return {session.hits().history().hits().begin(), session.hits().history().hits().end()};
}

std::vector<RigidTransform> transforms(const Session& session) {
    std::vector<RigidTransform> list;
    for (const auto& target : session.targets()) {
        list.push_back(target->transform);
    }
    return list;
}

bool sameTransforms(const std::vector<RigidTransform>& a, const std::vector<RigidTransform>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](auto& one, auto& other) {
        return one.position == other.position && one.rotation == other.rotation;
    });
}

/// Of a file, for the target of that id.
TargetState otherMesh(TargetId target) {
    TargetPlan plan = cubePlan(QStringLiteral("Not this"), 2.0f);
    plan.sourcePath = QStringLiteral("/other.obj");
    plan.source = MeshFile{plan.sourcePath};
    plan.textures = {{"a.png", QStringLiteral("/a.png")}};
    return stateOf(std::move(plan), target);
}

/// Where a line straight down at x, z meets something, and what.
TargetId below(const Session& session, float x, float z = 0.0f) {
    const auto met = session.simulation().physics().castRay({x, 100.0f, z}, {0.0f, -1.0f, 0.0f}, 1000.0f);
    return met ? met->target : TargetId{};
}

}  // namespace

class SessionTargetsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        m_session->loadScene({QStringLiteral("Two"),
                              {cubePlan(QStringLiteral("Left")), cubePlan(QStringLiteral("Right"))},
                              -1.0f});
        QVERIFY(m_session->targets().setTransform(id(1), {{10.0f, 0.0f, 0.0f}, glm::quat(1, 0, 0, 0)}).ok());
    }

    void addedStandClearUnderNamesOfTheirOwn() {
        QSignalSpy added(&m_session->targets(), &SessionTargets::added);
        m_session->targets().add({cubePlan(QStringLiteral("Left")), cubePlan(QStringLiteral("Left"), 3.0f)});
        QCOMPARE(names(*m_session), (QStringList{QStringLiteral("Left"), QStringLiteral("Right"),
                                                 QStringLiteral("Left 2"), QStringLiteral("Left 3")}));
        QCOMPARE(added.count(), 2);
        QCOMPARE(m_session->targets().selected(), id(3));
        for (std::size_t i = 0; i < 4; ++i) {
            const Bounds a = m_session->targets()[i]->worldBounds();
            QVERIFY(a.min.y >= m_session->targets().floorHeight() - 1.0e-5f);
            for (std::size_t j = 0; j < i; ++j) {
                const Bounds b = m_session->targets()[j]->worldBounds();
                QVERIFY(a.min.x >= b.max.x || b.min.x >= a.max.x);
            }
        }
        for (const auto& target : m_session->targets()) {
            QCOMPARE(below(*m_session, target->transform.position.x), target->id);
        }
        m_session->undo();
        QCOMPARE(names(*m_session), (QStringList{QStringLiteral("Left"), QStringLiteral("Right")}));
        m_session->redo();
        QCOMPARE(m_session->targets().size(), std::size_t{4});
    }

    void removingTakesTheHitsAlongAndUndoBringsBothBack() {
        hit(*m_session, id(0), 0.1f);
        hit(*m_session, id(1), 0.2f);
        hit(*m_session, id(0), 0.3f);
        const std::vector<Hit> before = hits(*m_session);
        const TargetId left = id(0);
        QSignalSpy removed(&m_session->targets(), &SessionTargets::removed);
        QSignalSpy rearranged(&m_session->hits(), &SessionHits::rearranged);
        m_session->targets().remove(std::array{left});
        QCOMPARE(names(*m_session), QStringList{QStringLiteral("Right")});
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        QCOMPARE(removed.count(), 1);
        QCOMPARE(rearranged.count(), 1);
        QCOMPARE(below(*m_session, 0.0f), TargetId{});
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::RemoveTarget, 1}));

        m_session->undo();
        QCOMPARE(id(0), left);
        QVERIFY(hits(*m_session) == before);
        QCOMPARE(below(*m_session, 0.0f), left);
        m_session->redo();
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        QCOMPARE(m_session->targets().size(), std::size_t{1});
    }

    void removingAllAtOnceIsOneStep() {
        hit(*m_session, id(0), 0.1f);
        m_session->targets().remove(std::array{id(1), id(0), id(1), TargetId{99}});
        QVERIFY(m_session->targets().empty());
        QVERIFY(!m_session->targets().selected());
        m_session->undo();
        QCOMPARE(names(*m_session), (QStringList{QStringLiteral("Left"), QStringLiteral("Right")}));
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
    }

    void aHitIsNeverOnATargetThatIsNotThere() {
        hit(*m_session, id(0), 0.1f);
        bool ok = true;
        const auto check = [&] {
            for (const Hit& made : m_session->hits().history().hits()) {
                ok = ok && m_session->targets().find(made.target) != nullptr;
            }
        };
        connect(&m_session->hits(), &SessionHits::reset, this, check);
        connect(&m_session->targets(), &SessionTargets::removed, this, check);
        m_session->targets().duplicate(std::array{id(0)});
        m_session->targets().remove(std::array{id(0)});
        for (int i = 0; i < 2; ++i) {
            m_session->undo();
            m_session->undo();
            m_session->redo();
            m_session->redo();
        }
        QVERIFY(ok);
    }

    void undoneDuplicatesLeaveTheirOriginalsSelected() {
        auto& targets = m_session->targets();
        const std::vector<TargetId> both{id(0), id(1)};
        targets.select(id(0), both);
        targets.duplicate(both);
        const std::vector<TargetId> copies{id(2), id(3)};
        targets.select({});
        m_session->undo();
        QVERIFY(targets.selected() == both.front() && targets.allSelected() == both);
        m_session->redo();
        QVERIFY(targets.selected() == copies.back() && targets.allSelected() == copies);
    }

    void duplicateHasTheHits() {
        hit(*m_session, id(0), 0.1f);
        hit(*m_session, id(1), 0.2f);
        hit(*m_session, id(0), 0.3f);
        m_session->targets().duplicate(std::array{id(0)});
        QCOMPARE(names(*m_session).last(), QStringLiteral("Left 2"));
        const TargetId copy = id(2);
        QCOMPARE(m_session->targets().selected(), copy);
        const std::vector<Hit> copied = m_session->hits().history().hitsOn(copy);
        QCOMPARE(copied.size(), std::size_t{2});
        QCOMPARE(copied[1].point.x, 0.3f);
        QVERIFY(&m_session->targets()[2]->deformed.original() ==
                &m_session->targets()[0]->deformed.original());
        m_session->undo();
        QCOMPARE(m_session->targets().size(), std::size_t{2});
        QCOMPARE(m_session->hits().history().size(), std::size_t{3});
        m_session->redo();
        QCOMPARE(id(2), copy);
        QCOMPARE(m_session->hits().history().hitsOn(copy).size(), std::size_t{2});
    }

    void moveAndTurnCarryTheColliderAlong() {
        const TargetId left = id(0);
        QVERIFY(m_session->targets().setTransform(left, {{-7.0f, 2.0f, 0.0f}, glm::quat(1, 0, 0, 0)}).ok());
        QCOMPARE(below(*m_session, -7.0f), left);
        QCOMPARE(below(*m_session, 0.0f), TargetId{});
        // Turned by 45 degrees about y, a corner reaches sqrt(2) along x; the quaternion need not be unit.
        QVERIFY(m_session->targets()
                    .setTransform(
                        left, {{-7.0f, 2.0f, 0.0f}, glm::quat(2.0f * 0.9238795f, 0, 2.0f * 0.3826834f, 0)})
                    .ok());
        QVERIFY(std::abs(glm::length(m_session->targets()[0]->transform.rotation) - 1.0f) < 1.0e-6f);
        QCOMPARE(below(*m_session, -5.7f), left);
        QCOMPARE(m_session->steps().toUndo()->kind, SessionUndo::Kind::RotateTarget);
        m_session->undo();
        QCOMPARE(below(*m_session, -5.7f), TargetId{});
        m_session->undo();
        QCOMPARE(below(*m_session, 0.0f), left);
    }

    void transformsOutOfReasonAreRefused() {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const std::vector<RigidTransform> before = transforms(*m_session);
        QVERIFY(!m_session->targets().setTransform(id(0), {{nan, 0, 0}, glm::quat(1, 0, 0, 0)}).ok());
        QVERIFY(!m_session->targets().setTransform(id(0), {{0, 0, 0}, glm::quat(0, 0, 0, 0)}).ok());
        QVERIFY(!m_session->targets().setTransform(id(0), {{0, 0, 0}, glm::quat(1, nan, 0, 0)}).ok());
        QCOMPARE(transforms(*m_session)[0].position, before[0].position);
        QCOMPARE(m_session->steps().toUndo()->kind, SessionUndo::Kind::MoveTarget);  // the one of init()
    }

    void hiddenAreNotHit() {
        const TargetId left = id(0);
        hit(*m_session, left, 0.1f);
        QSignalSpy changed(&m_session->targets(), &SessionTargets::changed);
        m_session->targets().setVisible(std::array{left}, false);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(below(*m_session, 0.0f), TargetId{});
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        QCOMPARE(m_session->targets().bounds().min.x, 9.0f);
        // Moved while hidden, it is hit where it then is shown.
        QVERIFY(m_session->targets().setTransform(left, {{-7.0f, 0.0f, 0.0f}, glm::quat(1, 0, 0, 0)}).ok());
        QCOMPARE(below(*m_session, -7.0f), TargetId{});
        m_session->targets().setVisible(std::array{left}, true);
        QCOMPARE(below(*m_session, -7.0f), left);
        m_session->targets().setVisible(std::array{left}, true);  // is so already: no step
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::ShowTarget, 1}));
        m_session->undo();
        m_session->undo();
        m_session->undo();
        QCOMPARE(below(*m_session, 0.0f), left);
    }

    void renamesAreTidied() {
        QVERIFY(m_session->targets().rename(id(0), QStringLiteral("  the  best ")).ok());
        QCOMPARE(names(*m_session).first(), QStringLiteral("the best"));
        const Status refused = m_session->targets().rename(id(0), QStringLiteral("  "));
        QVERIFY(!refused.ok());
        m_session->undo();
        QCOMPARE(names(*m_session).first(), QStringLiteral("Left"));
    }

    void resetTakesTheHitsOfOneTarget() {
        hit(*m_session, id(0), 0.1f);
        hit(*m_session, id(1), 0.2f);
        m_session->targets().reset(std::array{id(0)});
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::ResetTarget, 1}));
        m_session->targets().reset(std::array{id(0)});  // has none: no step
        m_session->undo();
        QCOMPARE(m_session->hits().history().size(), std::size_t{2});
    }

    void anyOrderOfStepsComesBackBitForBit() {
        struct State {
            QStringList names;
            std::vector<RigidTransform> transforms;
            std::vector<Hit> hits;
            bool operator==(const State& other) const {
                bool same = names == other.names && hits == other.hits;
                for (std::size_t i = 0; same && i < transforms.size(); ++i) {
                    same = transforms[i].position == other.transforms[i].position &&
                           transforms[i].rotation == other.transforms[i].rotation;
                }
                return same;
            }
        };
        const auto now = [&] { return State{names(*m_session), transforms(*m_session), hits(*m_session)}; };
        std::vector<State> states{now()};
        const std::vector<std::function<void()>> acts = {
            [&] { hit(*m_session, id(0), 0.1f); },
            [&] {
                m_session->targets().add({cubePlan(), cubePlan()});
            },
            [&] { hit(*m_session, id(2), 0.2f); },
            [&] {
                m_session->targets().duplicate(std::array{id(2), id(0)});
            },
            [&] { QVERIFY(m_session->targets().rename(id(4), QStringLiteral("Copy")).ok()); },
            [&] {
                m_session->targets().remove(std::array{id(0), id(2)});
            },
            [&] { hit(*m_session, id(2), 0.4f); },
            [&] {
                QVERIFY(m_session->targets().setTransform(id(1), {{1, 2, 3}, glm::quat(0, 1, 0, 0)}).ok());
            },
            [&] { m_session->targets().reset(std::array{id(2)}); },
            [&] {
                m_session->targets().setVisible(std::array{id(0), id(1)}, false);
            },
            [&] { m_session->hits().clear(); },
            [&] {
                m_session->targets().remove(std::array{id(0), id(1), id(2)});
            }};
        for (const auto& act : acts) {
            act();
            states.push_back(now());
        }
        for (std::size_t i = states.size() - 1; i-- > 0;) {
            m_session->undo();
            QVERIFY2(now() == states[i], qPrintable(QStringLiteral("back to %1").arg(i)));
        }
        for (std::size_t i = 1; i < states.size(); ++i) {
            m_session->redo();
            QVERIFY2(now() == states[i], qPrintable(QStringLiteral("on to %1").arg(i)));
        }
    }

    void aNewSceneIsAStep() {
        const std::size_t before = m_session->targets().size();
        m_session->targets().add({cubePlan()});
        loadPaperRow(*m_session, 0);
        QVERIFY(!m_session->steps().canRedo());
        m_session->undo();
        QCOMPARE(m_session->targets().size(), before + 1);
        m_session->undo();
        QCOMPARE(m_session->targets().size(), before);
    }

    void otherMeshesKeepAllElse() {
        m_session->targets().add({cubePlan(QStringLiteral("Third"))});
        const TargetId left = id(0);
        const TargetId right = id(1);
        const TargetId third = id(2);
        hit(*m_session, right, 1.0f);
        hit(*m_session, left, 2.0f);
        hit(*m_session, third, 3.0f);
        hit(*m_session, right, 4.0f);
        QVERIFY(m_session->targets().setPhysics(third, {true, 5.0f, 0.5f, 0.5f}).ok());
        m_session->targets().setVisible(std::array{right}, false);
        m_session->targets().select(right);
        const std::vector<RigidTransform> where = transforms(*m_session);
        const std::vector<Hit> before = hits(*m_session);
        const std::vector<TargetState> meshes = {otherMesh(third), otherMesh(right),
                                                 otherMesh(TargetId{999})};
        const std::size_t steps = m_session->steps().size();
        const auto ids = m_session->targets().replaceMeshes(meshes, [](const Hit& hit) {
            Hit other = hit;
            other.point.y = 7.0f;
            return other;
        });
        const auto check = [&] {
            QCOMPARE(names(*m_session),
                     (QStringList{QStringLiteral("Left"), QStringLiteral("Right"), QStringLiteral("Third")}));
            QVERIFY(sameTransforms(transforms(*m_session), where));
            QVERIFY(id(0) == left && id(1) == ids.at(right) && id(2) == ids.at(third));
            const Target& replaced = *m_session->targets()[1];
            QCOMPARE(replaced.extent(), 4.0f);
            QVERIFY(!replaced.visible && m_session->targets()[2]->physics.isDynamic);
            QVERIFY(replaced.source == meshes[1].source && replaced.textures == meshes[1].textures);
            QCOMPARE(replaced.sourcePath, QStringLiteral("/other.obj"));
            QCOMPARE(m_session->targets().front()->extent(), 2.0f);
            std::vector<Hit> expected = before;
            for (Hit& one : expected) {
                one.point.y = one.target == left ? 0.0f : 7.0f;
                one.target = one.target == left ? left : ids.at(one.target);
            }
            QVERIFY(hits(*m_session) == expected);
        };
        QCOMPARE(ids.size(), std::size_t{2});
        QVERIFY(ids.at(right) != right && ids.at(third) != ids.at(right));
        check();
        QCOMPARE(m_session->targets().selected(), ids.at(right));
        QVERIFY(below(*m_session, where[2].position.x + 1.9f) == ids.at(third));
        QCOMPARE(m_session->steps().size(), steps + 1);
        m_session->undo();
        QVERIFY(id(0) == left && id(1) == right && id(2) == third);
        QVERIFY(hits(*m_session) == before && sameTransforms(transforms(*m_session), where));
        QCOMPARE(m_session->targets()[1]->extent(), 2.0f);
        m_session->redo();
        check();
    }

private:
    [[nodiscard]] TargetId id(std::size_t index) const { return m_session->targets()[index]->id; }

    std::unique_ptr<Session> m_session;
};

HITSCOPE_TEST(SessionTargetsTest, QCoreApplication)

}  // namespace hitscope::session_targets_test

#include "session_targets_test.moc"
