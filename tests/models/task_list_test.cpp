// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/task_list.h"

#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "analysis/history_copy.h"
#include "session/history_edits.h"
#include "support/test_program.h"

namespace hitscope::task_list_test {

class TaskListTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void tasksComeAndGo() {
        TaskList list;
        const QSignalSpy changed(&list, &TaskList::changed);
        QCOMPARE(list.current(), nullptr);
        auto first = std::make_unique<TaskProgress>(list, QStringLiteral("Opening"));
        const TaskProgress second(list, QStringLiteral("Measuring"));
        QCOMPARE(list.current()->what, QStringLiteral("Opening"));
        QVERIFY(list.current()->fraction < 0.0);
        first->report(0.5);
        first->report(0.5);
        first->say(QStringLiteral("Preparing"));
        QCOMPARE(changed.size(), 4);
        QCOMPARE(list.current()->fraction, 0.5);
        QCOMPARE(list.current()->what, QStringLiteral("Preparing"));
        first.reset();
        QCOMPARE(list.size(), std::size_t{1});
        QCOMPARE(list.current()->what, QStringLiteral("Measuring"));
    }

    void cancelEndsTheTaskThatItIsOf() {
        TaskList list;
        int cancelled = 0;
        std::unique_ptr<TaskProgress> task;
        task = std::make_unique<TaskProgress>(list, QStringLiteral("Opening"), [&] {
            ++cancelled;
            task.reset();
        });
        const int id = list.current()->id;
        list.cancel(id + 1);
        QCOMPARE(cancelled, 0);
        list.cancel(id);
        QCOMPARE(cancelled, 1);
        QCOMPARE(list.size(), std::size_t{0});
        list.cancel(id);
        QCOMPARE(cancelled, 1);
    }

    void aCopyOfTheHistoryFollowsEdits() {
        HitHistory history;
        HistoryFollower follower;
        const auto isSame = [&] {
            const HistoryCopy::Update update = follower.update(history, {});
            follower.copy()->apply(update);
            return std::equal(follower.copy()->hits().begin(), follower.copy()->hits().end(),
                              history.hits().begin(), history.hits().end());
        };
        QVERIFY(isSame());
        for (int i = 0; i < 20; ++i) {
            Hit hit;
            hit.time = i;
            history.append(hit);
        }
        QVERIFY(isSame());
        using Rows = std::vector<std::size_t>;
        history.move(Rows{3}, 12);
        history.remove(Rows{5});
        history.setEnabled(Rows{7}, false);
        QVERIFY(isSame());
        follower.startOver();
        QVERIFY(isSame());
        history.clear();
        QVERIFY(isSame());
    }

    void whatIsUndoneAtOnceLeavesNothingToDo() {
        HitHistory history;
        for (int i = 0; i < 5; ++i) {
            history.append(Hit{});
        }
        const std::uint64_t revision = history.revision();
        Hit other;
        other.constants.power = 0.1f;
        const HistoryEdit edit = history.splice(0, 5, std::vector(5, other));
        QCOMPARE(withoutUndone(*history.editsSince(revision)).size(), std::size_t{1});
        history.redo({edit.first, edit.after, edit.before});
        QVERIFY(withoutUndone(*history.editsSince(revision)).empty());
    }
};

HITSCOPE_TEST(TaskListTest, QCoreApplication)

}  // namespace hitscope::task_list_test

#include "task_list_test.moc"
