// SPDX-License-Identifier: GPL-3.0-or-later
// Where a session is saved to, and what is asked before a file is replaced or changes are lost.
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <vector>

#include "app/actions/file_actions.h"
#include "app/dialogs/dialogs.h"
#include "app/notice_bar.h"
#include "app/session_files.h"
#include "app/settings/app_settings.h"
#include "document/session_file.h"
#include "panels/fields/save_name.h"

namespace hitscope {

bool FileActions::save() {
    if (m_parts.sessions.path().isEmpty()) {
        return saveAs();
    }
    if (m_parts.sessions.isChangedByOthers()) {
        return askAndReplace();
    }
    m_parts.sessions.save(m_parts.sessions.path());
    return true;
}

/// For when somebody else saves to it.
void FileActions::watchFile() {
    connect(&m_parts.sessions, &SessionFiles::changed, this, [this] {
        const QString& path = m_parts.sessions.path();
        m_watch.follow(path.isEmpty() ? std::vector<MeshFile>() : std::vector<MeshFile>{{.path = path}});
    });
    // The file has its new name some time before the end of the save is told.
    connect(&m_parts.sessions, &SessionFiles::writing, &m_watch, &FileWatch::hold);
    connect(&m_parts.sessions, &SessionFiles::written, &m_watch, &FileWatch::release);
    connect(&m_parts.sessions, &SessionFiles::notSaved, this, &FileActions::offerElsewhere);
    connect(&m_watch, &FileWatch::changed, this, &FileActions::tellChanged);
}

void FileActions::tellChanged() {
    m_parts.notice.say(
        tr("%1 was changed by another program or window.").arg(QFileInfo(m_parts.sessions.path()).fileName()),
        tr("Open It Again"), [this] {
            if (m_parts.sessions.isModified()) {
                askAndRevert();
            } else {
                m_parts.sessions.open(m_parts.sessions.path());
            }
        });
}

/// Somebody else has saved to the session's file.
bool FileActions::askAndReplace() {
    QMessageBox box(
        QMessageBox::Warning, tr("Save Session"),
        tr("%1 was changed by another program or window since it was opened or saved here. Saving "
           "replaces those changes.")
            .arg(QFileInfo(m_parts.sessions.path()).fileName()),
        QMessageBox::Cancel, &m_parts.window);
    box.setObjectName(QStringLiteral("replaceSession"));
    box.setTextFormat(Qt::PlainText);
    const QPushButton* replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
    const QPushButton* elsewhere = box.addButton(tr("Save &As…"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    if (box.clickedButton() == replace) {
        m_parts.sessions.save(m_parts.sessions.path());
        return true;
    }
    return box.clickedButton() == elsewhere && saveAs();
}

/// The folder may be gone, or full, or another's.
void FileActions::offerElsewhere(const Error& error) {
    QMessageBox* box = makeErrorBox(&m_parts.window, error, QMessageBox::Close);
    box->setObjectName(QStringLiteral("notSaved"));
    QPushButton* elsewhere = box->addButton(tr("Save &As…"), QMessageBox::AcceptRole);
    box->setDefaultButton(elsewhere);
    connect(elsewhere, &QPushButton::clicked, this, &FileActions::saveAs);
    box->open();
}

bool FileActions::saveAs() {
    const QString suffix = QString::fromLatin1(kSessionSuffix);
    QString name = m_parts.sessions.path();
    if (name.isEmpty()) {
        const QString scene = m_parts.session.sceneName().replace(u'/', u'_');
        name = QDir(existingFolder(m_parts.settings.folder))
                   .filePath((scene.isEmpty() ? tr("session") : scene) + suffix);
    }
    const QString path = askSaveName(&m_parts.window, {.title = tr("Save Session"),
                                                       .suggested = name,
                                                       .filters = {sessionsFilter()},
                                                       .suffixes = {suffix.mid(1)}});
    if (path.isEmpty()) {
        return false;
    }
    m_parts.sessions.save(path);
    return true;
}

void FileActions::askAndRevert() {
    auto* box = new QMessageBox(QMessageBox::Question, tr("Revert to Saved"),
                                tr("Go back to %1 as it was saved? All changes since are lost.")
                                    .arg(QFileInfo(m_parts.sessions.path()).fileName()),
                                QMessageBox::Cancel, &m_parts.window);
    box->setObjectName(QStringLiteral("revert"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    const QPushButton* revert = box->addButton(tr("&Revert"), QMessageBox::DestructiveRole);
    box->setDefaultButton(QMessageBox::Cancel);
    connect(revert, &QPushButton::clicked, this, [this] { m_parts.sessions.open(m_parts.sessions.path()); });
    box->open();
}

}  // namespace hitscope
