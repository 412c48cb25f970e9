// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/median_split.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/bounds.h"

namespace hitscope {
namespace {

using Key = std::uint64_t;

constexpr std::size_t kFew = 16;  // so many are sorted by counting
constexpr int kMostRounds = 40;   // one leaves half, the others little, unless the samples mislead
constexpr std::size_t kMostSamples = 511;

/// Of so many items or more, how many are looked at to guess the key that divides them, and how many places
/// from the guess the one lies that is taken: the part that is left is then small in the next round.
struct Sampling {
    std::size_t items;
    std::size_t samples;
    std::size_t away;
};
constexpr std::array<Sampling, 5> kSamplings{
    {{100'000, kMostSamples, 24}, {2'000, 63, 7}, {500, 31, 3}, {64, 15, 2}, {0, 7, 1}}};

/// Sorts as the coordinate, and then as the index does.
template <int axis>
Key keyOf(const PlacedItem& item) {
    constexpr std::uint32_t kSign = 0x80000000U;
    const float coordinate = axis == 0 ? item.at.x : (axis == 1 ? item.at.y : item.at.z);
    const auto bits = std::bit_cast<std::uint32_t>(coordinate + 0.0f);  // -0 is 0
    const std::uint32_t ascending = (bits & kSign) != 0 ? ~bits : bits | kSign;
    return (Key{ascending} << 32) | item.index;
}

/// Puts the items with keys up to `last` first; returns their end. Without a branch that depends on the
/// items.
template <int axis>
PlacedItem* putFirst(PlacedItem* begin, PlacedItem* end, Key last) {
    PlacedItem* behind = begin;
    for (PlacedItem* i = begin; i != end; ++i) {
        const PlacedItem item = *i;
        *i = *behind;
        *behind = item;
        behind += keyOf<axis>(item) <= last ? 1 : 0;
    }
    return behind;
}

/// A key near the one that has `before` of the items before it.
template <int axis>
Key guessKey(std::span<const PlacedItem> items, std::size_t before) {
    const auto isFor = [&items](const Sampling& sampling) { return items.size() >= sampling.items; };
    const Sampling& sampling = *std::find_if(kSamplings.begin(), kSamplings.end(), isFor);
    std::array<Key, kMostSamples> keys;
    for (std::size_t i = 0; i < sampling.samples; ++i) {
        keys[i] = keyOf<axis>(items[items.size() * i / sampling.samples]);
    }
    const std::size_t guess = before * sampling.samples / items.size();
    const std::size_t taken = before < items.size() / 2
                                  ? std::min(guess + sampling.away, sampling.samples - 1)
                                  : std::max(guess, sampling.away) - sampling.away;
    const auto begin = keys.begin();
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(taken),
                     begin + static_cast<std::ptrdiff_t>(sampling.samples));
    return keys[taken];
}

/// At most kFew. An item's place is the number of those before it.
template <int axis>
void sortByCounting(std::span<PlacedItem> items) {
    std::array<Key, kFew> keys;
    std::array<std::size_t, kFew> places;
    for (std::size_t i = 0; i < items.size(); ++i) {
        keys[i] = keyOf<axis>(items[i]);
        places[i] = 0;
        for (std::size_t j = 0; j < i; ++j) {
            const std::size_t isBefore = keys[j] < keys[i] ? 1 : 0;
            places[i] += isBefore;
            places[j] += 1 - isBefore;
        }
    }
    std::array<PlacedItem, kFew> sorted;
    for (std::size_t i = 0; i < items.size(); ++i) {
        sorted[places[i]] = items[i];
    }
    std::copy_n(sorted.begin(), items.size(), items.begin());
}

template <int axis>
void split(std::span<PlacedItem> items, std::size_t count) {
    PlacedItem* begin = items.data();
    PlacedItem* end = begin + items.size();
    PlacedItem* const wanted = begin + count;
    for (int round = 0; round < kMostRounds && begin + kFew < end; ++round) {
        const auto before = static_cast<std::size_t>(wanted - begin);
        PlacedItem* const behind = putFirst<axis>(begin, end, guessKey<axis>({begin, end}, before));
        if (behind == wanted) {
            return;
        }
        (wanted < behind ? end : begin) = behind;
    }
    if (begin + kFew < end) {
        std::nth_element(begin, wanted, end, [](const PlacedItem& a, const PlacedItem& b) {
            return keyOf<axis>(a) < keyOf<axis>(b);
        });
    } else {
        sortByCounting<axis>({begin, end});
    }
}

}  // namespace

void splitOnLongestAxis(std::span<PlacedItem> items, std::size_t count) {
    Bounds bounds;
    for (const PlacedItem& item : items) {
        bounds.add(item.at);
    }
    const glm::vec3 size = bounds.size();
    if (size.x >= size.y && size.x >= size.z) {
        split<0>(items, count);
    } else if (size.y >= size.z) {
        split<1>(items, count);
    } else {
        split<2>(items, count);
    }
}

}  // namespace hitscope
