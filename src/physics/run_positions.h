// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

namespace hitscope::physics {

/// Positions that are those of an original but for the runs that were changed: a large mesh with a few dents
/// takes memory for these. Neighbours in the buffer are neighbours in space, so a dent changes few runs.
class RunPositions {
public:
    static constexpr std::size_t kRun = 64;  ///< positions; the last run may have fewer

    /// `original` outlives this and stays as it is.
    explicit RunPositions(std::span<const glm::vec3> original);
    RunPositions(RunPositions&&) = default;
    RunPositions& operator=(RunPositions&&) = default;

    [[nodiscard]] std::size_t size() const { return m_original.size(); }
    [[nodiscard]] const glm::vec3& operator[](std::size_t i) const { return m_runs[i / kRun][i % kRun]; }
    [[nodiscard]] const glm::vec3& original(std::size_t i) const { return m_original[i]; }
    /// The positions of a run, to be changed.
    [[nodiscard]] std::span<glm::vec3> change(std::uint32_t run);
    [[nodiscard]] std::span<const glm::vec3> run(std::uint32_t run) const {
        return {m_runs[run], sizeOf(run)};
    }
    /// The run is about to be looked at: on a large mesh each cache line of it is a miss, and asked for
    /// together the memory works on them at once.
    void ask(std::size_t run) const {
        constexpr std::size_t kACacheLine = 5;  // positions
        for (std::size_t i = 0; i < kRun; i += kACacheLine) {
            __builtin_prefetch(m_runs[run] + i);
        }
    }
    /// Runs that were to be changed since the last reset(), each once.
    [[nodiscard]] std::span<const std::uint32_t> changed() const { return m_changed; }
    void reset();  ///< to the original

private:
    static constexpr std::size_t kRunsAtOnce = 16;  // 12 KiB

    [[nodiscard]] std::size_t sizeOf(std::size_t run) const {
        return run * kRun + kRun <= m_original.size() ? kRun : m_original.size() - run * kRun;
    }

    std::span<const glm::vec3> m_original;
    std::vector<const glm::vec3*> m_runs;  ///< into the original or m_own
    std::vector<std::uint32_t> m_changed;  ///< the i-th has the i-th place in m_own
    std::vector<std::unique_ptr<glm::vec3[]>> m_own;
};

}  // namespace hitscope::physics
