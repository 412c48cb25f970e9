// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session_collector.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QPointer>
#include <atomic>
#include <utility>

#include "analysis/beside.h"
#include "app/actions/menu_building.h"
#include "app/session_files.h"
#include "document/collect_session.h"
#include "document/session_file.h"
#include "session/session.h"
#include "session/task_list.h"

namespace hitscope {

namespace {

constexpr int kMostNotes = 5;  // that a notice has room for

}  // namespace

/// The other thread holds on to it too.
struct SessionCollector::Work {
    QString folder;
    QString name;  ///< of the session's file
    SessionDocument document;
    MeshesByPath meshes;
    std::atomic<bool> cancelled = false;
    Result<QStringList> notes = QStringList();
};

SessionCollector::SessionCollector(Session& session, const SessionFiles& files,
                                   std::function<CapturedView()> view, QWidget& window)
    : QObject(&window), m_session(session), m_files(files), m_view(std::move(view)), m_window(window) {}

/// What is being written is finished: the application waits for it when it ends (backgroundPool()).
SessionCollector::~SessionCollector() {
    giveUp();
}

void SessionCollector::fill(QMenu& menu) {
    QAction* action = addAction(menu, tr("Co&llect for Sharing…"), {}, this, [this] { choose(); });
    action->setStatusTip(tr("Put the session, its meshes and textures into one folder"));
}

QString SessionCollector::nameOfSession() const {
    if (!m_files.path().isEmpty()) {
        return QFileInfo(m_files.path()).fileName();
    }
    const QString scene = m_session.sceneName().replace(u'/', u'_');
    return (scene.isEmpty() ? tr("session") : scene) + QLatin1String(kSessionSuffix);
}

/// Beside the session, and not there yet.
QString SessionCollector::proposedFolder() const {
    const QDir beside = m_files.path().isEmpty() ? QDir::home() : QFileInfo(m_files.path()).dir();
    const QString name = QFileInfo(nameOfSession()).completeBaseName();
    QString folder = beside.filePath(name);
    for (int number = 2; QFileInfo::exists(folder); ++number) {
        folder = beside.filePath(QStringLiteral("%1 %2").arg(name, QString::number(number)));
    }
    return folder;
}

void SessionCollector::choose() {
    QFileDialog dialog(&m_window, tr("Collect for sharing: a new folder"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setOption(QFileDialog::DontConfirmOverwrite);  // nothing is replaced
    dialog.setLabelText(QFileDialog::FileName, tr("Folder:"));
    dialog.setLabelText(QFileDialog::Accept, tr("Collect"));
    const QFileInfo proposed(proposedFolder());
    dialog.setDirectory(proposed.absolutePath());
    dialog.selectFile(proposed.fileName());
    if (dialog.exec() == QDialog::Accepted) {
        collect(dialog.selectedFiles().constFirst());
    }
}

void SessionCollector::collect(const QString& folder) {
    giveUp();
    const auto work = std::make_shared<Work>();
    work->folder = QFileInfo(folder).absoluteFilePath();
    work->name = nameOfSession();
    work->document = captureSession(m_session, m_view());
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        if (const auto* file = std::get_if<MeshFile>(&target->source)) {
            work->meshes[file->path] = target->shape.mesh;
        }
    }
    m_work = work;
    m_progress = std::make_unique<TaskProgress>(
        m_session.tasks(), tr("Collecting %1").arg(work->name),
        [work] { work->cancelled = true; },  // finish() knows whether that was in time
        tr("Cancel collecting; the folder stays as it was"));
    const auto report = [self = QPointer(this), work](double fraction, const QString& doing) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, work, fraction, doing] {
                if (SessionCollector* alive = self.data(); alive != nullptr) {
                    alive->say(*work, fraction, doing);
                }
            },
            Qt::QueuedConnection);
    };
    workBeside(
        this,
        [work, report] {
            work->notes = collectSession(std::move(work->document), work->meshes, work->folder, work->name,
                                         {report, &work->cancelled});
        },
        [work](SessionCollector& self, bool done) { self.finish(work, done); });
}

void SessionCollector::say(const Work& work, double fraction, const QString& doing) {
    if (&work == m_work.get()) {
        m_progress->say(doing);
        m_progress->report(fraction);
    }
}

void SessionCollector::giveUp() {
    if (m_work) {
        m_work->cancelled = true;
        m_work.reset();
        m_progress.reset();
    }
}

void SessionCollector::tellCollected(const QString& folder, const QStringList& notes) {
    const QString where = tr("Collected in %1").arg(QDir::toNativeSeparators(folder));
    Q_EMIT said(where);
    if (!notes.isEmpty()) {
        Q_EMIT noticeWanted((QStringList{where} + notes.mid(0, kMostNotes)).join(u'\n'));
    }
    Q_EMIT collected(folder, notes);
}

void SessionCollector::finish(const std::shared_ptr<Work>& work, bool done) {
    const bool isWritten = done && work->notes;
    if (work == m_work) {
        m_work.reset();
        m_progress.reset();
    } else if (!isWritten) {
        return;  // another has taken its place
    }
    if (work->cancelled && !isWritten) {
        Q_EMIT said(tr("Cancelled. Nothing was written."));
        Q_EMIT cancelled();
    } else if (!done) {
        Q_EMIT failed({"There is not enough memory to collect this session.", work->folder.toStdString(),
                       "Close other programs, and try again."});
    } else if (!work->notes) {
        Q_EMIT failed(work->notes.error());
    } else {
        tellCollected(work->folder, work->notes.value());
    }
}

}  // namespace hitscope
