// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/give_up.h"
#include "core/parallel.h"
#include "core/raw_vector.h"

namespace hitscope {

/// The numbers [0, n) by their keys: those with key k are numbers[starts[k]] .. numbers[starts[k + 1]],
/// ascending.
template <class Numbers>
struct KeyedNumbers {
    std::vector<std::uint32_t> starts;  ///< one a key, and one more
    Numbers numbers;
};

/// Sorts [0, count) by key(number) < keys. Time O(count + keys) on each of the threads: they share the keys.
template <class Numbers = RawVector<std::uint32_t>, class Key>
KeyedNumbers<Numbers> sortedByKey(std::size_t count, std::size_t keys, const Key& key) {
    constexpr std::size_t kKeysAThread = 16384;  // fewer are done sooner than a thread is started
    KeyedNumbers<Numbers> result{std::vector<std::uint32_t>(keys + 1, 0), Numbers(count)};
    const auto forEachNumber = [&](const auto& work) {
        inParts(keys, kKeysAThread, [&](std::size_t first, std::size_t end) {
            for (std::size_t number = 0; number < count; ++number) {
                mayGiveUp(number);
                const std::size_t ofNumber = key(number);
                if (ofNumber >= first && ofNumber < end) {
                    work(ofNumber, static_cast<std::uint32_t>(number));
                }
            }
        });
    };
    std::vector<std::uint32_t>& starts = result.starts;
    forEachNumber([&starts](std::size_t ofNumber, std::uint32_t /*number*/) { ++starts[ofNumber]; });
    std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), 0U);
    // Each start moves to the end of its numbers, where the next one's start.
    forEachNumber(
        [&](std::size_t ofNumber, std::uint32_t number) { result.numbers[starts[ofNumber]++] = number; });
    std::move_backward(starts.begin(), starts.end() - 1, starts.end());
    starts.front() = 0;
    return result;
}

}  // namespace hitscope
