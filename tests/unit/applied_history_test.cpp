// SPDX-License-Identifier: GPL-3.0-or-later
// A history of which only some hits are applied, changed in every way, followed by edits.
#include "deform/applied_history.h"
#include "support/test_program.h"

#include <QTest>
#include <algorithm>
#include <random>
#include <tuple>

namespace hitscope::applied_history_test {

namespace {

/// By the edits alone, each of which has to be about what is there.
void carryOut(std::vector<Hit>& mirror, const HistoryEdit& edit) {
    QVERIFY(edit.first + edit.before.size() <= mirror.size());
    const auto at = mirror.begin() + static_cast<std::ptrdiff_t>(edit.first);
    QVERIFY(std::equal(edit.before.begin(), edit.before.end(), at));
    const auto gap = mirror.erase(at, at + static_cast<std::ptrdiff_t>(edit.before.size()));
    mirror.insert(gap, edit.after.begin(), edit.after.end());
}

}  // namespace

class AppliedHistoryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void followsRandomEdits() {
        std::mt19937 random(4);
        HitHistory history;
        AppliedHistory applied;
        std::vector<Hit> mirror;
        std::uint32_t next = 1;
        for (int step = 0; step < 600; ++step) {
            std::vector<HistoryEdit> edits;
            for (std::size_t i = random() % 4; i > 0; --i) {
                const std::size_t first = random() % (history.size() + 1);
                const std::size_t count = std::min<std::size_t>(random() % 5, history.size() - first);
                std::vector<Hit> after(random() % 5);
                for (Hit& hit : after) {
                    hit.target = TargetId{next++};
                    hit.enabled = random() % 4 != 0;
                }
                edits.push_back(random() % 2 == 0 ? history.append(after)
                                                  : history.splice(first, count, after));
            }
            std::vector<std::size_t> dropped;
            for (std::size_t row = 0; row < history.size() && random() % 8 != 0; ++row) {
                if (random() % 3 != 0) {
                    dropped.push_back(row);
                }
            }
            const std::size_t shown = random() % 3 == 0 ? AppliedHits::kAll : random() % (history.size() + 2);
            const AppliedHits wanted{shown, dropped};
            if (random() % 50 == 0) {
                mirror.clear();
                carryOut(mirror, applied.startOver(history.hits(), wanted));
            } else {
                for (const HistoryEdit& edit : applied.follow(edits, history.hits(), wanted)) {
                    carryOut(mirror, edit);
                }
            }
            QCOMPARE(mirror.size(), history.size());
            for (std::size_t row = 0; row < mirror.size(); ++row) {
                Hit should = history.hits()[row];
                should.enabled = should.enabled && wanted.contains(row);
                QVERIFY(mirror[row] == should);
            }
        }
    }

    void aHitThatTakesTheOldestsPlaceIsTwoSmallEdits() {
        HitHistory history;
        history.append(std::vector<Hit>(1000));
        AppliedHistory applied;
        std::vector<std::size_t> dropped{0, 1, 2};
        std::ignore = applied.startOver(history.hits(), {AppliedHits::kAll, dropped});
        const HistoryEdit edit = history.append(Hit{});
        dropped.push_back(3);
        const auto made = applied.follow({&edit, 1}, history.hits(), {AppliedHits::kAll, dropped});
        QCOMPARE(made.size(), std::size_t{2});
        QCOMPARE(made[0].first, std::size_t{1000});
        QCOMPARE(made[1].first, std::size_t{3});
        QCOMPARE(made[1].before.size(), std::size_t{1});
        QVERIFY(made[1].before[0].enabled && !made[1].after[0].enabled);
    }
};

HITSCOPE_TEST(AppliedHistoryTest, QCoreApplication)

}  // namespace hitscope::applied_history_test

#include "applied_history_test.moc"
