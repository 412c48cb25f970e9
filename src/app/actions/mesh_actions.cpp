// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/mesh_actions.h"

#include <QAction>
#include <QMenu>
#include <algorithm>
#include <vector>

#include "app/actions/menu_building.h"
#include "app/dialogs/scale_dialog.h"
#include "mesh/mesh_objects.h"
#include "models/focus_target.h"
#include "panels/help/help_text.h"
#include "session/primitive_target.h"
#include "session/session.h"
#include "session/stand_targets.h"
#include "viewport/aim_preview.h"

namespace hitscope {

namespace {

bool hasHitsOn(const Session& session, TargetId target) {
    const auto hits = session.hits().history().hits();
    return std::any_of(hits.rbegin(), hits.rend(), [target](const Hit& hit) { return hit.target == target; });
}

}  // namespace

MeshActions::MeshActions(Session& session, AimPreview& aim, QWidget& window)
    : QObject(&window), m_session(session), m_aim(aim), m_window(window), m_editor(session) {
    connect(&m_editor, &MeshEditor::edited, this, &MeshActions::said);
    connect(&m_editor, &MeshEditor::failed, this, &MeshActions::failed);
    connect(&m_editor, &MeshEditor::cancelled, this,
            [this] { Q_EMIT said(tr("Cancelled. The mesh is unchanged.")); });
    connect(&m_editor, &MeshEditor::busyChanged, this, &MeshActions::follow);
    for (const auto signal :
         {&SessionTargets::added, &SessionTargets::removed, &SessionTargets::selectedChanged}) {
        connect(&session.targets(), signal, this, &MeshActions::follow);
    }
    connect(&session.hits(), &SessionHits::reset, this, &MeshActions::followHits);
    connect(&session.hits(), &SessionHits::appended, this, [this] {
        if (m_apply != nullptr && !m_apply->isEnabled()) {  // else nothing changes with more of them
            followHits();
        }
    });
    connect(&session, &Session::sceneReplaced, this, &MeshActions::follow);
    connect(&aim, &AimPreview::shown, this, &MeshActions::follow);
}

void MeshActions::fill(QMenu& menu) {
    m_refine = addAction(menu, tr("&Refine…"), {}, this, [this] { show(MeshStepDialog::Kind::Refine); });
    m_refineAtAim = addAction(menu, tr("Refi&ne at the Aim"), tr("Ctrl+R"), this, [this] { refineAtAim(); });
    m_refineAtAim->setObjectName(QStringLiteral("refineAtAim"));
    m_refineAtAim->setToolTip(tr("Makes the mesh finer where the shot under the cursor would make its dent"));
    m_simplify =
        addAction(menu, tr("S&implify…"), {}, this, [this] { show(MeshStepDialog::Kind::Simplify); });
    m_smooth = addAction(menu, tr("S&mooth…"), {}, this, [this] { show(MeshStepDialog::Kind::Smooth); });
    m_apply = addAction(menu, tr("Appl&y Hits"), {}, this, [this] { applyHits(); });
    m_apply->setToolTip(tr("The dented shape becomes the original, and its hits leave the history"));
    m_scale = addAction(menu, tr("&Scale…"), {}, this, [this] { scale(); });
    m_scale->setToolTip(tr("Gives the target another size, where it stands, with its hits"));
    m_separate = addAction(menu, tr("S&eparate Objects"), {}, this, [this] { separateObjects(); });
    m_separate->setToolTip(tr("Each object of the file becomes a target of its own, with the hits on it"));
    m_upright = addAction(menu, tr("Turn &Upright"), {}, this, [this] {
        stand(turnUpright);
        Q_EMIT turned();
    });
    m_upright->setToolTip(
        tr("For meshes in which z is up: turns the selected targets by a quarter, so that they stand"));
    m_onFloor = addAction(menu, tr("Set on the &Floor"), {}, this, [this] { stand(setOnFloor); });
    m_onFloor->setToolTip(tr("Moves the selected targets down or up until they stand on the floor"));
    m_turntable = addAction(menu, tr("Put on a &Turntable"), {}, this, [this] { standOnTurntable(); });
    m_turntable->setToolTip(tr("Adds a turntable that fits under the target, and raises the target onto it"));
    follow();
}

void MeshActions::follow() {
    if (m_refine == nullptr) {
        return;
    }
    const Target* target = focusTarget(m_session);
    const QString why = m_editor.isBusy() ? tr("A mesh is being changed.") : tr("Select a target first.");
    for (QAction* action : {m_refine, m_simplify, m_smooth}) {
        enableIf(*action, target != nullptr && !m_editor.isBusy(), why);
    }
    const bool isAsRead = target == nullptr || target->steps.empty();
    enableIf(*m_scale, target != nullptr && isAsRead && !m_editor.isBusy(),
             isAsRead ? why : tr("The mesh was changed at this size: undo that first."));
    for (QAction* action : {m_upright, m_onFloor, m_turntable}) {
        enableIf(*action, target != nullptr, tr("Select a target first."));
    }
    followHits();
    const bool hasObjects = target != nullptr && objectCount(*target->shape.mesh) > 1;
    enableIf(*m_separate, hasObjects && !m_editor.isBusy(),
             target == nullptr || m_editor.isBusy() ? why : tr("The target's mesh is one object."));
    // What it rested on may have gone, or got another mesh and with it another id.
    const bool isAimed = m_aim.aim() && m_session.targets().find(m_aim.aim()->target) != nullptr;
    enableIf(*m_refineAtAim, isAimed && !m_editor.isBusy(),
             m_editor.isBusy() ? why : tr("Rest the cursor on a target first."));
}

void MeshActions::followHits() {
    if (m_apply == nullptr) {
        return;
    }
    const Target* target = focusTarget(m_session);
    const bool hasHits = target != nullptr && hasHitsOn(m_session, target->id);
    enableIf(*m_apply, hasHits && !m_editor.isBusy(),
             m_editor.isBusy()   ? tr("A mesh is being changed.")
             : target == nullptr ? tr("Select a target first.")
                                 : tr("The target has no hits."));
}

void MeshActions::show(MeshStepDialog::Kind kind) {
    const Target* target = focusTarget(m_session);
    if (target == nullptr || m_editor.isBusy()) {
        return;
    }
    const TargetId id = target->id;
    auto* dialog =
        new MeshStepDialog(kind, target->shape.mesh, target->name, meshEdit(m_session, id, {}), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, id] { m_editor.start(id, dialog->edit()); });
    dialog->open();
}

void MeshActions::applyHits() {
    if (const Target* target = focusTarget(m_session)) {
        m_editor.start(target->id, meshEdit(m_session, target->id, MergedHits{}));
    }
}

void MeshActions::separateObjects() {
    if (const Target* target = focusTarget(m_session)) {
        m_editor.startSeparation(target->id);
    }
}

void MeshActions::scale() {
    const Target* target = focusTarget(m_session);
    if (target == nullptr || m_editor.isBusy()) {
        return;
    }
    const TargetId id = target->id;
    auto* dialog = new ScaleDialog(target->name, static_cast<double>(target->extent()), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, id] { m_editor.startScaling(id, dialog->extent()); });
    dialog->open();
}

void MeshActions::stand(Status (*how)(Session&, std::span<const TargetId>)) {
    std::vector<TargetId> ids = m_session.targets().allSelected();
    if (const Target* target = focusTarget(m_session); ids.empty() && target != nullptr) {
        ids.push_back(target->id);
    }
    if (const Status stood = how(m_session, ids); !stood) {
        Q_EMIT failed(stood.error());
    }
}

void MeshActions::standOnTurntable() {
    if (const Target* target = focusTarget(m_session)) {
        if (const Status put = putOnTurntable(m_session, target->id); !put) {
            Q_EMIT failed(put.error());
        }
    }
}

void MeshActions::refineAtAim() {
    constexpr float kPartsOfReach = 5.0f;  // edges from the hit to the end of its reach
    const std::optional<AimPreview::Aim>& aim = m_aim.aim();
    if (!aim || m_session.targets().find(aim->target) == nullptr) {
        return;
    }
    MeshEdit edit = meshEdit(m_session, aim->target,
                             RefineOptions{.method = RefineMethod::Midpoint,
                                           .edgeLength = aim->reach / kPartsOfReach,
                                           .keepQuads = true,
                                           .region = {}});
    edit.where = MeshEdit::Where::Aim;
    edit.aim = {aim->point, aim->reach};
    m_editor.start(aim->target, std::move(edit));
}

}  // namespace hitscope
