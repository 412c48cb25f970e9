// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QString>

#include "core/result.h"

namespace hitscope {

/// Where a file dialog starts: the folder `remembered`, the documents or the home, the first of them that
/// exists. A dialog would take a folder that does not exist for the name of a file.
[[nodiscard]] QString existingFolder(const QString& remembered);

/// A message box that says what, where and what to do. It belongs to `parent`, and goes when it is closed.
[[nodiscard]] QMessageBox* makeErrorBox(QWidget* parent, const Error& error,
                                        QMessageBox::StandardButton button);
/// Shows one, and returns at once.
void showError(QWidget* parent, const Error& error);

/// Version, licence, and what draws. `renderer` and `version` as the viewport knows them; may be empty, as
/// may `exactness`, which is verdictText() of the renderer's verdict.
void showAbout(QWidget* parent, const QString& renderer, const QString& version, const QString& exactness);

}  // namespace hitscope
