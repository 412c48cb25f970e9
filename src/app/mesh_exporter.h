// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <atomic>
#include <list>
#include <memory>

#include "session/export/export_target.h"

namespace hitscope {

class TaskList;
class TaskProgress;

/// Writes meshes to files on another thread, one after the other. What is under way when this is destroyed
/// is written to its end first: the person asked for it.
class MeshExporter : public QObject {
    Q_OBJECT
public:
    /// `tasks` outlives this; there the exports are shown and can be cancelled.
    explicit MeshExporter(TaskList& tasks, QObject* parent = nullptr);
    ~MeshExporter() override;

    /// `name`: what it is of, for people. Returns the job's number: others may be for the same file.
    int start(SceneExport what, const QString& name, const QString& path);
    [[nodiscard]] bool isRunning() const { return !m_jobs.empty(); }

Q_SIGNALS:
    void begun(const QString& path);  ///< and ended() follows
    /// The rest is ExportReport's.
    void exported(const QString& name, const QString& path, const QStringList& notes, bool wasReadBack);
    void failed(const hitscope::Error& error);
    void cancelled();                                          ///< the file is as it was
    void ended(const QString& path, bool isWritten, int job);  ///< after one of these

private:
    struct Job {
        int number = 0;
        QString name;
        QString path;
        SceneExport what;
        std::atomic<bool> isCancelled = false;
        std::unique_ptr<TaskProgress> progress;  // of the window's thread
    };
    void write(const std::shared_ptr<Job>& job);
    void take(const std::shared_ptr<Job>& job, const Result<ExportReport>& written);

    TaskList& m_tasks;
    std::list<std::shared_ptr<Job>> m_jobs;
    int m_last = 0;  ///< number given
    QThreadPool m_writer;
};

}  // namespace hitscope
