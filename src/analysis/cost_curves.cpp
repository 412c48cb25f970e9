// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/cost_curves.h"

#include <algorithm>
#include <bit>

namespace hitscope {

namespace {

/// Each number up to 8, then eight steps from a power of two to the next.
std::size_t stepOf(std::size_t number) {
    constexpr std::size_t kSteps = 8;
    if (number < kSteps) {
        return number;
    }
    const auto octave = static_cast<std::size_t>(std::bit_width(number)) - 4;
    return kSteps * octave + (number >> octave);
}

std::optional<double> median(const Ring<double>& samples) {
    if (samples.empty()) {
        return std::nullopt;
    }
    std::vector<double> sorted;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        sorted.push_back(samples[i]);
    }
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

double mean(const Ring<double>& samples) {
    double sum = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        sum += samples[i];
    }
    return sum / static_cast<double>(samples.size());
}

struct Sample {
    double at = 0.0;
    double seconds = 0.0;
};

std::vector<Sample> samplesOf(std::span<const CostPoint> points, CostOf what) {
    std::vector<Sample> samples;
    for (const CostPoint& point : points) {
        if (const std::optional<double> seconds = costOf(point, what)) {
            samples.push_back({point.at, *seconds});
        }
    }
    return samples;
}

/// Between the samples' first and last number.
double valueAt(std::span<const Sample> samples, double at) {
    const auto next = std::lower_bound(samples.begin(), samples.end(), at,
                                       [](const Sample& one, double value) { return one.at < value; });
    if (next == samples.begin() || next->at == at) {
        return next->seconds;
    }
    const Sample& before = *(next - 1);
    const double along = (at - before.at) / (next->at - before.at);
    return before.seconds + along * (next->seconds - before.seconds);
}

/// Where either has a sample, within what both cover.
std::vector<double> commonNumbers(std::span<const Sample> a, std::span<const Sample> b) {
    const double first = std::max(a.front().at, b.front().at);
    const double last = std::min(a.back().at, b.back().at);
    std::vector<double> numbers;
    for (const std::span<const Sample> samples : {a, b}) {
        for (const Sample& sample : samples) {
            if (sample.at >= first && sample.at <= last) {
                numbers.push_back(sample.at);
            }
        }
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

}  // namespace

std::optional<double> costOf(const CostPoint& point, CostOf what) {
    switch (what) {
        case CostOf::Frame:
            return point.frame;
        case CostOf::Hit:
            return point.hit;
        case CostOf::FrameWithHit:
            break;
    }
    return point.frame && point.hit ? std::optional(*point.frame + *point.hit) : std::nullopt;
}

CostCurves::Bucket& CostCurves::bucket(PipelineKind pipeline, std::size_t at) {
    Bucket& found = m_curves[pipeline][stepOf(at)];
    found.at.push(static_cast<double>(at));
    return found;
}

void CostCurves::addFrame(PipelineKind pipeline, std::size_t at, double seconds) {
    bucket(pipeline, at).frames.push(seconds);
}

void CostCurves::addHit(PipelineKind pipeline, std::size_t at, double seconds) {
    bucket(pipeline, at).applied.push(seconds);
}

std::vector<CostPoint> CostCurves::points(PipelineKind pipeline) const {
    std::vector<CostPoint> points;
    const auto curve = m_curves.find(pipeline);
    if (curve != m_curves.end()) {
        for (const auto& [step, bucket] : curve->second) {
            points.push_back({mean(bucket.at), median(bucket.frames), median(bucket.applied)});
        }
    }
    return points;
}

std::optional<double> crossover(std::span<const CostPoint> a, std::span<const CostPoint> b, CostOf what) {
    const std::vector<Sample> ofA = samplesOf(a, what);
    const std::vector<Sample> ofB = samplesOf(b, what);
    if (ofA.empty() || ofB.empty()) {
        return std::nullopt;
    }
    const std::vector<double> numbers = commonNumbers(ofA, ofB);
    const auto excess = [&](double at) { return valueAt(ofA, at) - valueAt(ofB, at); };
    if (numbers.empty() || excess(numbers.back()) <= 0.0) {
        return std::nullopt;
    }
    // From the end: what a single slow frame did among few hits is no crossover.
    for (std::size_t i = numbers.size(); i-- > 0;) {
        const double here = excess(numbers[i]);
        if (here <= 0.0) {
            const double next = excess(numbers[i + 1]);
            return numbers[i] + (numbers[i + 1] - numbers[i]) * (-here / (next - here));
        }
    }
    return numbers.front();
}

}  // namespace hitscope
