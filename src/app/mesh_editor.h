// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "core/result.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/session_undo.h"

namespace hitscope {

class Session;
class TaskProgress;

/// Refines, simplifies, smooths, scales and separates targets' meshes beside the window's work, one after the
/// other; the status bar shows it, with a button to cancel.
class MeshEditor : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit MeshEditor(Session& session, QObject* parent = nullptr);
    ~MeshEditor() override;

    [[nodiscard]] bool isBusy() const { return m_work != nullptr; }
    /// What the step will be called that is being made; nothing: none is.
    [[nodiscard]] std::optional<SessionUndo::Name> running() const;
    void cancel();  ///< isBusy()
    /// Ends with edited(), failed() or cancelled(). Not while busy, nor of a target that is not there.
    void start(TargetId target, MeshEdit edit);
    /// Likewise: its objects become targets of their own.
    void startSeparation(TargetId target);
    /// Likewise: its largest extent becomes so many metres, > 0.
    void startScaling(TargetId target, double extent);

Q_SIGNALS:
    void busyChanged();
    void edited(const QString& said);  ///< what came of it, in words
    void failed(const hitscope::Error& error);
    void cancelled();

private:
    struct Work;
    struct Edit;
    struct Separation;
    struct Scaling;
    void start(const QString& doing, std::shared_ptr<Work> work);
    void report(const std::shared_ptr<Work>& work, double share);
    void finish(const std::shared_ptr<Work>& work, bool done);
    void giveUp();
    [[nodiscard]] std::size_t redoable() const;

    Session& m_session;
    std::unique_ptr<TaskProgress> m_progress;
    std::shared_ptr<Work> m_work;  ///< null: nothing is done
    std::size_t m_redoable = 0;    ///< steps, when it began
};

}  // namespace hitscope
