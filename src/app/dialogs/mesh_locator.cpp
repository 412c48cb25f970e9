// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/mesh_locator.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "app/session_files.h"
#include "io/import.h"

namespace hitscope {

MeshLocator::MeshLocator(SessionFiles& files, QWidget& window)
    : QObject(&window), m_files(files), m_window(window) {
    connect(&files, &SessionFiles::troubled, this, &MeshLocator::ask);
}

void MeshLocator::ask() {
    const std::vector<MeshTrouble>& troubles = m_files.troubles();
    const auto missing = std::find_if(troubles.begin(), troubles.end(), [](const MeshTrouble& trouble) {
        return trouble.kind == MeshTrouble::Kind::Missing;
    });
    QStringList lines;
    for (const MeshTrouble& trouble : troubles) {
        lines << QString::fromStdString(trouble.error.message());
    }
    constexpr int kMost = 5;
    const qsizetype more = lines.size() - kMost;
    lines = lines.mid(0, kMost);
    if (more > 0) {
        lines << tr("and %n more", nullptr, static_cast<int>(more));
    }
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Meshes of This Session"), lines.join(u'\n'),
                                QMessageBox::NoButton, &m_window);
    box->setObjectName(QStringLiteral("meshTroubles"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    const QPushButton* locate = nullptr;
    const QString path = missing != troubles.end() ? missing->path : QString();
    if (!path.isEmpty()) {
        locate = box->addButton(tr("&Locate…"), QMessageBox::ActionRole);
    }
    const QPushButton* open =
        box->addButton(path.isEmpty() ? tr("&Open") : tr("Open &Without"), QMessageBox::AcceptRole);
    box->setDefaultButton(box->addButton(QMessageBox::Cancel));
    connect(box, &QDialog::finished, this, [this, box, locate, open, path] {
        if (locate != nullptr && box->clickedButton() == locate) {
            // By a dialog with an event loop of its own, in which the box may be deleted: after the box's own
            // code.
            QMetaObject::invokeMethod(
                this, [this, path] { this->locate(path); }, Qt::QueuedConnection);
        } else if (box->clickedButton() == open) {
            m_files.goOn();
        } else {
            m_files.cancel();
            Q_EMIT m_files.cancelled();
        }
    });
    box->open();
}

void MeshLocator::locate(const QString& missing) {
    const QString found = QFileDialog::getOpenFileName(
        &m_window, tr("Locate %1").arg(QFileInfo(missing).fileName()), {},
        importNameFilters().join(QStringLiteral(";;")) + QStringLiteral(";;") + tr("All files (*)"));
    if (found.isEmpty()) {
        ask();
    } else {
        m_files.lookAgain(missing, found);
    }
}

}  // namespace hitscope
