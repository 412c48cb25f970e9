// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace hitscope {

/// Where hitscope-import is: setImportWorkerPath(), HITSCOPE_IMPORT_WORKER in the environment, beside the
/// running program, in ../libexec/hitscope or in ../bin, in this order; empty when it is in none of them.
[[nodiscard]] QString importWorkerPath();

}  // namespace hitscope
