// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace hitscope {

/// "1,234,567": for reports, which are the same in every locale.
[[nodiscard]] std::string grouped(std::uint64_t number);

}  // namespace hitscope
