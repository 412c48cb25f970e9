// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/text_window.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QDir>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

#include "app/dialogs/dialogs.h"
#include "io/staged_files.h"
#include "panels/fields/save_name.h"

namespace hitscope {

namespace {

constexpr double kOfScreen = 0.9;

/// Large enough for the text where the screen is.
QSize sizeFor(const QPlainTextEdit& edit, const QSize& screen) {
    int widest = 0;
    const QStringList lines = edit.toPlainText().split(u'\n');
    for (const QString& line : lines) {
        widest = std::max(widest, edit.fontMetrics().horizontalAdvance(line));
    }
    const int frame = 6 * edit.fontMetrics().height();
    const QSize wanted(widest + frame,
                       static_cast<int>(lines.size()) * edit.fontMetrics().lineSpacing() + 2 * frame);
    return wanted.boundedTo((QSizeF(screen) * kOfScreen).toSize());
}

}  // namespace

TextWindow::TextWindow(const QString& title, const QString& text, QWidget* parent) : QDialog(parent) {
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    m_text = new QPlainTextEdit(text, this);
    m_text->setObjectName(QStringLiteral("text"));
    m_text->setReadOnly(true);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    layout->addWidget(m_text);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("copy"));
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(m_text->toPlainText()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_buttons = buttons;
    layout->addWidget(buttons);
    resize(sizeFor(*m_text, screen()->availableSize()));
    copy->setFocus();
}

QString TextWindow::text() const {
    return m_text->toPlainText();
}

void TextWindow::offerSaving(const QString& name) {
    auto* buttons = static_cast<QDialogButtonBox*>(m_buttons);
    QPushButton* save = buttons->addButton(tr("&Save As…"), QDialogButtonBox::ActionRole);
    save->setObjectName(QStringLiteral("save"));
    connect(save, &QPushButton::clicked, this, [this, name] {
        const QString path = askSaveName(this, {.title = windowTitle(),
                                                .suggested = QDir::home().filePath(name),
                                                .filters = {tr("Text files (*.txt)")},
                                                .suffixes = {QStringLiteral("txt")}});
        if (!path.isEmpty()) {
            saveTo(path);
        }
    });
}

void TextWindow::saveTo(const QString& path) {
    if (const Status status = writeWhole(path, text().toStdString()); !status) {
        showError(this, status.error());
    }
}

}  // namespace hitscope
