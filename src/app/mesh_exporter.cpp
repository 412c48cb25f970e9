// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_exporter.h"

#include <QFileInfo>
#include <cmath>
#include <utility>

#include "analysis/background_pool.h"
#include "session/task_list.h"

namespace hitscope {

MeshExporter::MeshExporter(TaskList& tasks, QObject* parent) : QObject(parent), m_tasks(tasks) {
    m_writer.setMaxThreadCount(1);
}

MeshExporter::~MeshExporter() {
    m_writer.waitForDone();
}

int MeshExporter::start(SceneExport what, const QString& name, const QString& path) {
    auto job = std::make_shared<Job>();
    job->number = ++m_last;
    job->name = name;
    job->path = path;
    job->what = std::move(what);
    job->progress = std::make_unique<TaskProgress>(
        m_tasks, tr("Exporting %1").arg(QFileInfo(path).fileName()),
        [stopped = std::weak_ptr(job)] {
            if (const std::shared_ptr<Job> it = stopped.lock()) {
                it->isCancelled = true;
            }
        },
        tr("Cancel the export; an earlier file stays unless the new one is written already"));
    m_jobs.push_back(job);
    Q_EMIT begun(path);
    m_writer.start([this, job] { write(job); });
    return job->number;
}

/// On the other thread.
void MeshExporter::write(const std::shared_ptr<Job>& job) {
    constexpr double kStep = 1.0e-3;  // of the progress that is told
    giveWay();
    const auto goOn = [this, &job, told = -1.0, said = QString()](double fraction,
                                                                  const QString& doing) mutable {
        if (std::abs(fraction - told) >= kStep || doing != said) {
            told = fraction;
            said = doing;
            QMetaObject::invokeMethod(
                this,
                [job, fraction, doing] {
                    if (job->progress) {
                        job->progress->say(doing);
                        job->progress->report(fraction);
                    }
                },
                Qt::QueuedConnection);
        }
        return !job->isCancelled;
    };
    const Result<ExportReport> written = writeExport(std::move(job->what), job->path, goOn);
    QMetaObject::invokeMethod(
        this, [this, job, written] { take(job, written); }, Qt::QueuedConnection);
}

void MeshExporter::take(const std::shared_ptr<Job>& job, const Result<ExportReport>& written) {
    job->progress.reset();
    m_jobs.remove(job);
    if (written) {
        Q_EMIT exported(job->name, job->path, written.value().notes, written.value().wasReadBack);
    } else if (job->isCancelled) {
        Q_EMIT cancelled();
    } else {
        Q_EMIT failed(written.error());
    }
    Q_EMIT ended(job->path, written.ok(), job->number);
}

}  // namespace hitscope
