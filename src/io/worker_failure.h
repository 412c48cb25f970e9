// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"
#include "io/import.h"

namespace hitscope {

/// How an import worker came to its end without saying why.
struct WorkerEnd {
    bool crashed = false;  ///< ended by a signal
    int code = 0;          ///< exit status, or the signal's number
    bool timedOut = false;
};

/// The same in words for the person.
[[nodiscard]] Error describeWorkerEnd(const WorkerEnd& end, const QString& path, const ImportLimits& limits);

}  // namespace hitscope
