// SPDX-License-Identifier: GPL-3.0-or-later
// The first hits of a history that is changed in every way, followed by edits.
#include "deform/history_prefix.h"
#include "support/test_program.h"

#include <QTest>
#include <random>

namespace hitscope::history_prefix_test {

class HistoryPrefixTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void followsRandomEdits() {
        std::mt19937 random(2);
        HitHistory history;
        HistoryPrefix prefix;
        std::vector<Hit> mirror;  // made of the edits alone
        std::uint32_t next = 1;
        for (int step = 0; step < 4000; ++step) {
            std::vector<HistoryEdit> edits;
            for (std::size_t i = random() % 4; i > 0; --i) {
                const std::size_t first = random() % (history.size() + 1);
                const std::size_t count = std::min<std::size_t>(random() % 5, history.size() - first);
                std::vector<Hit> after(random() % 5);
                for (Hit& hit : after) {
                    hit.target = TargetId{next++};
                }
                edits.push_back(random() % 2 == 0 ? history.append(after)
                                                  : history.splice(first, count, after));
            }
            const std::size_t wanted = random() % 3 == 0 ? history.size() : random() % (history.size() + 1);
            for (const HistoryEdit& edit : prefix.follow(edits, history.hits(), wanted)) {
                const auto at = mirror.begin() + static_cast<std::ptrdiff_t>(edit.first);
                QVERIFY(edit.first + edit.before.size() <= mirror.size());
                QVERIFY(std::equal(edit.before.begin(), edit.before.end(), at));
                const auto gap = mirror.erase(at, at + static_cast<std::ptrdiff_t>(edit.before.size()));
                mirror.insert(gap, edit.after.begin(), edit.after.end());
            }
            QCOMPARE(prefix.size(), wanted);
            QVERIFY(std::ranges::equal(mirror, history.hits().first(wanted)));
        }
    }

    void hitsThatComeAreOneEdit() {
        HitHistory history;
        HistoryPrefix prefix;
        const std::vector<HistoryEdit> edits{history.append(Hit{}), history.append(Hit{}),
                                             history.append(Hit{})};
        const std::vector<HistoryEdit> made = prefix.follow(edits, history.hits(), 3);
        QCOMPARE(made.size(), std::size_t{1});
        QCOMPARE(made[0].after.size(), std::size_t{3});
        QVERIFY(prefix.follow({}, history.hits(), 3).empty());
    }
};

HITSCOPE_TEST(HistoryPrefixTest, QCoreApplication)

}  // namespace hitscope::history_prefix_test

#include "history_prefix_test.moc"
