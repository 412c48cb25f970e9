// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include "core/result.h"

class QImage;

namespace hitscope {

/// Whether a text is a session's, as session files have it.
[[nodiscard]] bool isSessionText(const QByteArray& text);

/// The suffix of files of the format that a text's first lines are in: "obj", "ply", "off" or "stl"; empty:
/// it is no mesh's.
[[nodiscard]] QString meshSuffixOf(const QByteArray& text);

/// Writes what was pasted to a file of its own that stays, since sessions refer to it: beneath the program's
/// data, under a name that follows from the content. Returns its path.
[[nodiscard]] Result<QString> keepPasted(const QByteArray& content, const QString& suffix);
[[nodiscard]] Result<QString> keepPasted(const QImage& picture);

}  // namespace hitscope
