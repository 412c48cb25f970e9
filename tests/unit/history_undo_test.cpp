// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history_undo.h"

#include <QtTest>

using namespace hitscope;

namespace {

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

}  // namespace

class HistoryUndoTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void undoesAndRedoesEveryKindOfChangeInOrder() {
        HitHistory history;
        HistoryUndo undo;
        const auto record = [&](std::vector<HistoryEdit> edits) { undo.record({std::move(edits), {}, {}}); };
        record({history.append(hitAt(1))});
        record({history.append(hitAt(2))});
        record({history.append(hitAt(3))});
        record({history.remove(1)});
        record({history.append(hitAt(4))});
        record(history.move(2, 0));
        record({history.clear()});

        const std::vector<std::vector<float>> states = {{},     {1},       {1, 2},    {1, 2, 3},
                                                        {1, 3}, {1, 3, 4}, {4, 1, 3}, {}};
        for (std::size_t i = states.size() - 1; i-- > 0;) {
            QVERIFY(undo.canUndo());
            undo.undo(history);
            QCOMPARE(places(history), states[i]);
        }
        QVERIFY(!undo.canUndo());
        for (std::size_t i = 1; i < states.size(); ++i) {
            QVERIFY(undo.canRedo());
            undo.redo(history);
            QCOMPARE(places(history), states[i]);
        }
        QVERIFY(!undo.canRedo());
    }

    void newChangeEndsRedo() {
        HitHistory history;
        HistoryUndo undo;
        undo.record({{history.append(hitAt(1))}, {}, {}});
        undo.undo(history);
        QVERIFY(undo.canRedo());
        undo.record({{history.append(hitAt(2))}, {}, {}});
        QVERIFY(!undo.canRedo());
    }

    void whatChangesNothingIsNoStep() {
        HitHistory history;
        HistoryUndo undo;
        undo.record({{history.clear()}, {}, {}});
        QVERIFY(!undo.canUndo());
    }

    void draggingConstantsIsOneStep() {
        HitHistory history;
        HistoryUndo undo;
        const DeformationConstants before;
        DeformationConstants constants = before;
        undo.record({{history.append(hitAt(1))}, before, before});
        undo.record({{history.append(hitAt(2))}, before, before});
        for (const float power : {0.06f, 0.07f, 0.08f}) {
            DeformationConstants next = constants;
            next.power = power;
            undo.record(
                {{history.setConstantsOfAll(next)}, constants, next, HistoryUndo::Merge::WithSameKind});
            constants = next;
        }
        QCOMPARE(undo.undo(history).power, before.power);
        for (const Hit& hit : history.hits()) {
            QCOMPARE(hit.constants.power, before.power);
        }
        QCOMPARE(undo.redo(history).power, 0.08f);
        for (const Hit& hit : history.hits()) {
            QCOMPARE(hit.constants.power, 0.08f);
        }
    }

    void undoBringsEveryRevisionForward() {
        HitHistory history;
        HistoryUndo undo;
        undo.record({{history.append(hitAt(1))}, {}, {}});
        const std::uint64_t revision = history.revision();
        undo.undo(history);
        QVERIFY(history.revision() > revision);
    }
};

QTEST_APPLESS_MAIN(HistoryUndoTest)
#include "history_undo_test.moc"
