// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <span>

#include "session/read_back.h"
#include "session/scene_presets.h"
#include "session/session_hits.h"
#include "session/session_settings.h"
#include "session/session_targets.h"
#include "session/session_undo.h"
#include "session/simulation.h"

namespace hitscope {

class FrameCosts;
class TaskList;
class VertexSelection;

/// Everything a person works on, in parts: targets, hits, settings, simulation. It orders what concerns
/// several of them: new scenes, and the steps to undo. Makes no GL call; SceneGpu follows it on the GPU and
/// hands back what the pipeline made. One thread: the one it was created on.
class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject* parent = nullptr);
    ~Session() override;

    [[nodiscard]] SessionTargets& targets() { return m_targets; }
    [[nodiscard]] const SessionTargets& targets() const { return m_targets; }
    [[nodiscard]] SessionHits& hits() { return m_hits; }
    [[nodiscard]] const SessionHits& hits() const { return m_hits; }
    [[nodiscard]] SessionSettings& settings() { return m_settings; }
    [[nodiscard]] const SessionSettings& settings() const { return m_settings; }
    [[nodiscard]] Simulation& simulation() { return m_simulation; }
    [[nodiscard]] const Simulation& simulation() const { return m_simulation; }
    /// The vertices pointed at, picked and selected.
    [[nodiscard]] VertexSelection& selection() { return *m_selection; }
    [[nodiscard]] const VertexSelection& selection() const { return *m_selection; }
    /// What takes a while at the moment.
    [[nodiscard]] TaskList& tasks() const { return *m_tasks; }
    /// What frames and hits cost; SceneGpu reports there.
    [[nodiscard]] FrameCosts& frameCosts() const { return *m_frameCosts; }
    /// What the renderer reports: what it can, and what the active pipeline made of the targets.
    [[nodiscard]] const ReadBack& readBack() const { return *m_readBack; }
    [[nodiscard]] ReadBack& readBack(ReadBackAccess /*as that says*/) { return *m_readBack; }

    /// Replaces targets and history. One step to undo, unless there was no target before. `kind` names it.
    void loadScene(ScenePlan plan, SessionUndo::Kind kind = SessionUndo::Kind::LoadScene);
    /// As a file has it; nothing can be undone after it. The targets' ids are from targets().nextId() on; all
    /// hits are on these targets, and have passed checkedHit().
    void restoreScene(const SceneState& scene);
    [[nodiscard]] QString sceneName() const { return m_sceneName; }  ///< for the window's title

    /// Undo and redo cover every change of the history (hits made, removed, moved, disabled, cleared,
    /// edited), of the targets, of the settings and of the cutting plane, and other scenes.
    [[nodiscard]] const SessionUndo& steps() const { return m_undo; }
    void undo();  ///< nothing where there is nothing to undo
    void redo();
    void goToStep(std::size_t done);  ///< undoes or redoes until so many steps are done
    /// A gesture has ended: what is done next is another step to undo, whatever it would merge with.
    void finishUndoStep() { m_undo.finishStep(); }

Q_SIGNALS:
    void sceneReplaced();   ///< all targets are new, the history is empty; hits may follow
    void undoChanged();     ///< what there is to undo or redo
    void pictureChanged();  ///< anything that a new frame would show

private:
    friend class SessionHits;
    friend class SessionSettings;
    friend class SessionTargets;
    friend class Simulation;

    [[nodiscard]] SceneState scene() const;
    void clearScene();
    /// The scene is another; its hits come after it.
    void announceScene();
    void show(const SceneState& scene);
    /// What was done, and has been announced.
    void record(SessionUndo::Change change);
    /// Vertices will move: the history has these edits.
    void expectMoves(std::span<const HistoryEdit> edits);
    [[nodiscard]] SessionUndo::Change takeBack();
    [[nodiscard]] SessionUndo::Change doAgain();
    void makeAgain(const SessionUndo::Change& change);
    /// All that goes by a change follows it; the history has it already.
    void follow(const SessionUndo::Change& change);

    QString m_sceneName;
    SessionUndo m_undo;
    SessionTargets m_targets{*this};
    SessionHits m_hits{*this};
    SessionSettings m_settings{*this};
    Simulation m_simulation{*this};
    std::unique_ptr<ReadBack> m_readBack;
    std::unique_ptr<FrameCosts> m_frameCosts;
    std::unique_ptr<VertexSelection> m_selection;
    std::unique_ptr<TaskList> m_tasks;
};

// Scenes, by Session::loadScene().

void loadPaperRow(Session& session, int row);  ///< 0 <= row < paperRows().size()
/// One mesh, standing on the floor. `mesh` has passed validate().
void loadMesh(Session& session, MeshData mesh, const QString& sourcePath = {});
void loadMesh(Session& session, const PreparedMesh& mesh, const QString& sourcePath = {});
void loadTeapot(Session& session);

}  // namespace hitscope
