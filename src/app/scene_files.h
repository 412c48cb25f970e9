// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>

#include "io/import.h"
#include "session/session.h"

namespace hitscope {

class TaskProgress;

/// Brings mesh files and scenes of ours into a session without holding up the window: files are read by
/// another process, and what takes time besides is done on another thread. One thing at a time; the next
/// gives the first up.
class SceneFiles : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit SceneFiles(Session& session, QObject* parent = nullptr);
    ~SceneFiles() override;

    enum class Into : std::uint8_t { NewScene, ThisScene };
    /// The files' meshes stay at their own coordinates where they do not overlap (makeRoom()). Files that
    /// cannot be read are left out and named in the notes; it fails when that is all of them. Nothing for an
    /// empty list.
    void open(const QStringList& paths, Into into = Into::NewScene);
    /// `make` is called on another thread.
    void make(const QString& name, Into into, const std::function<ScenePlan()>& make);
    /// Gives up what is being opened; the scene stays as it is.
    void cancel();
    [[nodiscard]] bool isOpening() const { return m_work != nullptr; }

    /// Calls `then` where the scene as it is may be replaced, and `instead` where it may not; at once or
    /// later.
    using Ask = std::function<void(std::function<void()> then, std::function<void()> instead)>;
    /// Is asked before a scene is replaced that was changed while a new one was on its way.
    void setAsk(Ask ask) { m_ask = std::move(ask); }

    /// Draws a mesh before it is prepared, on any thread; null where that is not worth it.
    using Drawing = std::function<QImage(const MeshData&)>;
    /// `make` is called on this thread for each file that is to be a scene of its own.
    void setDrawing(std::function<Drawing()> make) { m_makeDrawing = std::move(make); }

    /// Called on this thread with what the session is about to get, in one turn of the event loop after the
    /// other until it returns true: for what each of whom would hold the window up otherwise.
    using Readying = std::function<bool(const ScenePlan&)>;
    void setReadying(Readying ready) { m_ready = std::move(ready); }

Q_SIGNALS:
    void started(const QString& name);  ///< also with each further file
    /// fraction of this file or scene, in [0, 1]; negative: not known.
    void progressed(double fraction, const QString& doing);
    void seen(const QImage& picture);  ///< what is coming, where a Drawing drew it
    /// The session has the files' meshes. `notes`: what was dropped or mended on the way, in words.
    void opened(const QStringList& paths, const QStringList& notes, hitscope::SceneFiles::Into into);
    void made(const QString& name, hitscope::SceneFiles::Into into);  ///< the session has it
    void failed(const hitscope::Error& error);
    void cancelled();  ///< by somebody who saw it in the list of tasks, or keeps the scene that there is
    void ended();      ///< after opened, made, failed or cancelled

private:
    struct Work;

    void importNext();
    void takeImported(const std::shared_ptr<ImportedMesh>& imported);
    void showThenPrepare(const std::shared_ptr<ImportedMesh>& imported, const QString& path);
    void prepare(const std::shared_ptr<ImportedMesh>& imported, const QString& path);
    void leaveOut(const Error& error);
    void runElsewhere(const std::function<ScenePlan()>& make, const std::function<void()>& then);
    void takeMade(const std::shared_ptr<Work>& work, const std::function<void()>& then);
    void deliver();
    void askAndReplace(const std::shared_ptr<Work>& work);
    void replaceBy(const std::shared_ptr<Work>& work);
    void finish(const std::shared_ptr<Work>& work);
    void cancelAndTell();
    void fail(const Error& error);
    void end();
    void beginTask(const QString& name);
    void say(double fraction, const QString& doing);
    void sayPreparing();

    Session& m_session;
    QString m_name;                            ///< of what is being opened or made
    std::unique_ptr<TaskProgress> m_progress;  ///< null: nothing is
    QTimer m_preparing;                        ///< while a mesh that was read is prepared
    std::shared_ptr<Work> m_work;              ///< null: nothing is being opened
    std::function<Drawing()> m_makeDrawing;
    Readying m_ready;
    Ask m_ask;
};

}  // namespace hitscope
