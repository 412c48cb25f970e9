// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "io/import.h"

class QProcess;

namespace hitscope {

/// Starts the import worker: the open file `answer` as its standard input, which it writes to, and no other
/// descriptor of ours; of the environment what it needs to run; its files bounded whatever program it is. It
/// leads a group of processes of its own, and ends with the thread that starts it.
void startWorker(QProcess& process, const QString& worker, const QString& path, const ImportLimits& limits,
                 int answer);

/// Ends the worker `pid` and all that it has started, without waiting.
void endWorker(qint64 pid);

}  // namespace hitscope
