// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "usage/usage.h"

namespace hitscope {

/// The program's page of section 1, as man(7) has it.
[[nodiscard]] QString manPage(const ProgramUsage& program, const QString& version);

}  // namespace hitscope
