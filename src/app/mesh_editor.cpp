// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_editor.h"

#include <QCoreApplication>
#include <QPointer>
#include <atomic>
#include <utility>

#include "analysis/beside.h"
#include "models/quantity_text.h"
#include "session/session.h"
#include "session/task_list.h"

namespace hitscope {

/// What is being done. The other thread holds on to it too.
struct MeshEditor::Work {
    TargetState before;
    MeshEdit edit;
    std::atomic<bool> cancelled = false;
    Status status = Done{};
    TargetState after;
};

MeshEditor::MeshEditor(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    connect(&session, &Session::sceneReplaced, this, &MeshEditor::giveUp);
}

MeshEditor::~MeshEditor() {
    giveUp();
}

void MeshEditor::start(TargetId target, MeshEdit edit) {
    const Target* found = m_session.targets().find(target);
    if (m_work || found == nullptr) {
        return;
    }
    const auto work = std::make_shared<Work>();
    work->before = *found;
    work->edit = std::move(edit);
    m_work = work;
    const QString name = found->name;
    const QString doing[] = {tr("Refining %1"), tr("Simplifying %1"), tr("Smoothing %1"),
                             tr("Applying hits of %1")};
    m_progress = std::make_unique<TaskProgress>(
        m_session.tasks(), doing[work->edit.step.index()].arg(name),
        [this] {
            giveUp();
            Q_EMIT cancelled();
        },
        tr("Cancel; the mesh stays as it is"));
    Q_EMIT busyChanged();
    const auto goOn = [self = QPointer(this), work](double share) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, work, share] {
                if (MeshEditor* alive = self.data(); alive != nullptr) {
                    alive->report(work, share);
                }
            },
            Qt::QueuedConnection);
        return !work->cancelled;
    };
    workBeside(
        this,
        [work, goOn] {
            Result<EditedMesh> made = hitscope::edited(*work->before.shape.mesh, work->edit, goOn);
            if (!made) {
                work->status = made.error();
            } else if (!work->cancelled) {
                work->after = stateWith(work->before, std::move(made).value());
            }
        },
        [work](MeshEditor& self, bool done) { self.finish(work, done); });
}

void MeshEditor::report(const std::shared_ptr<Work>& work, double share) {
    if (work == m_work) {
        m_progress->report(share);
    }
}

void MeshEditor::giveUp() {
    if (m_work) {
        m_work->cancelled = true;
        m_work.reset();
        m_progress.reset();
        Q_EMIT busyChanged();
    }
}

void MeshEditor::finish(const std::shared_ptr<Work>& work, bool done) {
    if (work != m_work) {
        return;
    }
    m_work.reset();
    m_progress.reset();
    Q_EMIT busyChanged();
    Status status = done ? work->status
                         : Status(Error{"There is not enough memory for the mesh.", "",
                                        "Choose a greater edge length, or close other programs."});
    if (status) {
        status = takeEdited(m_session, work->after, work->edit);
    }
    if (!status) {
        Q_EMIT failed(status.error());
        return;
    }
    const MeshData& mesh = *work->after.shape.mesh;
    Q_EMIT edited(tr("%1 has %2 vertices and %3 faces now. Undo (Ctrl+Z) brings back how it was.")
                      .arg(work->before.name, countText(mesh.vertexCount()), countText(mesh.faceCount())));
}

}  // namespace hitscope
