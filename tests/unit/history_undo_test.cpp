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
        DeformationConstants constants;
        const auto append = [&](float x) {
            history.append(hitAt(x));
            undo.recordAppend(1);
        };
        append(1);
        append(2);
        append(3);
        undo.recordChange(history, constants);
        history.remove(1);
        append(4);
        undo.recordChange(history, constants);
        history.clear();

        const std::vector<std::vector<float>> states = {{}, {1}, {1, 2}, {1, 2, 3}, {1, 3}, {1, 3, 4}, {}};
        for (std::size_t i = states.size() - 1; i-- > 0;) {
            QVERIFY(undo.canUndo());
            constants = undo.undo(history, constants);
            QCOMPARE(places(history), states[i]);
        }
        QVERIFY(!undo.canUndo());
        for (std::size_t i = 1; i < states.size(); ++i) {
            QVERIFY(undo.canRedo());
            constants = undo.redo(history, constants);
            QCOMPARE(places(history), states[i]);
        }
        QVERIFY(!undo.canRedo());
    }

    void newChangeEndsRedo() {
        HitHistory history;
        HistoryUndo undo;
        history.append(hitAt(1));
        undo.recordAppend(1);
        undo.undo(history, {});
        QVERIFY(undo.canRedo());
        history.append(hitAt(2));
        undo.recordAppend(1);
        QVERIFY(!undo.canRedo());
    }

    void draggingConstantsIsOneStep() {
        HitHistory history;
        HistoryUndo undo;
        const DeformationConstants before;
        DeformationConstants constants = before;
        history.append(hitAt(1));
        undo.recordAppend(1);
        for (const float power : {0.06f, 0.07f, 0.08f}) {
            undo.recordChange(history, constants, HistoryUndo::Merge::WithSameKind);
            constants.power = power;
            history.setConstantsOfAll(constants);
        }
        constants = undo.undo(history, constants);
        QCOMPARE(constants.power, before.power);
        QCOMPARE(history.hits()[0].constants.power, before.power);
        constants = undo.redo(history, constants);
        QCOMPARE(constants.power, 0.08f);
        QCOMPARE(history.hits()[0].constants.power, 0.08f);
    }

    void undoBringsEveryRevisionForward() {
        HitHistory history;
        HistoryUndo undo;
        history.append(hitAt(1));
        undo.recordAppend(1);
        const std::uint64_t revision = history.revision();
        undo.undo(history, {});
        QVERIFY(history.revision() > revision);
    }
};

QTEST_APPLESS_MAIN(HistoryUndoTest)
#include "history_undo_test.moc"
