// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace hitscope {

/// What a dialog asks that is to save a file.
struct SaveName {
    QString title;
    QString suggested;    ///< a name, or a path
    QStringList filters;  ///< "JSON (*.json)"; the first is chosen
    /// Of each filter: "json". A name with none of them gets the chosen filter's; further ones are taken,
    /// too.
    QStringList suffixes;
    /// What comes of replacing an existing file of that path, a sentence; empty: nothing that is not plain.
    std::function<QString(const QString& path)> consequence = {};
};

/// The path that was chosen, with its suffix. A file that exists is named in a question before, with the
/// suffix that was added. Empty: none was chosen.
[[nodiscard]] QString askSaveName(QWidget* parent, const SaveName& wish);

}  // namespace hitscope
