// SPDX-License-Identifier: GPL-3.0-or-later
// The window's session as a document: its title, and how it is looked at.
#include <QDir>
#include <QFileInfo>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/actions/camera_actions.h"
#include "app/actions/change_actions.h"
#include "app/actions/cut_actions.h"
#include "app/actions/display_actions.h"
#include "app/dialogs/mesh_locator.h"
#include "app/journal_picture.h"
#include "app/main_window.h"
#include "app/mesh_reloader.h"
#include "app/notice_bar.h"
#include "app/recovery_bar.h"
#include "app/reload_bar.h"
#include "app/session_collector.h"
#include "app/session_files.h"
#include "document/journal_files.h"
#include "document/session_journal.h"
#include "view/camera_text.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kJournalPatience = 2'000;  // milliseconds
constexpr int kEndsWithin = 4'000;       // milliseconds

}  // namespace

void MainWindow::connectSession() {
    connect(m_sessions, &SessionFiles::changed, this, &MainWindow::showTitle);
    m_journal = new SessionJournal(m_session, view().capture, journalFolder(), this);
    connect(m_sessions, &SessionFiles::saved, this, [this] {
        if (!m_sessions->isModified()) {  // meanwhile
            m_journal->finish();
        }
    });
    connect(m_sessions, &SessionFiles::opened, this, [this](const QString& path) {
        if (!path.isEmpty()) {
            m_journal->finish();
            return;
        }
        // What it was recovered from goes next.
        m_journal->flush();
        m_journal->writer().wait(kJournalPatience);
    });
    connect(m_sessions, &SessionFiles::cancelled, this,
            [this] { say(tr("Cancelled. The session is unchanged.")); });
    connect(m_sessions, &SessionFiles::differs, this, [this](const QStringList& targets) {
        m_notice->say(
            tr("Not as it was saved: %1. This renderer makes other positions of the same hits; Help > "
               "Graphics tells whether it is exact.")
                .arg(targets.mid(0, 5).join(QStringLiteral(", "))));
    });
    new MeshLocator(*m_sessions, *this);
    new JournalPicture(*m_viewport, *m_journal, this);
    connect(m_sessions, &SessionFiles::left, m_journal, &SessionJournal::finish);
    connect(&m_journal->writer(), &JournalWriter::failed, this, [this](const Error& error) {
        m_notice->say(tr("Changes are not kept for recovery: %1 Save often.")
                          .arg(QString::fromStdString(error.message())));
    });
    connect(m_recovery, &RecoveryBar::failed, this, &MainWindow::fail);
    connect(m_viewport, &Viewport::optionsChanged, m_journal, &SessionJournal::viewChanged);
    connectReloading();
}

/// Meshes whose files change while they are in use.
void MainWindow::connectReloading() {
    auto* reloader = new MeshReloader(m_session, this);
    auto* column = qobject_cast<QVBoxLayout*>(centralWidget()->layout());
    column->insertWidget(0, new ReloadBar(*reloader, this));
    connect(reloader, &MeshReloader::reloaded, this, [this](const QStringList& said) {
        m_journal->flush();  // the hits are on other targets: both together
        m_notice->say(said.join(u'\n'));
    });
    connect(reloader, &MeshReloader::failed, this, &MainWindow::fail);
    connect(reloader, &MeshReloader::cancelled, this,
            [this] { say(tr("Cancelled. The meshes are unchanged.")); });
}

void MainWindow::fillSharing(QMenu& menu) {
    auto* collector = new SessionCollector(m_session, *m_sessions, view().capture, *this);
    collector->fill(menu);
    connect(collector, &SessionCollector::collected, this,
            [this](const QString& folder, const QStringList& notes) {
                const QString where = tr("Collected in %1").arg(QDir::toNativeSeparators(folder));
                say(where);
                if (!notes.isEmpty()) {
                    m_notice->say((QStringList{where} + notes.mid(0, 5)).join(u'\n'));
                }
            });
    connect(collector, &SessionCollector::failed, this, &MainWindow::fail);
    connect(collector, &SessionCollector::cancelled, this,
            [this] { say(tr("Cancelled. Nothing was written.")); });
}

void MainWindow::offerRecovery() {
    m_recovery->look();
    // What ended a moment ago may still hold its journal.
    QTimer::singleShot(kEndsWithin, m_recovery, [this] { m_recovery->look(); });
}

void MainWindow::showTitle() {
    const QString file = QFileInfo(m_sessions->path()).fileName();
    setWindowTitle((file.isEmpty() ? m_session.sceneName() : file) + QStringLiteral("[*]"));
    setWindowModified(m_sessions->isModified());
}

SessionFiles::View MainWindow::view() {
    return {[this] {
                CapturedView view;
                view.cameras.current = m_cameraActions->currentCamera().toStdString();
                for (const QString& bookmark : m_cameraActions->bookmarks()) {
                    view.cameras.kept.push_back(bookmark.toStdString());
                }
                view.display = m_viewport->options();
                return view;
            },
            [this](const SessionDocument& document) { restoreView(document); }};
}

/// The theme, what is transparent and how well pictures are drawn stay the window's.
void MainWindow::restoreView(const SessionDocument& document) {
    DisplayOptions display = document.display;
    display.theme = m_viewport->options().theme;
    display.transparent = m_viewport->options().transparent;
    display.refine = m_viewport->options().refine;
    display.reduceInMotion = m_viewport->options().reduceInMotion;
    m_viewport->setOptions(display);
    m_display->follow();
    m_change->follow();
    CameraActions::Bookmarks bookmarks;
    const std::size_t kept = std::min(bookmarks.size(), document.cameras.kept.size());
    for (std::size_t i = 0; i < kept; ++i) {
        bookmarks[i] = QString::fromStdString(document.cameras.kept[i]);
    }
    m_cameraActions->setBookmarks(bookmarks);
    if (const Result<Camera> camera = parseCamera(document.cameras.current, m_viewport->camera())) {
        m_viewport->navigation().setCamera(camera.value(), Navigation::Arrival::AtOnce);
    }
}

}  // namespace hitscope
