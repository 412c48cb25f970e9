// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grouped.h"

namespace hitscope {

std::string grouped(std::uint64_t number) {
    constexpr std::size_t kDigits = 3;
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > kDigits;) {
        at -= kDigits;
        text.insert(at, 1, ',');
    }
    return text;
}

}  // namespace hitscope
