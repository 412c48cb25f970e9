// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/median_split.h"

#include <QTest>
#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "support/test_program.h"

namespace hitscope::median_split_test {

namespace {

using Items = std::vector<PlacedItem>;

Items itemsAt(std::size_t count, const std::function<glm::vec3(std::size_t)>& place) {
    Items items;
    for (std::size_t i = 0; i < count; ++i) {
        items.push_back({place(i), static_cast<std::uint32_t>(i)});
    }
    return items;
}

/// Of those that sorting all by the coordinate, and then the index, puts first.
std::vector<std::uint32_t> firstBySorting(Items items, std::size_t count, glm::length_t axis) {
    std::sort(items.begin(), items.end(), [axis](const PlacedItem& a, const PlacedItem& b) {
        return std::pair(a.at[axis], a.index) < std::pair(b.at[axis], b.index);
    });
    std::vector<std::uint32_t> first;
    for (const PlacedItem& item : std::span(items).first(count)) {
        first.push_back(item.index);
    }
    std::sort(first.begin(), first.end());
    return first;
}

/// Empty if splitting puts first what sorting does, and keeps every item.
QString fault(const Items& given, std::size_t count, glm::length_t axis) {
    Items items = given;
    splitOnLongestAxis(items, count);
    std::vector<std::uint32_t> first;
    for (const PlacedItem& item : std::span(items).first(count)) {
        first.push_back(item.index);
    }
    std::sort(first.begin(), first.end());
    if (first != firstBySorting(given, count, axis)) {
        return QStringLiteral("others come first at %1 of %2").arg(count).arg(given.size());
    }
    std::sort(items.begin(), items.end(),
              [](const PlacedItem& a, const PlacedItem& b) { return a.index < b.index; });
    const bool isKept =
        std::equal(items.begin(), items.end(), given.begin(),
                   [](const auto& a, const auto& b) { return a.index == b.index && a.at == b.at; });
    return isKept ? QString() : QStringLiteral("an item was lost");
}

}  // namespace

class MedianSplitTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void asSortingDoes_data() {
        QTest::addColumn<int>("count");
        for (const int count : {1, 2, 3, 15, 16, 17, 32, 63, 64, 65, 499, 2'001, 30'000, 120'000}) {
            QTest::newRow(qPrintable(QString::number(count))) << count;
        }
    }
    void asSortingDoes() {
        QFETCH(const int, count);
        const auto size = static_cast<std::size_t>(count);
        std::mt19937 random(7);
        std::normal_distribution<float> somewhere(0.0f, 3.0f);
        std::uniform_int_distribution<int> few(-2, 2);
        const float whole = static_cast<float>(count);
        for (const std::size_t first : {std::size_t{0}, size / 7, size / 2, size - 1, size}) {
            QCOMPARE(fault(itemsAt(size, [&](std::size_t) { return glm::vec3(somewhere(random), 0.1f, 0); }),
                           first, 0),
                     QString());
            // Ascending, descending, in few places (0 and -0 are one of them), and all in one.
            QCOMPARE(fault(itemsAt(size, [](std::size_t i) { return glm::vec3(0, 0, float(i)); }), first, 2),
                     QString());
            QCOMPARE(fault(itemsAt(size, [&](std::size_t i) { return glm::vec3(0, whole - float(i), 0); }),
                           first, 1),
                     QString());
            QCOMPARE(fault(itemsAt(size,
                                   [&](std::size_t i) {
                                       const auto at = static_cast<float>(few(random));
                                       return glm::vec3(at == 0.0f && i % 2 == 0 ? -at : at, 0, 0);
                                   }),
                           first, 0),
                     QString());
            QCOMPARE(fault(itemsAt(size, [](std::size_t) { return glm::vec3(-1); }), first, 0), QString());
        }
    }

    void whatMisleadsTheSamplesIsSplitToo() {
        // The samples are taken in equal steps; those places have the lowest coordinates.
        constexpr std::size_t kCount = 100'000;
        Items items = itemsAt(kCount, [](std::size_t i) { return glm::vec3(1.0f + float(i % 1009), 0, 0); });
        for (std::size_t sample = 0; sample < 511; ++sample) {
            items[kCount * sample / 511].at.x = -static_cast<float>(sample);
        }
        QCOMPARE(fault(items, kCount / 2, 0), QString());
    }

    void theLongestAxisCounts() {
        // Of equally long ones the first.
        const Items items =
            itemsAt(1000, [](std::size_t i) { return glm::vec3(i % 10, i / 100, i / 10 % 10); });
        QCOMPARE(fault(items, 500, 0), QString());
    }
};

HITSCOPE_TEST(MedianSplitTest, QCoreApplication)

}  // namespace hitscope::median_split_test

#include "median_split_test.moc"
