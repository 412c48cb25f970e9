// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"

namespace hitscope::cli {

inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// Says on the standard error what is wrong with the arguments; returns kWrongUsage.
int wrongUsage(const QString& text);
/// The exit status; an error goes to the standard error.
int finish(const Status& status);

}  // namespace hitscope::cli
