// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "cli/command_line.h"

namespace hitscope::cli {

/// "mp4", "gif", "webm": what ffmpeg is asked to make.
[[nodiscard]] const QStringList& filmSuffixes();
[[nodiscard]] bool namesFilm(const QString& path);
/// Whether a film of such pictures (pixels) can be made: ffmpeg is here.
[[nodiscard]] Outcome checkFilm(int width, int height);
/// Makes a film of numbered pictures, whole or not at all. `first`: the first of them,
/// "…/turntable-0001.png".
[[nodiscard]] Outcome writeFilm(const QString& first, double rate, const QString& path);

}  // namespace hitscope::cli
