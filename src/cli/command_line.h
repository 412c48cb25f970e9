// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "core/result.h"

class QCommandLineParser;

namespace hitscope::cli {

inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// Says on the standard error what is wrong with the arguments; returns kWrongUsage.
int wrongUsage(const QString& text);
/// The exit status; an error goes to the standard error.
int finish(const Status& status);
/// Reads a command's arguments, the program's name first. A status where there is nothing more to do: help
/// was asked for and printed, or the arguments are wrong and it was said.
std::optional<int> parse(QCommandLineParser& parser, const QString& command, const QStringList& arguments);
/// The parser's help, with the command in its usage line.
QString helpText(const QCommandLineParser& parser, const QString& command);
/// To be called at the very end: says if what was printed could not be written, and gives the exit status.
int flushOutput(int status);

}  // namespace hitscope::cli
