// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace hitscope::physics {

/// Values that are those of an original but for the runs that were changed: a large mesh with a few dents
/// takes memory for these. Neighbours in an array are neighbours in space, so a dent changes few runs. A
/// run is copied without a page fault, unlike the pages of a PageCopy.
template <class T>
class RunArray {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    static constexpr std::size_t kRun = 64;  ///< values; the last run may have fewer

    RunArray() = default;
    /// `original` outlives this and stays as it is.
    explicit RunArray(std::span<const T> original) : m_original(original) {
        m_runs.reserve((original.size() + kRun - 1) / kRun);
        for (std::size_t first = 0; first < original.size(); first += kRun) {
            m_runs.push_back(original.data() + first);
        }
    }
    RunArray(const RunArray& other) : RunArray(other.m_original) {
        for (const std::uint32_t run : other.m_changed) {
            const std::span<const T> values = other.run(run);
            std::copy(values.begin(), values.end(), changeRun(run).begin());
        }
    }
    RunArray(RunArray&&) noexcept = default;
    RunArray& operator=(const RunArray&) = delete;
    RunArray& operator=(RunArray&&) noexcept = default;
    ~RunArray() = default;

    [[nodiscard]] std::size_t size() const { return m_original.size(); }
    [[nodiscard]] const T& operator[](std::size_t i) const { return m_runs[i / kRun][i % kRun]; }
    [[nodiscard]] const T& original(std::size_t i) const { return m_original[i]; }
    /// A value, to be changed.
    [[nodiscard]] T& change(std::size_t i) {
        return changeRun(static_cast<std::uint32_t>(i / kRun))[i % kRun];
    }
    /// The values of a run, to be changed.
    [[nodiscard]] std::span<T> changeRun(std::uint32_t run) {
        const std::size_t count = sizeOf(run);
        const T* const original = m_original.data() + run * kRun;
        if (m_runs[run] != original) {
            return {const_cast<T*>(m_runs[run]), count};
        }
        const std::size_t place = m_changed.size();
        if (place / kRunsAtOnce == m_own.size()) {
            m_own.emplace_back(new T[kRunsAtOnce * kRun]);
        }
        T* const own = m_own[place / kRunsAtOnce].get() + place % kRunsAtOnce * kRun;
        std::copy_n(original, count, own);
        m_runs[run] = own;
        m_changed.push_back(run);
        return {own, count};
    }
    [[nodiscard]] std::span<const T> run(std::uint32_t run) const { return {m_runs[run], sizeOf(run)}; }
    /// The run is about to be looked at: on a large mesh each cache line of it is a miss, and asked for
    /// together the memory works on them at once.
    void ask(std::size_t run) const {
        constexpr std::size_t kCacheLine = 64;  // bytes
        for (std::size_t i = 0; i < kRun; i += kCacheLine / sizeof(T)) {
            __builtin_prefetch(m_runs[run] + i);
        }
    }
    /// Runs that were to be changed since the last reset(), each once.
    [[nodiscard]] std::span<const std::uint32_t> changed() const { return m_changed; }
    /// To the original.
    void reset() {
        for (const std::uint32_t run : m_changed) {
            m_runs[run] = m_original.data() + run * kRun;
        }
        m_changed.clear();
        m_own.resize(std::min(m_own.size(), kKept));
    }

private:
    static constexpr std::size_t kRunsAtOnce = 16;
    static constexpr std::size_t kKept = 16;  ///< of m_own, for the next changes

    [[nodiscard]] std::size_t sizeOf(std::size_t run) const {
        return std::min(kRun, m_original.size() - run * kRun);
    }

    std::span<const T> m_original;
    std::vector<const T*> m_runs;          ///< into the original or m_own
    std::vector<std::uint32_t> m_changed;  ///< the i-th has the i-th place in m_own
    std::vector<std::unique_ptr<T[]>> m_own;
};

/// Of vertices, metres.
using RunPositions = RunArray<glm::vec3>;

}  // namespace hitscope::physics
