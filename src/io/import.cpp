// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/import.h"

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QProcess>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <optional>

#include "io/import_checks.h"
#include "io/mesh_stream.h"
#include "io/nameless_file.h"
#include "io/worker_failure.h"
#include "io/worker_location.h"
#include "io/worker_protocol.h"

namespace hitscope {
namespace {

constexpr double kWorkerShare = 0.9;  ///< of the progress; the rest is taking over its answer
constexpr qsizetype kMaxNotes = 200;
constexpr qint64 kMaxLine = 1 << 16;  ///< bytes; a longer line means the worker is not itself

Error cancelledError(const QString& path) {
    return {"Opening the file was cancelled.", path.toStdString(), {}};
}

}  // namespace

struct MeshImport::Private {
    MeshImport* q = nullptr;
    ImportLimits limits;
    NamelessFile answer;
    QProcess process;
    QTimer clock;
    QStringList notes;
    std::optional<Error> told;  ///< what the worker said was wrong
    bool timedOut = false;
    bool started = false;
    bool done = false;
    std::atomic_bool stop = false;
    std::unique_ptr<QThread> taker;
    std::optional<Result<MeshData>> taken;  ///< written by `taker`, read once it has finished

    void fail(Error error);
    void begin();
    void readLines();
    void workerEnded(int code, QProcess::ExitStatus status);
    void takeOver();
    void handOver();
    void endWorker();
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
    const QString worker = importWorkerPath();
    if (worker.isEmpty()) {
        return fail({"The program hitscope-import, which reads mesh files, is missing.", path.toStdString(),
                     "Install Hitscope again, or name it in HITSCOPE_IMPORT_WORKER."});
    }
    if (!answer.isOpen()) {
        return fail({"There is no place for temporary files: " + answer.whyNot().toStdString() + ".",
                     QDir::tempPath().toStdString(), "Make room there, or set TMPDIR to another folder."});
    }
    process.setStandardInputFile(QProcess::nullDevice());
    process.setStandardErrorFile(QProcess::nullDevice());
    process.start(
        worker, {path, answer.path(), QString::number(limits.seconds), QString::number(limits.memoryBytes)});
    clock.start(limits.seconds * 1000);
}

void MeshImport::Private::readLines() {
    while (process.canReadLine() && !done) {
        const WorkerMessage message = parseWorkerLine(process.readLine(kMaxLine).trimmed());
        if (const auto* progress = std::get_if<WorkerProgress>(&message)) {
            const double share = progress->fraction < 0 ? -1.0 : progress->fraction * kWorkerShare;
            Q_EMIT q->progressed(share, progress->doing);
        } else if (const auto* note = std::get_if<WorkerNote>(&message)) {
            if (notes.size() < kMaxNotes) {
                notes += note->text;
            }
        } else if (const auto* error = std::get_if<Error>(&message)) {
            told = *error;
            if (told->where == answer.path().toStdString()) {  // has no name that a person could look for
                told->where = QDir::tempPath().toStdString();
            }
        }
    }
    if (process.bytesAvailable() > kMaxLine) {
        process.readAll();
    }
}

void MeshImport::Private::workerEnded(int code, QProcess::ExitStatus status) {
    readLines();
    if (done) {
        return;
    }
    clock.stop();
    const bool crashed = status == QProcess::CrashExit;
    if (told && !timedOut) {
        return fail(*told);
    }
    if (crashed || code != 0 || timedOut || answer.isEmpty()) {
        return fail(describeWorkerEnd({crashed, code, timedOut}, q->m_path, limits));
    }
    takeOver();
}

/// Large meshes take a moment to read back and check: in a thread, so that the window stays live.
void MeshImport::Private::takeOver() {
    const ProgressSink progress = [this](double fraction, const char* doing) {
        QMetaObject::invokeMethod(
            q,
            [this, fraction, doing] {
                if (!done) {
                    Q_EMIT q->progressed(kWorkerShare + (1.0 - kWorkerShare) * fraction,
                                         QString::fromLatin1(doing));
                }
            },
            Qt::QueuedConnection);
    };
    taker.reset(
        QThread::create([this, progress] { taken.emplace(readMeshStream(answer.path(), progress, &stop)); }));
    QObject::connect(taker.get(), &QThread::finished, q, [this] { handOver(); });
    taker->start();
}

void MeshImport::Private::handOver() {
    answer.close();
    if (done) {
        return;
    }
    if (!taken->ok()) {
        Error error = taken->error();
        if (error.where.empty()) {
            error.where = q->m_path.toStdString();
        }
        return fail(std::move(error));
    }
    done = true;
    Q_EMIT q->progressed(1.0, QString());
    Q_EMIT q->finished(std::make_shared<ImportedMesh>(ImportedMesh{std::move(taken->value()), notes}));
}

void MeshImport::Private::endWorker() {
    if (process.state() != QProcess::NotRunning) {
        process.kill();
    }
}

MeshImport::MeshImport(QString path, ImportLimits limits, QObject* parent)
    : QObject(parent), m_path(std::move(path)), d(std::make_unique<Private>()) {
    d->q = this;
    d->limits = limits;
    d->clock.setSingleShot(true);
    connect(&d->process, &QProcess::readyReadStandardOutput, this, [this] { d->readLines(); });
    connect(&d->process, &QProcess::finished, this,
            [this](int code, QProcess::ExitStatus status) { d->workerEnded(code, status); });
    connect(&d->process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            d->fail({"The program hitscope-import, which reads mesh files, does not start: " +
                         d->process.errorString().toStdString() + ".",
                     m_path.toStdString(), "Install Hitscope again."});
        }
    });
    connect(&d->clock, &QTimer::timeout, this, [this] {
        d->timedOut = true;
        d->endWorker();
    });
}

MeshImport::~MeshImport() {
    d->done = true;
    d->stop = true;
    d->process.disconnect(this);
    d->endWorker();
    d->process.waitForFinished();
    if (d->taker) {
        d->taker->wait();
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
    d->stop = true;
    d->endWorker();
}

Result<ImportedMesh> importMesh(const QString& path, const ImportLimits& limits) {
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
    import.start();
    loop.exec();
    return std::move(*result);
}

}  // namespace hitscope
