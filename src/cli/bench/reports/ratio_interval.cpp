// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/reports/ratio_interval.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hitscope::bench {

namespace {

constexpr std::size_t kMostExact = 2500;  // quotients
constexpr std::size_t kMostRuns = 1000;

std::vector<double> thinned(std::span<const double> runs) {
    if (runs.size() <= kMostRuns) {
        return {runs.begin(), runs.end()};
    }
    std::vector<double> kept;
    for (std::size_t i = 0; i < kMostRuns; ++i) {
        kept.push_back(runs[i * runs.size() / kMostRuns]);
    }
    return kept;
}

/// How many of the orders of n + m different numbers have each value of Mann and Whitney's U, from 0 to n m;
/// over all orders. The generating function is the Gaussian binomial coefficient.
std::vector<double> distributionOfU(std::size_t n, std::size_t m) {
    std::vector<double> counts(n * m + 1, 0.0);
    counts[0] = 1.0;
    double orders = 1.0;
    for (std::size_t i = 1; i <= n; ++i) {
        for (std::size_t u = counts.size(); u-- > m + i;) {
            counts[u] -= counts[u - m - i];
        }
        for (std::size_t u = i; u < counts.size(); ++u) {
            counts[u] += counts[u - i];
        }
        orders *= static_cast<double>(m + i) / static_cast<double>(i);
    }
    for (double& count : counts) {
        count /= orders;
    }
    return counts;
}

/// The x that a normal variable exceeds with this probability, by bisection.
double normalQuantile(double above) {
    double low = 0.0;
    double high = 40.0;
    constexpr int kSteps = 80;
    for (int step = 0; step < kSteps; ++step) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(middle / std::sqrt(2.0)) > above ? low : high) = middle;
    }
    return low;
}

/// How many of the quotients lie outside at either end; 0: too few runs.
std::size_t quotientsOutside(std::size_t n, std::size_t m, double confidence) {
    const double tail = 0.5 * (1.0 - confidence);
    if (n * m <= kMostExact) {
        const std::vector<double> distribution = distributionOfU(n, m);
        double below = 0.0;
        std::size_t outside = 0;
        while (outside < distribution.size() && below + distribution[outside] <= tail) {
            below += distribution[outside++];
        }
        return outside;
    }
    const auto a = static_cast<double>(n);
    const auto b = static_cast<double>(m);
    const double deviation = std::sqrt(a * b * (a + b + 1.0) / 12.0);
    return static_cast<std::size_t>(std::max(0.0, 0.5 * a * b - normalQuantile(tail) * deviation));
}

}  // namespace

RatioInterval ratioInterval(std::span<const double> a, std::span<const double> b, double confidence) {
    const std::vector<double> below = thinned(a);
    const std::vector<double> above = thinned(b);
    std::vector<double> quotients;
    quotients.reserve(below.size() * above.size());
    for (const double over : above) {
        for (const double under : below) {
            quotients.push_back(over / under);
        }
    }
    std::sort(quotients.begin(), quotients.end());
    const std::size_t count = quotients.size();
    RatioInterval interval;
    interval.ratio = 0.5 * (quotients[(count - 1) / 2] + quotients[count / 2]);
    const std::size_t outside = quotientsOutside(below.size(), above.size(), confidence);
    if (outside > 0 && 2 * outside < count) {
        interval.low = quotients[outside - 1];
        interval.high = quotients[count - outside];
    }
    return interval;
}

}  // namespace hitscope::bench
