// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <functional>
#include <utility>
#include <vector>

#include "analysis/scene_sections.h"
#include "session/once_a_turn.h"
#include "session/session_undo.h"

class QAction;
class QMenu;

namespace hitscope {

class Comparison;
class CutHandle;
class CuttingPlanePanel;
class Viewport;

/// Everything about the cutting plane: its section, the dock, the handle in the picture, the menu and its
/// keys. The session has the plane, so that it can be undone; the viewport's options follow it.
class CutActions : public QObject {
    Q_OBJECT
public:
    /// All outlive this, or are children of the same parent. The panel is for a dock.
    CutActions(Session& session, Comparison& comparison, Viewport& viewport, QObject* parent);

    [[nodiscard]] CuttingPlanePanel* panel() { return m_panel; }
    [[nodiscard]] QAction* toggle() { return m_on; }  ///< for a tool bar
    void fill(QMenu& menu);                           ///< once
    [[nodiscard]] const SceneSections& sections() const { return m_sections; }

Q_SIGNALS:
    void switchedOn();  ///< by somebody, for the first time

private:
    void change(const std::function<void(CuttingPlane&)>& edit,
                SessionUndo::Merge merge = SessionUndo::Merge::Never);
    [[nodiscard]] float middleAlong(const glm::vec3& normal) const;
    [[nodiscard]] CuttingPlane switched(bool on) const;
    [[nodiscard]] CuttingPlane along(const glm::vec3& normal, bool flipped) const;
    void setOn(bool on);
    void chooseNormal(const glm::vec3& normal, bool flipped);
    void slide(const CuttingPlane& cut, int part);
    void endSliding();
    void cutAlong(const glm::vec3& normal, bool flipped);
    void sayOn();
    void cutFromView();
    void reset();
    void followScene();
    void followSession();
    void followComparison();
    void follow();
    void show();
    void cutTargets();
    void showPane();
    QAction* addToggle(QMenu& menu, const QString& text, bool CuttingPlane::*option);

    Session& m_session;
    Comparison& m_comparison;
    Viewport& m_viewport;
    SceneSections m_sections;
    SceneSections m_otherSections;  ///< as the second pipeline has the targets, where it is shown too
    CuttingPlanePanel* m_panel;
    CutHandle* m_handle;
    QAction* m_on;
    std::vector<std::pair<QAction*, bool CuttingPlane::*>> m_toggles;
    bool m_isPlaced = false;    ///< somebody has put the plane where it is, in this scene
    bool m_wasOn = false;       ///< once
    bool m_handled = false;     ///< the cursor is at the handle
    bool m_sliding = false;     ///< the dock's slider is held
    bool m_isChanging = false;  ///< the session's plane, here
    UndoGesture m_gesture;
    OnceATurn m_showing{[this] { show(); }};
};

}  // namespace hitscope
