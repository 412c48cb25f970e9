// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/fields/save_name.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "models/plain_text.h"

namespace hitscope {

namespace {

struct SaveNameTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::SaveName)
};

QString withSuffix(const QString& path, const QString& filter, const SaveName& wish) {
    if (wish.suffixes.isEmpty() || wish.suffixes.contains(QFileInfo(path).suffix(), Qt::CaseInsensitive)) {
        return path;
    }
    return path + u'.' + wish.suffixes.value(wish.filters.indexOf(filter), wish.suffixes.constFirst());
}

bool mayReplace(QWidget* parent, const QString& path, const SaveName& wish) {
    if (!QFileInfo::exists(path)) {
        return true;
    }
    QMessageBox box(
        QMessageBox::Warning, wish.title,
        SaveNameTexts::tr("%1 already exists. Do you want to replace it?").arg(QFileInfo(path).fileName()),
        QMessageBox::Cancel, parent);
    box.setObjectName(QStringLiteral("replaceFile"));
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(wish.consequence ? asPlainText(wish.consequence(path)) : QString());
    const QPushButton* replace = box.addButton(SaveNameTexts::tr("&Replace"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == replace;
}

}  // namespace

QString askSaveName(QWidget* parent, const SaveName& wish) {
    QFileDialog dialog(parent, wish.title);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(wish.filters);
    dialog.setOption(QFileDialog::DontConfirmOverwrite);  // it would ask about the name without suffix
    if (QFileInfo(wish.suggested).isAbsolute()) {
        dialog.setDirectory(QFileInfo(wish.suggested).absolutePath());
    }
    dialog.selectFile(wish.suggested);
    while (dialog.exec() == QDialog::Accepted) {
        const QString path =
            withSuffix(dialog.selectedFiles().constFirst(), dialog.selectedNameFilter(), wish);
        if (mayReplace(parent, path, wish)) {
            return path;
        }
    }
    return {};
}

}  // namespace hitscope
