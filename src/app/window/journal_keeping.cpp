// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/journal_keeping.h"

#include "app/journal_picture.h"
#include "app/session_files.h"
#include "app/window/window_view.h"
#include "document/journal_files.h"
#include "document/session_journal.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kPatience = 2'000;   // milliseconds
constexpr int kLookAgain = 1'000;  // milliseconds

}  // namespace

JournalKeeping::JournalKeeping(Session& session, SessionFiles& files, WindowView& view, Viewport& viewport,
                               QObject* parent)
    : QObject(parent),
      m_files(files),
      m_journal(new SessionJournal(session, view.functions().capture, journalFolder(), this)) {
    new JournalPicture(viewport, *m_journal, this);
    connect(&files, &SessionFiles::saved, this, &JournalKeeping::takeSaved);
    connect(&files, &SessionFiles::opened, this, &JournalKeeping::takeOpened);
    connect(&files, &SessionFiles::changed, this, &JournalKeeping::noteFile);
    connect(m_journal, &SessionJournal::begun, this, [this] {
        m_file.clear();  // a new journal says nothing of it yet
        noteFile();
    });
    connect(&files, &SessionFiles::left, this, &JournalKeeping::finish);
    m_untilKept.setInterval(kLookAgain);
    connect(&m_untilKept, &QTimer::timeout, this, &JournalKeeping::lookWhetherKept);
    connect(&viewport, &Viewport::optionsChanged, m_journal, &SessionJournal::viewChanged);
    connect(&m_journal->writer(), &JournalWriter::failed, this, [this](const Error& error) {
        Q_EMIT noticeWanted(tr("Changes are not kept for recovery: %1 Save often.")
                                .arg(QString::fromStdString(error.message())));
    });
}

void JournalKeeping::viewChanged() {
    m_journal->viewChanged();
}

void JournalKeeping::flush() {
    m_journal->flush();
}

void JournalKeeping::finish() {
    m_journal->finish();
    tellKept();
}

/// Undone or redone until it is as its file has it, there is nothing to recover.
bool JournalKeeping::isAsSaved() const {
    return m_journal->isBegun() && !m_files.path().isEmpty() && !m_files.isModified();
}

void JournalKeeping::noteFile() {
    if (isAsSaved()) {
        // What else follows the same change may note it down after this.
        QMetaObject::invokeMethod(
            this,
            [this] {
                if (isAsSaved()) {
                    finish();
                }
            },
            Qt::QueuedConnection);
    }
    if (m_journal->isBegun() && m_files.path() != m_file) {
        m_file = m_files.path();
        m_journal->writer().setFile(m_file);
    }
}

void JournalKeeping::takeSaved() {
    if (!m_files.isModified()) {  // meanwhile
        finish();
    }
}

void JournalKeeping::takeOpened(const QString& path) {
    if (!path.isEmpty()) {
        finish();
        return;
    }
    m_journal->keep();
    m_wanted = m_journal->writer().handedOver();
    m_untilKept.start();
    m_journal->writer().wait(kPatience);
    // Those who are told that it was opened come first.
    QMetaObject::invokeMethod(this, &JournalKeeping::lookWhetherKept, Qt::QueuedConnection);
}

void JournalKeeping::lookWhetherKept() {
    if (m_journal->writer().isKept(m_wanted)) {
        tellKept();
    }
}

void JournalKeeping::tellKept() {
    if (m_untilKept.isActive()) {
        m_untilKept.stop();
        Q_EMIT recoveredKept();
    }
}

}  // namespace hitscope
