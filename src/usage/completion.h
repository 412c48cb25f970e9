// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "usage/usage.h"

namespace hitscope {

/// "bash", "zsh", "fish".
[[nodiscard]] const QStringList& completionShells();
/// What that shell sources, so that it completes the program's verbs, options, words and files.
[[nodiscard]] QString completion(const ProgramUsage& program, const QString& shell);

}  // namespace hitscope
