// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sorted_by_key.h"

#include <QScopeGuard>
#include <QTest>
#include <random>
#include <vector>

#include "support/test_program.h"

namespace hitscope::sorted_by_key_test {

class SortedByKeyTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void listsNumbersByTheirKeys_data() {
        QTest::addColumn<int>("processors");
        QTest::addColumn<int>("keys");
        for (const int processors : {1, 2, 5}) {
            for (const int keys : {1, 7, 100'000}) {
                QTest::addRow("%d keys, %d processors", keys, processors) << processors << keys;
            }
        }
    }
    void listsNumbersByTheirKeys() {
        QFETCH(const int, processors);
        QFETCH(const int, keys);
        pretendedProcessors() = static_cast<std::size_t>(processors);
        const auto all = qScopeGuard([] { pretendedProcessors() = 0; });
        std::mt19937 random(5);
        std::uniform_int_distribution<std::size_t> some(0, static_cast<std::size_t>(keys) - 1);
        std::vector<std::size_t> keyOf(70'000);
        std::vector<std::vector<std::uint32_t>> wanted(static_cast<std::size_t>(keys));
        for (std::uint32_t number = 0; number < keyOf.size(); ++number) {
            keyOf[number] = some(random);
            wanted[keyOf[number]].push_back(number);
        }
        const auto sorted =
            sortedByKey(keyOf.size(), wanted.size(), [&keyOf](std::size_t number) { return keyOf[number]; });
        QCOMPARE(sorted.starts.size(), wanted.size() + 1);
        QCOMPARE(sorted.starts.front(), 0u);
        QCOMPARE(std::size_t{sorted.starts.back()}, keyOf.size());
        for (std::size_t key = 0; key < wanted.size(); ++key) {
            const std::vector<std::uint32_t> found(sorted.numbers.begin() + sorted.starts[key],
                                                   sorted.numbers.begin() + sorted.starts[key + 1]);
            QCOMPARE(found, wanted[key]);
        }
    }

    void ofNothing() {
        const auto sorted = sortedByKey(0, 3, [](std::size_t) { return std::size_t{0}; });
        QCOMPARE(sorted.starts, std::vector<std::uint32_t>(4, 0));
        QVERIFY(sorted.numbers.empty());
        QCOMPARE(sortedByKey(0, 0, [](std::size_t) { return std::size_t{0}; }).starts.size(), std::size_t{1});
    }
};

HITSCOPE_TEST(SortedByKeyTest, QCoreApplication)

}  // namespace hitscope::sorted_by_key_test

#include "sorted_by_key_test.moc"
