// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>

#include "core/give_up.h"

namespace hitscope {

/// For tests: as if there were so many processors; 0: those that there are.
inline std::atomic<std::size_t>& pretendedProcessors() {
    static std::atomic<std::size_t> processors = 0;
    return processors;
}

/// Threads that are worth starting here: [1, 8].
inline std::size_t usefulThreads() {
    const std::size_t pretended = pretendedProcessors();
    return std::clamp<std::size_t>(pretended > 0 ? pretended : std::thread::hardware_concurrency(), 1, 8);
}

/// Calls a() on another thread and b() on this one, and waits for both; one after the other where there is no
/// thread to be had. What either throws is thrown here.
template <class A, class B>
void bothAtOnce(const A& a, const B& b) {
    std::exception_ptr thrown;
    {
        std::jthread helper;
        bool started = true;
        try {
            helper = std::jthread([&a, &thrown, helped = GiveUpScope::forHelpers()] {
                const GiveUpScope scope(helped);
                try {
                    a();
                } catch (...) {
                    thrown = std::current_exception();
                }
            });
        } catch (const std::system_error&) {
            started = false;
        }
        if (!started) {
            a();
        }
        b();
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

/// Calls work(i) for all i of [0, count) at once, each on a thread of its own, and waits.
template <class Work>
void forEachAtOnce(std::size_t count, const Work& work) {
    const auto call = [&work](const auto& self, std::size_t first, std::size_t end) -> void {
        if (end - first == 1) {
            work(first);
            return;
        }
        const std::size_t middle = first + (end - first) / 2;
        bothAtOnce([&] { self(self, middle, end); }, [&] { self(self, first, middle); });
    };
    if (count > 0) {
        call(call, 0, count);
    }
}

/// Calls work(begin, end) for neighbouring parts of [0, count), each of about `least` or more, at once, and
/// waits.
template <class Work>
void inParts(std::size_t count, std::size_t least, const Work& work) {
    const std::size_t parts =
        std::clamp<std::size_t>(count / std::max<std::size_t>(least, 1), 1, usefulThreads());
    forEachAtOnce(parts, [&](std::size_t part) { work(count * part / parts, count * (part + 1) / parts); });
}

/// As inParts(), with a look by this thread before each of its parts, each of `least` at most. Whoever is
/// ready takes the next part: threads start late where a processor sleeps.
template <class Work>
void inWatchedParts(std::size_t count, std::size_t least, const Work& work) {
    const std::size_t size = std::max<std::size_t>(least, 1);
    const std::size_t parts = (count + size - 1) / size;
    std::atomic<std::size_t> next = 0;
    const auto takeParts = [&] {
        try {
            mayGiveUp();
            for (std::size_t part = next++; part < parts; part = next++) {
                work(size * part, std::min(size * (part + 1), count));
                mayGiveUp();
            }
        } catch (...) {
            next = parts;  // the others end, too
            throw;
        }
    };
    forEachAtOnce(std::min(parts, usefulThreads()), [&](std::size_t) { takeParts(); });
}

}  // namespace hitscope
