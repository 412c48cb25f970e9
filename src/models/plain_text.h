// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace hitscope {

/// For where Qt looks for markup, as in tooltips and the second text of message boxes: shown as it stands,
/// whatever names, paths and messages are in it. A text that Qt takes for plain stays as it is.
[[nodiscard]] QString asPlainText(const QString& text);

/// What an action or a button is called: its text without the "&" that marks a key, and without "…".
[[nodiscard]] QString withoutMarks(QString text);

}  // namespace hitscope
