// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/result.h"

namespace hitscope {

/// Reads the connections between an FBX file's models alone, binary or text, and refuses what would take time
/// and memory out of all proportion: models with several parents that have several parents, and so make more
/// nodes than fit into memory, or never end. What is broken otherwise is left to the reader.
[[nodiscard]] Status checkFbx(std::string_view file);

}  // namespace hitscope
