// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace hitscope {

/// Asked by work that can go on later, between parts that take well under a millisecond: whether it shall
/// stop here. Empty: it never shall.
using IsTimeUp = std::function<bool()>;

}  // namespace hitscope
