// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/give_up.h"

#include <QScopeGuard>
#include <QTest>
#include <atomic>
#include <random>
#include <thread>
#include <vector>

#include "core/parallel.h"
#include "mesh/primitives.h"
#include "session/target_plan.h"
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

    void helpersAskWhereTheyMay() {
        std::atomic<bool> stop = false;
        const std::function<bool()> isWanted = [&stop] { return !stop; };
        for (const GiveUpScope::Asked asked : {GiveUpScope::Asked::Here, GiveUpScope::Asked::Anywhere}) {
            stop = false;
            bool isThrown = false;
            bool isHelperDone = false;
            const GiveUpScope scope(isWanted, asked);
            try {
                bothAtOnce(
                    [&] {
                        while (!stop) {
                            std::this_thread::yield();
                        }
                        mayGiveUp();
                        isHelperDone = true;
                    },
                    [&stop] { stop = true; });
            } catch (const GivenUp&) {
                isThrown = true;
            }
            QCOMPARE(isThrown, asked == GiveUpScope::Asked::Anywhere);
            QCOMPARE(isHelperDone, asked == GiveUpScope::Asked::Here);
        }
    }

    /// Each stage of making a mesh ready looks: given up at any look, it ends there.
    void aMeshIsGivenUpAtAnyLook() {
        constexpr int kSegments = 120;  // 345,600 corners
        pretendedProcessors() = 1;      // all looks are this thread's
        const auto all = qScopeGuard([] { pretendedProcessors() = 0; });
        int looks = 0;
        const std::function<bool()> count = [&looks] {
            ++looks;
            return true;
        };
        {
            const GiveUpScope scope(count);
            QVERIFY(planMesh(makeCube(kSegments, 1.0f)).shape.render != nullptr);
        }
        QVERIFY2(looks >= 70, qPrintable(QString::number(looks)));
        for (int part = 0; part < 20; ++part) {
            std::atomic<int> left = looks * part / 20;
            std::atomic<int> after = 0;
            const std::function<bool()> isWanted = [&left, &after] {
                after += left < 0 ? 1 : 0;
                return --left >= 0;
            };
            const GiveUpScope scope(isWanted);
            QVERIFY_EXCEPTION_THROWN(static_cast<void>(planMesh(makeCube(kSegments, 1.0f))), GivenUp);
            QCOMPARE(after.load(), 0);
        }
    }

    void partsAndSortingLookInBetween() {
        constexpr std::size_t kCount = 1 << 20;
        constexpr std::size_t kPart = 1024;
        int looks = 0;
        const std::function<bool()> count = [&looks] {
            ++looks;
            return true;
        };
        const GiveUpScope scope(count);
        for (const std::size_t processors : {1, 8}) {
            pretendedProcessors() = processors;
            const auto all = qScopeGuard([] { pretendedProcessors() = 0; });
            std::vector<std::uint8_t> seen(kCount, 0);
            looks = 0;
            inWatchedParts(kCount, kPart, [&seen](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    ++seen[i];
                }
            });
            QVERIFY(std::all_of(seen.begin(), seen.end(), [](std::uint8_t times) { return times == 1; }));
            const int most = kCount / kPart + 1;  // others may take any of the parts
            QVERIFY2(processors == 1 ? looks == most : looks > 0 && looks <= most,
                     qPrintable(QString::number(looks)));
        }
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
