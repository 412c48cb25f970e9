// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_editor.h"

#include <QCoreApplication>
#include <QPointer>
#include <algorithm>
#include <atomic>
#include <utility>
#include <variant>

#include "analysis/beside.h"
#include "models/quantity_text.h"
#include "session/mesh_steps/scale_target.h"
#include "session/mesh_steps/separate_objects.h"
#include "session/session.h"
#include "session/shown_number.h"
#include "session/task_list.h"

namespace hitscope {

/// What is being done. The other thread holds on to it too.
struct MeshEditor::Work {
    virtual ~Work() = default;
    /// On the other thread.
    [[nodiscard]] virtual Status make(const MeshGoOn& goOn) = 0;
    /// After it, on the window's.
    [[nodiscard]] virtual Status take(Session& session) = 0;
    [[nodiscard]] virtual QString said() const = 0;  ///< what came of it
    [[nodiscard]] virtual SessionUndo::Kind kind() const = 0;

    TargetState before;
    std::atomic<bool> cancelled = false;
    Status status = Done{};
};

/// A target gets another mesh.
struct MeshEditor::Edit : Work {
    MeshEdit edit;
    TargetState after;

    Status make(const MeshGoOn& goOn) override {
        Result<EditedMesh> made = hitscope::edited(*before.shape.mesh, edit, goOn);
        if (!made) {
            return made.error();
        }
        if (!cancelled) {
            after = stateWith(before, std::move(made).value());
        }
        return Done{};
    }
    Status take(Session& session) override { return takeEdited(session, after, edit); }
    [[nodiscard]] QString said() const override {
        const MeshData& mesh = *after.shape.mesh;
        const QString now =
            tr("%1: %2, %3 now")
                .arg(before.name, tr("%Ln {vertex|vertices}", nullptr, trCount(mesh.vertexCount())),
                     tr("%Ln {face|faces}", nullptr, trCount(mesh.faceCount())));
        const bool applies = edit.appliesHits || std::holds_alternative<MergedHits>(edit.step);
        const auto hits = static_cast<std::size_t>(
            std::count_if(edit.hits.begin(), edit.hits.end(), [](const Hit& hit) { return hit.enabled; }));
        const QString merged =
            applies && hits > 0 ? u' ' + tr("with %Ln {hit|hits} applied to the mesh", nullptr, trCount(hits))
                                : QString();
        return tr("%1 (Ctrl+Z undoes)").arg(now + merged);
    }
    [[nodiscard]] SessionUndo::Kind kind() const override { return edit.kind(); }
};

/// A target's objects become targets.
struct MeshEditor::Separation : Work {
    std::vector<Hit> hits;
    SeparatedObjects objects;

    Status make(const MeshGoOn& goOn) override {
        Result<SeparatedObjects> made = separated(before, std::move(hits), goOn);
        if (!made) {
            return made.error();
        }
        objects = std::move(made).value();
        return Done{};
    }
    Status take(Session& session) override { return takeSeparated(session, objects); }
    [[nodiscard]] QString said() const override {
        return tr("%1 is %2 targets now. Undo (Ctrl+Z) joins them again.")
            .arg(before.name, countText(objects.parts.size()));
    }
    [[nodiscard]] SessionUndo::Kind kind() const override { return SessionUndo::Kind::SeparateObjects; }
};

/// A target gets another size.
struct MeshEditor::Scaling : Work {
    double extent = 0.0;
    ScaledTarget scaled;

    Status make(const MeshGoOn&) override {
        Result<ScaledTarget> made = scaledTo(before, extent);
        if (!made) {
            return made.error();
        }
        scaled = std::move(made).value();
        return Done{};
    }
    Status take(Session& session) override { return takeScaled(session, scaled); }
    [[nodiscard]] QString said() const override {
        return tr("%1 is %2 times as large now (Ctrl+Z undoes)")
            .arg(before.name, shownNumber(static_cast<double>(scaled.factor), 'g', 4));
    }
    [[nodiscard]] SessionUndo::Kind kind() const override { return SessionUndo::Kind::ScaleTarget; }
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
    const auto work = std::make_shared<Edit>();
    work->before = *found;
    work->edit = std::move(edit);
    const QString doing[] = {tr("Refining %1"), tr("Simplifying %1"), tr("Smoothing %1"),
                             tr("Applying hits of %1")};
    start(doing[work->edit.step.index()].arg(found->name), work);
}

void MeshEditor::startSeparation(TargetId target) {
    const Target* found = m_session.targets().find(target);
    if (m_work || found == nullptr) {
        return;
    }
    const auto work = std::make_shared<Separation>();
    work->before = *found;
    work->hits = meshEdit(m_session, target, {}).hits;
    start(tr("Separating %1").arg(found->name), work);
}

void MeshEditor::startScaling(TargetId target, double extent) {
    const Target* found = m_session.targets().find(target);
    if (m_work || found == nullptr) {
        return;
    }
    const auto work = std::make_shared<Scaling>();
    work->before = *found;
    work->extent = extent;
    start(tr("Scaling %1").arg(found->name), work);
}

std::optional<SessionUndo::Name> MeshEditor::running() const {
    return m_work ? std::optional(SessionUndo::Name{m_work->kind(), 1}) : std::nullopt;
}

void MeshEditor::cancel() {
    giveUp();
    Q_EMIT cancelled();
}

std::size_t MeshEditor::redoable() const {
    return m_session.steps().size() - m_session.steps().done();
}

void MeshEditor::start(const QString& doing, std::shared_ptr<Work> work) {
    m_work = work;
    m_redoable = redoable();
    m_progress = std::make_unique<TaskProgress>(
        m_session.tasks(), doing, [this] { cancel(); }, tr("Cancel; the mesh stays as it is"));
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
        this, [work, goOn] { work->status = work->make(goOn); },
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
    if (status && redoable() > m_redoable) {  // it would be forgotten
        status = Error{"The mesh stays as it is: steps were undone meanwhile.", "", "Do it again."};
    }
    const Target* now = m_session.targets().find(work->before.id);
    if (status && now != nullptr && now->shape.mesh != work->before.shape.mesh) {  // it would get the old one
        status = Error{"The mesh stays as it is: its texture was changed meanwhile.", "", "Do it again."};
    }
    if (status) {
        status = work->take(m_session);
    }
    if (!status) {
        Q_EMIT failed(status.error());
        return;
    }
    Q_EMIT edited(work->said());
}

}  // namespace hitscope
