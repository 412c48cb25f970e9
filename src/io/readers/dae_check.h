// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/result.h"

namespace hitscope {

/// Reads a COLLADA file's XML alone, and refuses what would take time and memory out of all proportion: nodes
/// that instance nodes that instance nodes, and so make more of them than fit into memory, or never end.
[[nodiscard]] Status checkDae(std::string_view file);

}  // namespace hitscope
