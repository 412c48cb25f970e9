// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QIcon>
#include <QMessageBox>
#include <QStandardPaths>
#include <QStringList>

#include "models/plain_text.h"

namespace hitscope {

namespace {

struct DialogTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::dialogs)
};

}  // namespace

QString existingFolder(const QString& remembered) {
    for (const QString& folder :
         {remembered, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}) {
        if (!folder.isEmpty() && QFileInfo(folder).isDir()) {
            return folder;
        }
    }
    return QDir::homePath();
}

QMessageBox* makeErrorBox(QWidget* parent, const Error& error, QMessageBox::StandardButton button) {
    // Qt writes the display name after any other title.
    auto* box = new QMessageBox(QMessageBox::Warning, QGuiApplication::applicationDisplayName(),
                                QString::fromStdString(error.what), button, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    QStringList more;
    for (const std::string& part : {error.where, error.advice}) {
        if (!part.empty()) {
            more.append(QString::fromStdString(part));
        }
    }
    // Its format is not that of the first text.
    box->setInformativeText(asPlainText(more.join(QStringLiteral("\n\n"))));
    return box;
}

void showError(QWidget* parent, const Error& error) {
    makeErrorBox(parent, error, QMessageBox::Ok)->open();
}

void showAbout(QWidget* parent, const QString& renderer, const QString& version, const QString& exactness) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, DialogTexts::tr("About Hitscope"), {},
                                QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setIconPixmap(QIcon(QStringLiteral(":/icons/hitscope.svg")).pixmap(64, 64));
    box->setText(
        DialogTexts::tr("<h3>Hitscope %1</h3><p>Shoot a mesh, see exactly what moved, save the result.</p>")
            .arg(QStringLiteral(HITSCOPE_VERSION)));
    box->setInformativeText(
        DialogTexts::tr(
            "<p>The deformation is that of “Real-time polygon mesh deformation” by Alessio Quercia.</p>"
            "<p>Renderer: %1<br>OpenGL: %2<br>Deformation: %3<br>Qt: %4</p>"
            "<p>Free software under the GNU General Public License, version 3 or later.</p>")
            .arg(renderer.toHtmlEscaped(), version.toHtmlEscaped(), exactness.toHtmlEscaped(),
                 QString::fromLatin1(qVersion())));
    box->open();
}

}  // namespace hitscope
