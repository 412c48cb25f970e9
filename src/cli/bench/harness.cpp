// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/harness.h"

#include <algorithm>
#include <chrono>

namespace hitscope::bench {

namespace {

double medianOf(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// One sample; what it took for the caller's budget (prepare and run) is added to `spent`.
Result<double> takeSample(const Variant& variant, const Clock& clock, double& spent) {
    const double begin = clock();
    if (variant.prepare) {
        if (Status status = variant.prepare(); !status) {
            return status.error();
        }
    }
    const double start = clock();
    if (Status status = variant.run(); !status) {
        return status.error();
    }
    const double end = clock();
    spent += end - begin;
    return (end - start) / variant.units;
}

/// A warm-up that alone eats a variant's time would leave none for measuring.
bool isWarm(const Plan& plan, int samples, double spent) {
    return samples >= plan.warmUp || (samples > 0 && spent > 0.5 * plan.seconds);
}

bool isDone(const Plan& plan, const Samples& samples, double spent) {
    const auto kept = static_cast<int>(samples.size());
    return kept >= plan.mostSamples || (kept >= plan.leastSamples && spent >= plan.seconds);
}

Status warmUp(std::span<const Variant> variants, const Plan& plan, const Progress& progress,
              const Clock& clock) {
    std::vector<double> spent(variants.size(), 0.0);
    for (int round = 0; round < plan.warmUp; ++round) {
        for (std::size_t i = 0; i < variants.size(); ++i) {
            if (isWarm(plan, round, spent[i])) {
                continue;
            }
            if (progress) {
                progress(variants[i], 0);
            }
            if (Result<double> sample = takeSample(variants[i], clock, spent[i]); !sample) {
                return sample.error();
            }
        }
    }
    return Done{};
}

}  // namespace

double Samples::median() const {
    return medianOf(m_values);
}

double Samples::least() const {
    return m_values.empty() ? 0.0 : *std::min_element(m_values.begin(), m_values.end());
}

double Samples::most() const {
    return m_values.empty() ? 0.0 : *std::max_element(m_values.begin(), m_values.end());
}

TimeRatio timeRatioWithRounds(const Samples& a, const Samples& b) {
    TimeRatio ratio;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (b.values()[i] > 0.0) {
            ratio.rounds.add(a.values()[i] / b.values()[i]);
        }
    }
    ratio.value = ratio.rounds.median();
    return ratio;
}

double timeRatio(const Samples& a, const Samples& b) {
    return timeRatioWithRounds(a, b).value;
}

double ratioOfMedians(const Samples& a, const Samples& b) {
    return b.median() > 0.0 ? a.median() / b.median() : 0.0;
}

double steadySeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Result<std::vector<Samples>> measure(std::span<const Variant> variants, const Plan& plan,
                                     const Progress& progress, const Clock& clock) {
    if (Status status = warmUp(variants, plan, progress, clock); !status) {
        return status.error();
    }
    std::vector<Samples> samples(variants.size());
    std::vector<double> spent(variants.size(), 0.0);
    bool isBackwards = false;
    for (bool more = true; more; isBackwards = !isBackwards) {
        more = false;
        for (std::size_t k = 0; k < variants.size(); ++k) {
            const std::size_t i = isBackwards ? variants.size() - 1 - k : k;
            if (isDone(plan, samples[i], spent[i])) {
                continue;
            }
            if (progress) {
                progress(variants[i], samples[i].size());
            }
            Result<double> sample = takeSample(variants[i], clock, spent[i]);
            if (!sample) {
                return sample.error();
            }
            samples[i].add(sample.value());
            more = true;
        }
    }
    return samples;
}

}  // namespace hitscope::bench
