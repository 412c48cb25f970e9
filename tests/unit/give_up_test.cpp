// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/give_up.h"

#include <QTest>
#include <random>
#include <vector>

#include "support/test_program.h"

namespace hitscope::give_up_test {

class GiveUpTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nobodyEndsWorkWithoutAScope() {
        for (std::size_t step = 0; step < 3 * kStepsBetweenLooks; ++step) {
            mayGiveUp(step);
        }
        QVERIFY(!GiveUpScope::isGivenUp());
    }

    void theInnerScopeCounts() {
        const std::function<bool()> no = [] { return false; };
        const std::function<bool()> yes = [] { return true; };
        const GiveUpScope outer(no);
        {
            const GiveUpScope inner(yes);
            mayGiveUp();
        }
        QVERIFY_EXCEPTION_THROWN(mayGiveUp(), GivenUp);
    }

    void partsAndSortingLookInBetween() {
        constexpr std::size_t kCount = 1 << 20;
        int looks = 0;
        const std::function<bool()> count = [&looks] {
            ++looks;
            return true;
        };
        const GiveUpScope scope(count);
        std::vector<std::uint8_t> seen(kCount, 0);
        inWatchedParts(kCount, 1024, [&seen](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                ++seen[i];
            }
        });
        QVERIFY(std::all_of(seen.begin(), seen.end(), [](std::uint8_t times) { return times == 1; }));
        QVERIFY2(looks >= 128, qPrintable(QString::number(looks)));
        std::mt19937 random(1);
        std::vector<std::uint32_t> numbers(kCount + 12345);
        std::generate(numbers.begin(), numbers.end(), [&random] { return random() % 100'000; });
        std::vector<std::uint32_t> sorted = numbers;
        std::sort(sorted.begin(), sorted.end());
        looks = 0;
        sortWatched(numbers.begin(), numbers.end());
        QCOMPARE(numbers, sorted);
        QVERIFY2(looks >= 9, qPrintable(QString::number(looks)));
    }
};

HITSCOPE_TEST(GiveUpTest, QCoreApplication)

}  // namespace hitscope::give_up_test

#include "give_up_test.moc"
