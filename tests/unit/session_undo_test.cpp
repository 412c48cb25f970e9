// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_undo.h"
#include "support/test_program.h"

#include <QTest>

namespace hitscope::session_undo_test {

namespace {

using Rows = std::vector<std::size_t>;

Hit hitAt(float x) {
    Hit hit;
    hit.target = TargetId{1};
    hit.point = {x, 0.0f, 0.0f};
    return hit;
}

std::vector<float> places(const HitHistory& history) {
    std::vector<float> xs;
    for (const Hit& hit : history.hits()) {
        xs.push_back(hit.point.x);
    }
    return xs;
}

/// As the session does it.
DeformationConstants make(HitHistory& history, const SessionUndo::Change& change) {
    for (const HistoryEdit& edit : change.edits) {
        history.redo(edit);
    }
    return change.settings ? change.settings->after.constants.constants : DeformationConstants{};
}

std::shared_ptr<const ValueEdit<SettingsState>> settingsEdit(const SettingsState& before,
                                                             const SettingsState& after) {
    return std::make_shared<const ValueEdit<SettingsState>>(ValueEdit<SettingsState>{before, after});
}

TargetState targetAt(float x, std::uint32_t id = 1) {
    TargetState state;
    state.id = TargetId{id};
    state.transform.position.x = x;
    return state;
}

SessionUndo::Change movedTarget(float from, float to, SessionUndo::Merge merge, std::uint32_t id = 1) {
    return {{SessionUndo::Kind::MoveTarget, 1}, merge, {}, {{0, targetAt(from, id), targetAt(to, id)}}};
}

}  // namespace

class SessionUndoTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void undoesAndRedoesEveryKindOfChangeInOrder() {
        HitHistory history;
        SessionUndo undo;
        const auto record = [&](std::vector<HistoryEdit> edits) { undo.record({.edits = std::move(edits)}); };
        record({history.append(hitAt(1))});
        record({history.append(hitAt(2))});
        record({history.append(hitAt(3))});
        record(history.remove(Rows{1}));
        record({history.append(hitAt(4))});
        record(history.move(Rows{2}, 0));
        record({history.clear()});

        const std::vector<std::vector<float>> states = {{},     {1},       {1, 2},    {1, 2, 3},
                                                        {1, 3}, {1, 3, 4}, {4, 1, 3}, {}};
        for (std::size_t i = states.size() - 1; i-- > 0;) {
            QVERIFY(undo.canUndo());
            make(history, undo.undo(history.hits()));
            QCOMPARE(places(history), states[i]);
        }
        QVERIFY(!undo.canUndo());
        for (std::size_t i = 1; i < states.size(); ++i) {
            QVERIFY(undo.canRedo());
            make(history, undo.redo());
            QCOMPARE(places(history), states[i]);
        }
        QVERIFY(!undo.canRedo());
    }

    void newChangeEndsRedo() {
        HitHistory history;
        SessionUndo undo;
        undo.record({.edits = {history.append(hitAt(1))}});
        make(history, undo.undo(history.hits()));
        QVERIFY(undo.canRedo());
        undo.record({.edits = {history.append(hitAt(2))}});
        QVERIFY(!undo.canRedo());
    }

    /// The history has them; a hundred thousand steps are not to cost as much again.
    void stepsThatMadeHitsKeepNoneUntilUndone() {
        HitHistory history;
        SessionUndo undo;
        undo.record({{SessionUndo::Kind::Hit, 1}, SessionUndo::Merge::Never, {history.append(hitAt(1))}});
        undo.record({{SessionUndo::Kind::Hit, 2},
                     SessionUndo::Merge::Never,
                     {history.append(std::vector<Hit>{hitAt(2), hitAt(3)})}});
        Hit edited = hitAt(2);
        edited.enabled = false;
        undo.record({{SessionUndo::Kind::Disable, 1},
                     SessionUndo::Merge::Never,
                     {history.splice(1, 1, {&edited, 1})}});
        make(history, undo.undo(history.hits()));
        const std::vector<Hit> before(history.hits().begin(), history.hits().end());
        const std::size_t bytes = undo.bytes();
        make(history, undo.undo(history.hits()));
        QCOMPARE(places(history), (std::vector<float>{1}));
        QCOMPARE(undo.bytes(), bytes);
        QCOMPARE(undo.toRedo()->count, std::size_t{2});
        make(history, undo.undo(history.hits()));
        make(history, undo.redo());
        make(history, undo.redo());
        QVERIFY(std::equal(before.begin(), before.end(), history.hits().begin(), history.hits().end()));
        make(history, undo.redo());
        QVERIFY(!history.hits()[1].enabled);
    }

    void whatChangesNothingIsNoStep() {
        HitHistory history;
        SessionUndo undo;
        undo.record({.edits = {history.clear()}});
        QVERIFY(!undo.canUndo());
    }

    void draggingConstantsIsOneStep() {
        HitHistory history;
        SessionUndo undo;
        const ConstantsSetting before;
        ConstantsSetting constants = before;
        undo.record({.edits = {history.append(hitAt(1))}});
        undo.record({.edits = {history.append(hitAt(2))}});
        for (const float power : {0.06f, 0.07f, 0.08f}) {
            ConstantsSetting next = constants;
            next.constants.power = power;
            std::vector<Hit> hits(history.hits().begin(), history.hits().end());
            for (Hit& hit : hits) {
                hit.constants = next.constants;
            }
            undo.record({{SessionUndo::Kind::Constants, 2},
                         SessionUndo::Merge::WithSameKind,
                         history.replace(Rows{0, 1}, hits),
                         {},
                         settingsEdit({.constants = constants}, {.constants = next})});
            constants = next;
        }
        QCOMPARE(make(history, undo.undo(history.hits())).power, before.constants.power);
        for (const Hit& hit : history.hits()) {
            QCOMPARE(hit.constants.power, before.constants.power);
        }
        QCOMPARE(make(history, undo.redo()).power, 0.08f);
        for (const Hit& hit : history.hits()) {
            QCOMPARE(hit.constants.power, 0.08f);
        }
    }

    void aFinishedStepTakesNothingMore() {
        SessionUndo undo;
        const auto dim = [&undo](float before, float after, SessionUndo::Merge merge) {
            SettingsState was;
            SettingsState is;
            was.lights.spot.terms.diffuse = before;
            is.lights.spot.terms.diffuse = after;
            undo.record(
                {.name = {SessionUndo::Kind::Lights, 1}, .merge = merge, .settings = settingsEdit(was, is)});
        };
        UndoGesture gesture;
        dim(0.8f, 0.7f, gesture.change(0));
        dim(0.7f, 0.6f, gesture.change(1));
        dim(0.6f, 0.5f, gesture.change(1));
        undo.finishStep();
        dim(0.5f, 0.4f, SessionUndo::Merge::WithSameKind);
        for (const float before : {0.5f, 0.7f, 0.8f}) {
            QCOMPARE(undo.undo({}).settings->after.lights.spot.terms.diffuse, before);
        }
        QVERIFY(!undo.canUndo());
        QCOMPARE(undo.redo().settings->after.lights.spot.terms.diffuse, 0.7f);
    }

    void thereAndBackIsNoStep() {
        HitHistory history;
        SessionUndo undo;
        undo.record(
            {.edits = {history.append(hitAt(1)), history.append(hitAt(2)), history.append(hitAt(3))}});
        const auto widen = [&](float distance) {
            std::vector<HistoryEdit> edits;
            for (const std::size_t index : {std::size_t{0}, std::size_t{2}}) {
                Hit hit = history.hits()[index];
                hit.constants.maxDistance = distance;
                edits.push_back(history.splice(index, 1, {&hit, 1}));
            }
            undo.record({{SessionUndo::Kind::EditHit, 2}, SessionUndo::Merge::WithSameKind, edits});
        };
        const float before = history.hits()[0].constants.maxDistance;
        widen(0.7f);
        widen(0.8f);
        QCOMPARE(undo.size(), std::size_t{2});
        widen(before);
        QVERIFY(undo.toUndo()->kind == SessionUndo::Kind::Hit);
    }

    /// A drag that is taken back leaves everything as it was, and so what can be made again.
    void thereAndBackKeepsWhatCanBeMadeAgain() {
        using Merge = SessionUndo::Merge;
        SessionUndo undo;
        undo.record(movedTarget(0, 1, Merge::Never));
        undo.record(movedTarget(1, 2, Merge::Never));
        const std::uint64_t state = undo.state();
        (void)undo.undo({});
        const std::size_t bytes = undo.bytes();
        undo.finishStep();
        undo.record(movedTarget(1, 5, Merge::WithSameKind));
        QVERIFY(!undo.canRedo());
        undo.record(movedTarget(5, 1, Merge::WithSameKind));
        QVERIFY(undo.canRedo());
        QCOMPARE(undo.bytes(), bytes);
        QCOMPARE(undo.redo().targets[0].after->transform.position.x, 2.0f);
        QCOMPARE(undo.state(), state);
        // One that ends somewhere else does not.
        (void)undo.undo({});
        undo.record(movedTarget(1, 5, Merge::WithSameKind));
        undo.finishStep();
        undo.record(movedTarget(5, 1, Merge::WithSameKind));
        QVERIFY(!undo.canRedo());
        QCOMPARE(undo.size(), std::size_t{3});
    }

    /// It falls while its friction is set.
    void physicsPutsNoTargetElsewhere() {
        SessionUndo undo;
        const auto setFriction = [&undo](float height, float before, float after) {
            TargetState from = targetAt(0.0f);
            from.transform.position.y = height;
            from.physics.friction = before;
            TargetState to = from;
            to.physics.friction = after;
            undo.record({{SessionUndo::Kind::TargetPhysics, 1},
                         SessionUndo::Merge::WithSameKind,
                         {},
                         {{0, std::move(from), std::move(to)}}});
        };
        setFriction(9.0f, 0.5f, 0.6f);
        setFriction(4.0f, 0.6f, 0.7f);
        const SessionUndo::Change back = undo.undo({});
        QCOMPARE(back.targets[0].after->physics.friction, 0.5f);
        QCOMPARE(back.targets[0].before->physics.friction, 0.7f);
        QVERIFY(back.targets[0].after->transform == back.targets[0].before->transform);
    }

    void editsOfDifferentHitsNameNone() {
        HitHistory history;
        SessionUndo undo;
        undo.record({.edits = {history.append(hitAt(1)), history.append(hitAt(2))}});
        const auto edit = [&](std::size_t index, float distance) {
            Hit hit = history.hits()[index];
            hit.constants.maxDistance = distance;
            undo.record({{SessionUndo::Kind::EditHit, 1, index + 1},
                         SessionUndo::Merge::WithSameKind,
                         {history.splice(index, 1, {&hit, 1})}});
        };
        edit(1, 0.7f);
        edit(1, 0.8f);
        QCOMPARE(undo.toUndo()->hit, std::size_t{2});
        edit(0, 0.7f);
        QCOMPARE(undo.size(), std::size_t{2});
        QCOMPARE(undo.toUndo()->hit, std::size_t{0});
    }

    void aTargetsEditIsUndoneByItsInverse() {
        SessionUndo undo;
        undo.record({{SessionUndo::Kind::RemoveTarget, 2},
                     SessionUndo::Merge::Never,
                     {},
                     {{3, targetAt(1, 7), {}}, {1, targetAt(2, 8), {}}}});
        const SessionUndo::Change back = undo.undo({});
        QCOMPARE(back.targets.size(), std::size_t{2});
        QCOMPARE(back.targets[0].index, std::size_t{1});
        QVERIFY(!back.targets[0].before);
        QCOMPARE(back.targets[0].after->id, TargetId{8});
        QCOMPARE(back.targets[1].index, std::size_t{3});
        QCOMPARE(undo.redo().targets[0].before->id, TargetId{7});
    }

    void movesOfOneTargetMergeWhereAsked() {
        SessionUndo undo;
        using Merge = SessionUndo::Merge;
        undo.record(movedTarget(0, 1, Merge::Never));
        undo.record(movedTarget(1, 2, Merge::WithSameKind));
        undo.record(movedTarget(2, 3, Merge::WithSameKind));
        undo.record(movedTarget(3, 4, Merge::Never));            // a step of its own
        undo.record(movedTarget(0, 9, Merge::WithSameKind, 2));  // another target
        (void)undo.undo({});
        QCOMPARE(undo.undo({}).targets[0].after->transform.position.x, 3.0f);
        const SessionUndo::Change all = undo.undo({});
        QCOMPARE(all.targets[0].before->transform.position.x, 3.0f);
        QCOMPARE(all.targets[0].after->transform.position.x, 0.0f);
        QVERIFY(!undo.canUndo());
        (void)undo.redo();
        undo.record(movedTarget(3, 5, Merge::WithSameKind));  // after a redo nothing merges
        QCOMPARE(undo.undo({}).targets[0].after->transform.position.x, 3.0f);
    }

    void undoBringsEveryRevisionForward() {
        HitHistory history;
        SessionUndo undo;
        undo.record({.edits = {history.append(hitAt(1))}});
        const std::uint64_t revision = history.revision();
        make(history, undo.undo(history.hits()));
        QVERIFY(history.revision() > revision);
    }
};

HITSCOPE_TEST(SessionUndoTest, QCoreApplication)

}  // namespace hitscope::session_undo_test

#include "session_undo_test.moc"
