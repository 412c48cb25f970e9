// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace hitscope {

/// What a set of values amounts to.
struct Summary {
    std::size_t count = 0;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double sum = 0.0;
    double sumOfSquares = 0.0;

    void add(double value) {
        ++count;
        low = std::min(low, value);
        high = std::max(high, value);
        sum += value;
        sumOfSquares += value * value;
    }
    void add(const Summary& other) {
        count += other.count;
        low = std::min(low, other.low);
        high = std::max(high, other.high);
        sum += other.sum;
        sumOfSquares += other.sumOfSquares;
    }
    [[nodiscard]] double rootMeanSquare() const {
        return count == 0 ? 0.0 : std::sqrt(sumOfSquares / static_cast<double>(count));
    }
    bool operator==(const Summary&) const = default;
};

/// Summaries of parts, and of all of them: a part that changes costs the logarithm of how many there are, so
/// that the greatest value is known at once even when what had it is gone.
class SummaryTree {
public:
    explicit SummaryTree(std::size_t parts)
        : m_parts(std::max<std::size_t>(parts, 1)), m_nodes(2 * m_parts) {}

    void set(std::size_t part, const Summary& summary) {
        std::size_t node = part + m_parts;
        m_nodes[node] = summary;
        for (node /= 2; node > 0; node /= 2) {
            m_nodes[node] = m_nodes[2 * node];
            m_nodes[node].add(m_nodes[2 * node + 1]);
        }
    }
    [[nodiscard]] const Summary& part(std::size_t part) const { return m_nodes[part + m_parts]; }
    [[nodiscard]] const Summary& all() const { return m_nodes[1]; }

private:
    std::size_t m_parts;
    std::vector<Summary> m_nodes;  ///< a binary tree, the root at 1, the parts at the end
};

}  // namespace hitscope
