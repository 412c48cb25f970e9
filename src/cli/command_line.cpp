// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.h"

#include <QTextStream>

namespace hitscope::cli {

int wrongUsage(const QString& text) {
    QTextStream(stderr) << "hitscope-cli: " << text << "\n"
                        << "Run hitscope-cli --help for what it can do.\n";
    return kWrongUsage;
}

int finish(const Status& status) {
    if (!status) {
        QTextStream(stderr) << "hitscope-cli: " << QString::fromStdString(status.error().message()) << "\n";
        return kFailed;
    }
    return 0;
}

}  // namespace hitscope::cli
