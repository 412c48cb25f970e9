// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"

namespace hitscope {

/// What can be said about a path before anything reads it: there is a regular, readable, non-empty file with
/// a known suffix. Pipes, devices and folders are refused (opening them could wait for ever).
[[nodiscard]] Status checkImportable(const QString& path);

}  // namespace hitscope
