// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/import.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QProcess>
#include <QTimer>
#include <optional>

#include "core/give_up.h"
#include "io/import_checks.h"
#include "io/nameless_file.h"
#include "io/take_over.h"
#include "io/worker_failure.h"
#include "io/worker_location.h"
#include "io/worker_process.h"
#include "io/worker_protocol.h"

namespace hitscope {
namespace {

constexpr double kWorkerShare = 0.9;  ///< of the progress; the rest is taking over its answer
constexpr qsizetype kMaxNotes = 200;
constexpr qint64 kMaxLine = 1 << 16;   ///< bytes; a longer line means the worker is not itself
constexpr qint64 kMaxHeard = 4 << 20;  ///< bytes; no mesh gives as much to say

Error cancelledError(const QString& path) {
    return {"Opening the file was cancelled.", path.toStdString(), {}};
}

/// Goes when it has finished, on the thread that lives longest: the end of a process that had much memory, or
/// of a thread, takes a moment that nobody should wait for.
template <class Running>
Running* leaveToItself(std::unique_ptr<Running> running) {
    Running* const left = running.release();
    QObject::connect(left, &Running::finished, left, &QObject::deleteLater);
    left->moveToThread(QCoreApplication::instance()->thread());
    return left;
}

}  // namespace

struct MeshImport::Private {
    MeshImport* q = nullptr;
    ImportLimits limits;
    std::shared_ptr<NamelessFile> answer = std::make_shared<NamelessFile>();
    std::unique_ptr<QProcess> process = std::make_unique<QProcess>();
    qint64 worker = 0;  ///< its process id
    qint64 heard = 0;   ///< bytes it said
    QTimer clock;
    QStringList notes;
    std::optional<Error> told;  ///< what the worker said was wrong
    bool timedOut = false;
    bool started = false;
    bool done = false;
    std::unique_ptr<TakeOver> taker;

    void fail(Error error);
    void begin();
    void readLines();
    void workerEnded(int code, QProcess::ExitStatus status);
    void takeOver();
    void handOver();
    void stop();
};

/// Always later, from the event loop, so that a caller can connect after start().
void MeshImport::Private::fail(Error error) {
    if (done) {
        return;
    }
    done = true;
    clock.stop();
    QMetaObject::invokeMethod(
        q, [this, error = std::move(error)] { Q_EMIT q->failed(error); }, Qt::QueuedConnection);
}

void MeshImport::Private::begin() {
    const QString path = QFileInfo(q->m_path).absoluteFilePath();
    if (const Status can = checkImportable(q->m_path); !can) {
        return fail(can.error());
    }
    const QString program = importWorkerPath();
    if (program.isEmpty()) {
        return fail({"The program hitscope-import, which reads mesh files, is missing.", path.toStdString(),
                     "Install Hitscope again, or name it in HITSCOPE_IMPORT_WORKER."});
    }
    if (!answer->isOpen()) {
        return fail({"There is no place for temporary files: " + answer->whyNot().toStdString() + ".",
                     QDir::tempPath().toStdString(), "Make room there, or set TMPDIR to another folder."});
    }
    startWorker(*process, program, path, limits, answer->descriptor());
    worker = process->processId();
    clock.start(limits.seconds * 1000);
}

/// Of several steps that were told at once, the last is told on.
void MeshImport::Private::readLines() {
    std::optional<WorkerProgress> step;
    while (process->canReadLine() && !done && heard <= kMaxHeard) {
        const QByteArray line = process->readLine();
        heard += line.size() <= kMaxLine ? line.size() : kMaxHeard + 1;
        const WorkerMessage message = parseWorkerLine(line.trimmed());
        if (const auto* progress = std::get_if<WorkerProgress>(&message)) {
            step = *progress;
        } else if (const auto* note = std::get_if<WorkerNote>(&message)) {
            if (notes.size() < kMaxNotes) {
                notes += note->text;
            }
        } else if (const auto* error = std::get_if<Error>(&message)) {
            told = *error;
            if (told->where == kAnswerPlace) {
                told->where = QDir::tempPath().toStdString();
            }
        }
    }
    if (heard > kMaxHeard || process->bytesAvailable() > kMaxLine) {
        fail({"The import worker's answer cannot be used: it says too much.", q->m_path.toStdString(),
              "If this happens with every file, install Hitscope again."});
        return stop();
    }
    if (step && !done) {
        const double share = step->fraction < 0 ? -1.0 : step->fraction * kWorkerShare;
        Q_EMIT q->progressed(share, step->doing);
    }
}

void MeshImport::Private::workerEnded(int code, QProcess::ExitStatus status) {
    readLines();
    if (done) {
        return;
    }
    clock.stop();
    endWorker(worker);  // and what it may have started
    const bool crashed = status == QProcess::CrashExit;
    if (told && !timedOut) {
        return fail(*told);
    }
    if (crashed || code != 0 || timedOut || answer->size() == 0) {
        return fail(describeWorkerEnd({crashed, code, timedOut}, q->m_path, limits));
    }
    takeOver();
}

void MeshImport::Private::takeOver() {
    taker = std::make_unique<TakeOver>(answer, limits.memoryBytes);
    QObject::connect(taker.get(), &TakeOver::progressed, q, [this](double fraction, const char* doing) {
        if (!done) {
            Q_EMIT q->progressed(kWorkerShare + (1.0 - kWorkerShare) * fraction, QString::fromLatin1(doing));
        }
    });
    QObject::connect(taker.get(), &TakeOver::finished, q, [this] { handOver(); });
    taker->start();
}

void MeshImport::Private::handOver() {
    if (done) {
        return;
    }
    Result<MeshData> taken = taker->take();
    if (!taken) {
        Error error = taken.error();
        if (error.where.empty()) {
            error.where = q->m_path.toStdString();
        }
        return fail(std::move(error));
    }
    done = true;
    Q_EMIT q->progressed(1.0, QString());
    Q_EMIT q->finished(std::make_shared<ImportedMesh>(ImportedMesh{std::move(taken.value()), notes}));
}

void MeshImport::Private::stop() {
    if (process->state() != QProcess::NotRunning) {
        endWorker(worker);
        process->kill();
    }
    if (taker) {
        taker->cancel();
    }
}

MeshImport::MeshImport(QString path, ImportLimits limits, QObject* parent)
    : QObject(parent), m_path(std::move(path)), d(std::make_unique<Private>()) {
    d->q = this;
    d->limits = limits;
    d->clock.setSingleShot(true);
    connect(d->process.get(), &QProcess::readyReadStandardOutput, this, [this] { d->readLines(); });
    connect(d->process.get(), &QProcess::finished, this,
            [this](int code, QProcess::ExitStatus status) { d->workerEnded(code, status); });
    connect(d->process.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            d->fail({"The program hitscope-import, which reads mesh files, does not start: " +
                         d->process->errorString().toStdString() + ".",
                     m_path.toStdString(), "Install Hitscope again."});
        }
    });
    connect(&d->clock, &QTimer::timeout, this, [this] {
        d->timedOut = true;
        d->stop();
    });
}

MeshImport::~MeshImport() {
    d->done = true;
    d->process->disconnect(this);
    d->stop();
    if (d->process->state() != QProcess::NotRunning) {
        leaveToItself(std::move(d->process));
    }
    if (d->taker && !d->taker->isFinished()) {
        d->taker->disconnect(this);
        if (TakeOver* const left = leaveToItself(std::move(d->taker)); left->isFinished()) {
            left->deleteLater();  // just now
        }
    }
}

void MeshImport::start() {
    if (!d->started) {
        d->started = true;
        d->begin();
    }
}

void MeshImport::cancel() {
    d->fail(cancelledError(m_path));
    d->stop();
}

Result<ImportedMesh> importMesh(const QString& path, const ImportLimits& limits,
                                const std::function<void(double)>& told) {
    constexpr int kBetweenQuestions = 20;  // milliseconds
    bool isGivenUp = false;
    std::optional<Result<ImportedMesh>> result;
    QEventLoop loop;
    MeshImport import(path, limits);
    QObject::connect(&import, &MeshImport::finished, &loop,
                     [&](const std::shared_ptr<ImportedMesh>& imported) {
                         result.emplace(std::move(*imported));
                         loop.quit();
                     });
    QObject::connect(&import, &MeshImport::failed, &loop, [&](const Error& error) {
        result.emplace(error);
        loop.quit();
    });
    QTimer questions;
    QObject::connect(&questions, &QTimer::timeout, &loop, [&] {
        isGivenUp = GiveUpScope::isGivenUp();
        if (isGivenUp) {
            loop.quit();
        }
    });
    questions.start(kBetweenQuestions);
    QObject::connect(&import, &MeshImport::progressed, &loop, [&told](double fraction) {
        if (told && fraction >= 0.0) {
            told(fraction);
        }
    });
    import.start();
    loop.exec();
    if (isGivenUp) {
        throw GivenUp{};
    }
    return std::move(*result);
}

}  // namespace hitscope
