// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"

namespace hitscope::bench {

// What other libraries need to read a file, to measure against: parsed and thrown away.
[[nodiscard]] Status readWithTinyObjLoader(const QString& path);  ///< with its usual settings
[[nodiscard]] Status readWithAssimp(const QString& path);         ///< without any post-processing
/// As cp and sync do.
[[nodiscard]] Status copyAndSync(const QString& from, const QString& to);

}  // namespace hitscope::bench
