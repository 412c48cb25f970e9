// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/worker_failure.h"

#include <csignal>

namespace hitscope {

Error describeWorkerEnd(const WorkerEnd& end, const QString& path, const ImportLimits& limits) {
    const std::string where = path.toStdString();
    if (end.timedOut || (end.crashed && end.code == SIGXCPU)) {
        return {"Reading the file took longer than " + std::to_string(limits.seconds) +
                    " seconds and was stopped.",
                where,
                "It may be damaged, or very large. Try opening and saving it with another program, or as "
                "binary PLY."};
    }
    if (end.crashed && end.code == SIGKILL) {
        return {"The system stopped reading the file, probably because memory ran out.", where,
                "Close other programs, or open a smaller mesh."};
    }
    if (end.crashed && end.code == SIGXFSZ) {
        return {"The mesh takes more room than what is read may take.", where,
                "The file may be damaged; otherwise split it, or open a smaller mesh."};
    }
    if (end.crashed) {
        return {"The file makes the reader crash; it is probably damaged.", where,
                "Try opening and saving it with another program."};
    }
    return {"The import worker gave no usable answer (exit status " + std::to_string(end.code) + ").", where,
            "If this happens with every file, install Hitscope again."};
}

}  // namespace hitscope
