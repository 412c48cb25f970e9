// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"

namespace hitscope::bench {

/// One of the things that are measured against each other.
struct Variant {
    std::string name;
    /// What one sample's time is divided by: frames, hits. >= 1.
    double units = 1.0;
    /// Before each sample, outside the clock; may be empty.
    std::function<Status()> prepare;
    /// The sample. It comes back when its work is really finished: after glFinish.
    std::function<Status()> run;
};

/// How long and how often to measure.
struct Plan {
    int warmUp = 2;         ///< samples of each variant that are not kept
    int leastSamples = 3;   ///< kept, whatever they cost
    int mostSamples = 100;  ///< kept; >= leastSamples
    double seconds = 2.0;   ///< for each variant; a slow one gets fewer samples
};

/// The times of one variant, seconds a unit, in the order they were taken.
class Samples {
public:
    void add(double seconds) { m_values.push_back(seconds); }
    [[nodiscard]] std::size_t size() const { return m_values.size(); }
    [[nodiscard]] bool empty() const { return m_values.empty(); }
    [[nodiscard]] std::span<const double> values() const { return m_values; }
    // 0 when empty.
    [[nodiscard]] double median() const;
    [[nodiscard]] double least() const;
    [[nodiscard]] double most() const;

private:
    std::vector<double> m_values;
};

/// How many times as long `a` takes as `b`, which were measured together: the median over the rounds of the
/// quotient within a round, in which both saw the same machine. A slow variant drops out of the later rounds,
/// so only those count that both were in. 0 when either is empty.
[[nodiscard]] double timeRatio(const Samples& a, const Samples& b);

/// A timeRatio() and where it comes from.
struct TimeRatio {
    double value = 0.0;
    Samples rounds;  ///< the quotients within a round
};
[[nodiscard]] TimeRatio timeRatioWithRounds(const Samples& a, const Samples& b);
/// The same of two that were measured one after the other: they have no rounds in common. 0 when either is
/// empty.
[[nodiscard]] double ratioOfMedians(const Samples& a, const Samples& b);

/// Seconds on a clock that does not go back.
using Clock = std::function<double()>;
[[nodiscard]] double steadySeconds();

/// Told before each sample: the variant, and how many of its samples are kept so far.
using Progress = std::function<void(const Variant& variant, std::size_t kept)>;

/// Measures the variants in turn, A B C C B A A B C ..., one sample each a round, so that what the machine
/// does meanwhile falls on all of them alike, and so does what each leaves in the caches for the next: in the
/// same order always, the first of two equal ones measured up to a quarter longer. First come the warm-up
/// rounds. A variant whose time or samples are used up drops out. Returns one Samples a variant, in their
/// order; the error is the first that a variant gave.
[[nodiscard]] Result<std::vector<Samples>> measure(std::span<const Variant> variants, const Plan& plan,
                                                   const Progress& progress = {},
                                                   const Clock& clock = steadySeconds);

}  // namespace hitscope::bench
