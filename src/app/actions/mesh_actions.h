// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <span>

#include "app/dialogs/mesh_step_dialog.h"
#include "app/mesh_editor.h"

class QAction;
class QMenu;
class QWidget;

namespace hitscope {

class AimPreview;

/// What the Mesh menu does to the target in focus: refine, simplify, smooth, apply its hits, scale it,
/// separate its objects, put it on a turntable; and to all selected ones: turn them upright, set them on the
/// floor.
class MeshActions : public QObject {
    Q_OBJECT
public:
    /// All outlive this; `window` is the dialogs' parent.
    MeshActions(Session& session, AimPreview& aim, QWidget& window);

    void fill(QMenu& menu);  ///< once
    [[nodiscard]] MeshEditor& editor() { return m_editor; }

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);
    void turned();  ///< what is selected may reach out of the picture now

private:
    void show(MeshStepDialog::Kind kind);
    void applyHits();
    void separateObjects();
    void scale();
    void refineAtAim();
    void stand(Status (*how)(Session& session, std::span<const TargetId> ids));
    void standOnTurntable();
    void follow();
    void followHits();

    Session& m_session;
    AimPreview& m_aim;
    QWidget& m_window;
    MeshEditor m_editor;
    QAction* m_refine = nullptr;
    QAction* m_refineAtAim = nullptr;
    QAction* m_simplify = nullptr;
    QAction* m_smooth = nullptr;
    QAction* m_apply = nullptr;
    QAction* m_separate = nullptr;
    QAction* m_scale = nullptr;
    QAction* m_upright = nullptr;
    QAction* m_onFloor = nullptr;
    QAction* m_turntable = nullptr;
};

}  // namespace hitscope
