// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/page_vector.h"

#include <QCoreApplication>
#include <QTest>
#include <algorithm>
#include <numeric>
#include <optional>

#include "core/process_memory.h"
#include "support/test_program.h"

namespace hitscope::page_vector_test {

namespace {

PageVector<int> counting(int count) {
    PageVector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

}  // namespace

class PageVectorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void copiesKeepTheirChanges_data() {
        QTest::addColumn<int>("count");
        QTest::newRow("none") << 0;
        QTest::newRow("few") << 100;
        QTest::newRow("many") << 3'000'001;
    }
    void copiesKeepTheirChanges() {
        QFETCH(const int, count);
        std::optional<PageVector<int>> original = counting(count);
        PageCopy copy(*original);
        PageCopy other(*original);
        QCOMPARE(copy.size(), original->size());
        QVERIFY(std::ranges::equal(copy.all(), *original));
        for (std::size_t i = 0; i < copy.size(); i += 997) {
            copy[i] = -1;
        }
        QVERIFY(*original == counting(count));
        QVERIFY(std::ranges::equal(other.all(), *original));
        // Copies do not need the original's memory.
        original.reset();
        const PageCopy moved = std::move(copy);
        PageVector<int> expected = counting(count);
        QVERIFY(std::ranges::equal(other.all(), expected));
        for (std::size_t i = 0; i < expected.size(); i += 997) {
            expected[i] = -1;
        }
        QVERIFY(std::ranges::equal(moved.all(), expected));
    }

    void vectorsGrow() {
        PageVector<int> numbers;
        for (int i = 0; i < 2'000'000; ++i) {
            numbers.push_back(i);
        }
        QVERIFY(numbers == counting(2'000'000));
        PageVector<int> taken = std::move(numbers);
        const PageCopy copy(taken);
        QVERIFY(std::ranges::equal(copy.all(), counting(2'000'000)));
    }

    void copiesTakeMemoryForWhatIsChanged() {
#ifndef __linux__
        QSKIP("Copies share memory on Linux only.");
#elif defined(__SANITIZE_THREAD__)
        QSKIP("The thread sanitizer takes memory for what is read.");
#else
        constexpr int kCount = 32 << 20;  // 128 MiB
        const PageVector<int> original = counting(kCount);
        const auto now = [] { return memoryOf(QCoreApplication::applicationPid()).share; };
        const auto before = now();
        PageCopy copy(original);
        long long sum = 0;
        for (const int number : copy.all()) {
            sum += number;
        }
        QCOMPARE(sum, static_cast<long long>(kCount) * (kCount - 1) / 2);
        const auto read = now();
        QVERIFY2(read < before + (16 << 20), qPrintable(QString::number(read - before)));
        std::fill(copy.all().begin(), copy.all().end(), 1);
        const auto written = now();
        QVERIFY2(written > read + (96 << 20), qPrintable(QString::number(written - read)));
#endif
    }
};

HITSCOPE_TEST(PageVectorTest, QCoreApplication)

}  // namespace hitscope::page_vector_test

#include "page_vector_test.moc"
