// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "usage/invocation.h"

namespace hitscope::bench {

// Values of options as the benchmarks take them. What is wrong with one is said by Invocation::complain(),
// and the least is returned.

/// "8K" is 8000, "10M" 10,000,000, "250" 250; nothing if it is none of these or does not fit an int.
[[nodiscard]] std::optional<int> parseCount(const QString& text);

/// "250", "8K"
[[nodiscard]] int takeCount(Invocation& given, const char* name, int least, int most);
/// "8K,1M,250": from least to most, in the order given, each once.
[[nodiscard]] std::vector<int> takeCounts(Invocation& given, const char* name, int least, int most);
/// "320x180", each side from 16 to 8192 pixels.
struct Size {
    int width = 16;
    int height = 16;
};
[[nodiscard]] Size takeSize(Invocation& given, const char* name);
/// Of UsageOption::Takes::Words, those that are given, each once.
[[nodiscard]] QStringList takeWords(Invocation& given, const char* name);

}  // namespace hitscope::bench
