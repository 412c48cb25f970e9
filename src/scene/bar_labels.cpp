// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/bar_labels.h"

#include <algorithm>
#include <cmath>

#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kTicks = 6;         // at most, between the ends
constexpr int kMostDecimals = 6;  // as panels show numbers: quantityText()
constexpr int kMostDigits = 8;    // behind the point of one with an exponent

/// Texts that tell apart what differs by a step, and so many decimals more.
class LabelForm {
public:
    LabelForm(double low, double high, double step) {
        const auto magnitude = [](double value) { return static_cast<int>(std::floor(std::log10(value))); };
        m_decimals = std::max(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0);
        m_hasExponent = m_decimals >= kMostDecimals;
        m_digits = magnitude(std::max(std::abs(low), std::abs(high))) + m_decimals;
    }
    [[nodiscard]] QString text(double value, int more) const {
        if (!m_hasExponent) {
            return shownNumber(value, 'f', m_decimals + more);
        }
        return value == 0.0 ? shownNumber(value, 'f', 0)
                            : shownNumber(value, 'e', std::clamp(m_digits + more, 0, kMostDigits));
    }

private:
    int m_decimals = 0;
    int m_digits = 0;  ///< of the largest behind its first
    bool m_hasExponent = false;
};

}  // namespace

std::vector<BarLabel> barLabels(const ShownChange& change, double apart) {
    const auto low = static_cast<double>(change.range.low);
    const auto high = static_cast<double>(change.range.high);
    const bool counts = change.quantity == ChangeQuantity::HitCount;
    const double step = std::max(niceStep(low, high, kTicks), counts ? 1.0 : 0.0);
    const LabelForm form(low, high, step);
    const auto end = [&](double value) { return BarLabel{value, form.text(value, counts ? 0 : 1)}; };
    std::vector<BarLabel> labels{end(low), end(high)};
    const double least = apart * (high - low);
    for (double k = std::ceil(low / step); k * step <= high; ++k) {
        const double value = k == 0.0 ? 0.0 : k * step;
        if (value - low > least && high - value > least) {
            labels.push_back({value, form.text(value, 0)});
        }
    }
    return labels;
}

}  // namespace hitscope
