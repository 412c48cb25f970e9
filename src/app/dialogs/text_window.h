// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QPlainTextEdit;

namespace hitscope {

/// A window with a page of plain text that can be copied with one button and, where it has a file's name,
/// saved.
class TextWindow : public QDialog {
    Q_OBJECT
public:
    TextWindow(const QString& title, const QString& text, QWidget* parent);

    [[nodiscard]] QString text() const;
    /// Adds a button that saves the text; `name` is what the file is called at first.
    void offerSaving(const QString& name);
    /// Writes the text there, whole or not at all; trouble is shown.
    void saveTo(const QString& path);

private:
    QPlainTextEdit* m_text = nullptr;
    QWidget* m_buttons = nullptr;
};

}  // namespace hitscope
