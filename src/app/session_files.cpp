// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session_files.h"

#include <QDateTime>
#include <QFileInfo>
#include <QPointer>
#include <utility>

#include "analysis/beside.h"
#include "app/session_files_work.h"
#include "core/give_up.h"
#include "session/frame_costs.h"
#include "session/session.h"
#include "session/task_list.h"

namespace hitscope {

namespace {

Error noRoomFor(const QString& path) {
    return {"There is not enough memory for this session.", path.toStdString(),
            "Close other programs, and try again."};
}

}  // namespace

SessionFiles::SessionFiles(Session& session, View view, QObject* parent)
    : QObject(parent), m_session(session), m_view(std::move(view)), m_scene(session.steps().scene()) {
    m_file.kept = session.steps().state();
    connect(&session, &Session::undoChanged, this, &SessionFiles::follow);
    connect(&session.frameCosts(), &FrameCosts::frameEnded, this, &SessionFiles::checkPositions);
}

SessionFiles::~SessionFiles() {
    if (m_work) {
        m_work->ended = {};
    }
    cancel();
}

SessionFiles::FileStamp SessionFiles::stampOf(const QString& path) {
    const QFileInfo info(path);
    return info.isFile() ? FileStamp{info.size(), info.lastModified().toMSecsSinceEpoch()} : FileStamp{};
}

bool SessionFiles::isChangedByOthers() const {
    const FileStamp now = stampOf(m_file.path);
    return !isSavingTo(m_file.path) && now.size >= 0 && now != m_file.stamp;
}

bool SessionFiles::isModified() const {
    return m_file.isRecovered || m_session.steps().state() != m_file.kept;
}

/// Each scene that undo and redo lead to has a file of its own; a new one has none.
void SessionFiles::followScene() {
    const std::uint64_t before = std::exchange(m_scene, m_session.steps().scene());
    if (before == m_scene) {
        return;
    }
    m_others[before] = m_file;
    const auto known = m_others.find(m_scene);
    m_file = known != m_others.end() ? known->second : File{.path = {}, .kept = m_session.steps().state()};
    m_others.erase(m_scene);
    m_wasModified = isModified();
    Q_EMIT changed();
}

void SessionFiles::follow() {
    followScene();
    const bool isNow = isModified();
    if (std::exchange(m_wasModified, isNow) != isNow) {
        Q_EMIT changed();
    }
}

void SessionFiles::begin(const QString& doing, std::function<void()> cancel, const QString& cancelHelp) {
    m_work = std::make_shared<Work>();
    m_work->scene = m_session.steps().scene();
    m_work->state = m_session.steps().state();
    m_progress = std::make_unique<TaskProgress>(m_session.tasks(), doing, std::move(cancel), cancelHelp);
}

void SessionFiles::beginOpening(const QString& name) {
    cancel();
    leaveSaving();
    begin(
        tr("Opening %1").arg(name),
        [this] {
            cancel();
            Q_EMIT cancelled();
        },
        tr("Cancel opening; the session stays as it is"));
    Q_EMIT openingBegun();
}

/// What is being saved is written, but it is no longer the session that there is.
void SessionFiles::leaveSaving() {
    if (m_work && m_work->isSave) {
        end();
    }
}

void SessionFiles::end() {
    const std::shared_ptr<Work> work = std::exchange(m_work, nullptr);
    m_progress.reset();
    if (work && work->ended) {
        std::exchange(work->ended, nullptr)(Ended::NotOpened);
    }
}

void SessionFiles::fail(const Error& error) {
    const Error kept = error;  // NOLINT(performance-unnecessary-copy-initialization): end() may destroy it
    end();
    Q_EMIT failed(kept);
}

// Saving

bool SessionFiles::isSavingTo(const QString& path) const {
    return m_work && m_work->isSave && m_work->path == path;
}

void SessionFiles::save(const QString& path) {
    const QString file = QFileInfo(path).absoluteFilePath();
    if (isSavingTo(file)) {
        m_work->sceneAfter = m_session.steps().scene();
        return;
    }
    if (m_work) {
        Q_EMIT notSaved({"The session cannot be saved while another is opened or saved.", path.toStdString(),
                         "Wait until that has ended."});
        return;
    }
    begin(
        tr("Saving %1").arg(QFileInfo(path).fileName()),
        [this] {
            m_work->cancelled = true;
            m_work->sceneAfter = 0;
        },
        tr("Cancel saving; an earlier file stays unless the new one is written already"));
    m_work->isSave = true;
    m_work->document = captureHits(m_session, m_view.capture());
    m_work->positions = copyPositions(m_session);
    m_work->path = file;
    Q_EMIT writing(file);
    workBeside(
        this, [work = m_work] { work->write(); },
        [work = m_work](SessionFiles& self, bool done) { self.takeWritten(work, done); });
}

void SessionFiles::takeWritten(const std::shared_ptr<Work>& work, bool done) {
    const bool isOfThis = work == m_work;
    if (isOfThis) {
        end();
    }
    const bool isWritten = done && !work->isGivenUp && work->status;
    if (isWritten) {
        keepWritten(*work);
    }
    Q_EMIT written(work->path, isWritten);
    if (isOfThis && work->sceneAfter == m_scene) {
        save(work->path);  // who waits for it waits for all of it
    } else {
        tellWritten(*work, done, isOfThis);
    }
}

void SessionFiles::keepWritten(const Work& work) {
    const File written{work.path, work.state, false, work.stamp};
    if (work.scene == m_scene) {
        m_file = written;
        m_wasModified = isModified();
        Q_EMIT changed();
    } else if (const auto other = m_others.find(work.scene); other != m_others.end()) {
        other->second = written;
    }
}

void SessionFiles::tellWritten(const Work& work, bool done, bool isOfThis) {
    if (work.isGivenUp) {
        Q_EMIT saveCancelled();
    } else if (!done || !work.status) {
        Q_EMIT notSaved(done ? work.status.error() : noRoomFor(work.path));
    } else if (isOfThis) {
        Q_EMIT saved(work.path);
    }
    Q_EMIT saveEnded();
}

// Opening

void SessionFiles::open(const QString& path) {
    beginOpening(QFileInfo(path).fileName());
    m_work->path = QFileInfo(path).absoluteFilePath();
    m_work->places.folder = QFileInfo(path).absolutePath();
    prepare();
}

void SessionFiles::openDocument(SessionDocument document, Origin origin) {
    beginOpening(document.scene.name);
    m_work->ended = std::move(origin.ended);
    m_work->noteInPart = origin.noteInPart;
    m_work->path = origin.file;
    m_work->stamp = stampOf(origin.file);
    m_work->document = std::move(document);
    m_work->isRead = true;
    m_work->isRecovered = true;
    prepare();
}

void SessionFiles::cancel() {
    if (m_work && !m_work->isSave) {
        m_work->cancelled = true;
        end();
    }
}

void SessionFiles::say(const Work& work, double fraction, const QString& doing) {
    if (&work == m_work.get()) {
        m_progress->say(doing);
        m_progress->report(fraction);
    }
}

void SessionFiles::prepare() {
    const auto report = [self = QPointer(this), work = m_work](double fraction, const QString& doing) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, work, fraction, doing] {
                if (SessionFiles* alive = self.data(); alive != nullptr) {
                    alive->say(*work, fraction, doing);
                }
            },
            Qt::QueuedConnection);
    };
    workBeside(
        this,
        [work = m_work, report] {
            const std::function<bool()> isWanted = [&work] { return !work->cancelled; };
            const GiveUpScope watched(isWanted, GiveUpScope::Asked::Anywhere);
            try {
                work->prepare(report);
            } catch (const GivenUp&) {
                work->status = Error{"Opening the session was cancelled.", "", ""};
            }
        },
        [work = m_work](SessionFiles& self, bool done) { self.take(work, done); });
}

void SessionFiles::take(const std::shared_ptr<Work>& work, bool done) {
    if (work != m_work) {
        return;
    }
    if (!done || !work->status) {
        fail(done ? work->status.error() : noRoomFor(work->path));
    } else if (work->prepared.troubles.empty()) {
        goOn();
    } else {
        Q_EMIT troubled();
    }
}

const std::vector<MeshTrouble>& SessionFiles::troubles() const {
    static const std::vector<MeshTrouble> kNone;
    return m_work ? m_work->prepared.troubles : kNone;
}

void SessionFiles::lookAgain(const QString& missing, const QString& found) {
    if (m_work) {
        m_work->places.found[missing] = found;
        m_work->places.others << QFileInfo(found).absolutePath();
        m_work->prepared = {};
        prepare();
    }
}

void SessionFiles::goOn() {
    const std::shared_ptr<Work> work = m_work;
    if (!work) {
        return;
    }
    if (!m_ask || work->state == m_session.steps().state()) {
        replaceBy(work);
        return;
    }
    // What was done meanwhile may be worth keeping; while that is asked, it may have to be saved.
    const std::function<void(Ended)> ended = std::exchange(work->ended, {});
    end();
    work->ended = ended;
    m_ask([this, work] { replaceBy(work); },
          [this, work] {
              if (work->ended) {
                  work->ended(Ended::NotOpened);
              }
              Q_EMIT cancelled();
          });
}

void SessionFiles::replaceBy(const std::shared_ptr<Work>& work) {
    const std::function<void(Ended)> ended = std::exchange(work->ended, {});
    cancel();  // what was begun while the question was open
    leaveSaving();
    restoreSession(m_session, work->prepared);
    m_others.clear();  // there is no undo beyond what is opened
    m_view.restore(work->prepared.document);
    // Saved to its own file, what is left out would be lost.
    const bool isWhole = work->prepared.isWhole();
    m_file.path = isWhole ? work->path : QString();
    m_file.kept = m_session.steps().state();
    m_file.isRecovered = work->isRecovered || m_file.path.isEmpty();
    m_file.stamp = work->stamp;
    m_wasModified = isModified();
    QStringList notes = work->prepared.notes;
    if (!isWhole && !work->noteInPart.isEmpty()) {
        notes.prepend(work->noteInPart);  // not all of them may be shown
    }
    for (const MeshTrouble& trouble : work->prepared.troubles) {
        // Without its advice: the person has chosen.
        notes << QString::fromStdString(Error{trouble.error.what, trouble.error.where, {}}.message());
    }
    m_toCheck = std::make_unique<SessionDocument>(std::move(work->prepared.document));
    Q_EMIT changed();
    Q_EMIT opened(work->isRecovered ? QString() : m_file.path, notes);
    if (ended) {
        ended(isWhole ? Ended::Whole : Ended::InPart);
    }
}

void SessionFiles::checkPositions() {
    if (!m_toCheck || !m_session.readBack().isUpToDate()) {
        return;
    }
    const std::unique_ptr<SessionDocument> document = std::move(m_toCheck);
    if (document->hits.size() != m_session.hits().history().size()) {
        return;  // it has changed meanwhile
    }
    QStringList names;
    for (const TargetId id : differingTargets(m_session, *document)) {
        if (const Target* target = m_session.targets().find(id)) {
            names << target->name;
        }
    }
    if (!names.isEmpty()) {
        Q_EMIT differs(names);
    }
}

// Letting go

void SessionFiles::leave() {
    leaveSaving();
    m_file.path.clear();
    m_toCheck.reset();
    letGo();
    Q_EMIT left();
}

void SessionFiles::letGo() {
    m_file.kept = m_session.steps().state();
    m_file.isRecovered = false;
    m_wasModified = false;
    Q_EMIT changed();
}

}  // namespace hitscope
