// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace hitscope::bench {

/// hitscope-cli bench WHAT [options]; the program's name first. Returns the exit status.
int benchCommand(QStringList arguments);

// One benchmark each; `arguments` without WHAT.
int paperCommand(const QStringList& arguments);
int frameCommand(const QStringList& arguments);
int modesCommand(const QStringList& arguments);
int hitCommand(const QStringList& arguments);
int physicsCommand(const QStringList& arguments);
int sessionCommand(const QStringList& arguments);
int ioCommand(const QStringList& arguments);
int checkCommand(const QStringList& arguments);

}  // namespace hitscope::bench
