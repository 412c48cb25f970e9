// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "usage/usage.h"

namespace hitscope {

/// What `PROGRAM VERB --help` prints: usage, description, each option with its default, examples, exit
/// statuses. Lines of 80 characters where words allow.
[[nodiscard]] QString helpText(const ProgramUsage& program, const Usage& verb);
/// What `PROGRAM --help` prints: the verbs, a line each.
[[nodiscard]] QString helpText(const ProgramUsage& program);

}  // namespace hitscope
