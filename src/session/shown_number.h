// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <cstddef>

namespace hitscope {

/// Numbers as people read them in the window: in the locale of the system, like those in its spin boxes.
/// Files, copied tables and the command line have decimal points everywhere and use none of these.

/// `format` and `precision` as in QLocale::toString(): shownNumber(0.25, 'f', 1) is "0.3", or "0,3".
[[nodiscard]] QString shownNumber(double value, char format = 'g', int precision = 6);
/// Likewise in a locale, such as copiedLocale().
[[nodiscard]] QString shownNumber(const QLocale& locale, double value, char format, int precision);

/// A number that people set, as they would write it: the shortest decimal that reads back as the same float,
/// "0.027", or "2e-09" beyond what is read easily.
[[nodiscard]] QString shownFloat(float value);

/// That of shownNumber() and shownCount().
[[nodiscard]] QLocale shownLocale();
/// That of numbers in text that is copied or printed: "7,938" and "0.25" everywhere.
[[nodiscard]] QLocale copiedLocale();

/// "7,938", grouped as the locale does.
[[nodiscard]] QString shownCount(std::size_t count);

/// For tr(): "%Ln {hit|hits}" says "1 hit" and "7,938 hits". English has no translation that could tell one
/// from several, so every program reads its texts through this.
[[nodiscard]] QString inEnglish(const QString& text, int number);
/// A count for tr(), which takes no greater number.
[[nodiscard]] int trCount(std::size_t count);

/// Between numbers in a row: ", ", or "; " where a comma stands for the decimal point.
[[nodiscard]] QString numberSeparator();

}  // namespace hitscope
