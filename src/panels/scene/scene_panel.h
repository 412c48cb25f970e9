// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "models/scene_model.h"
#include "session/once_a_turn.h"
#include "session/primitive_target.h"

class QAction;
class QItemSelection;
class QMenu;

namespace Ui {
class Scene;
}

namespace hitscope {

/// The dock "Scene": a row a target, with an eye that hides it and a name that can be edited. The current
/// row's target is the one selected in the viewport. The selected ones can be duplicated, hidden, reset and
/// removed, from the buttons, the context menu or by key; below is where the current one stands.
class ScenePanel : public QWidget {
    Q_OBJECT
public:
    /// `session` and `model` outlive the panel.
    ScenePanel(Session& session, SceneModel& model, QWidget* parent = nullptr);
    ~ScenePanel() override;

    /// What can be added, for the window's menus too.
    [[nodiscard]] QMenu* addMenu() const { return m_addMenu; }
    /// What can be done to the selected targets, with their keys: for who else shows the selection.
    [[nodiscard]] QList<QAction*> targetActions() const;

Q_SIGNALS:
    /// A target of that name shall be added; `make` may take seconds and be called on any thread.
    void targetWanted(const QString& name, const std::function<hitscope::TargetPlan()>& make);
    void filesWanted();              ///< targets from files shall be added
    void said(const QString& text);  ///< what was done

private:
    void setUpTable();
    void makeAddMenu();
    void makeActions();
    QAction* makeAction(const QString& name, const QString& text, const QKeySequence& key,
                        void (ScenePanel::*act)());
    void addPrimitive(PrimitiveKind kind);
    void selectAll();
    void duplicateSelected();
    [[nodiscard]] QString nameOf(const std::vector<TargetId>& targets) const;
    void removeSelected();
    void resetSelected();
    void toggleSelected();
    void renameCurrent();
    void showSelectedTarget();  ///< session -> table
    void followSelection();     ///< table -> session
    void updateActions();
    [[nodiscard]] std::vector<TargetId> selectedTargets() const;  ///< in the list's order
    [[nodiscard]] QItemSelection rowsOfSelected() const;
    [[nodiscard]] bool isAnyVisible(const std::vector<TargetId>& targets) const;

    Session& m_session;
    SceneModel& m_model;
    std::unique_ptr<Ui::Scene> m_ui;
    QMenu* m_addMenu = nullptr;
    QAction* m_rename = nullptr;
    QAction* m_duplicate = nullptr;
    QAction* m_toggle = nullptr;
    QAction* m_reset = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_selectAll = nullptr;
    bool m_following = false;
    OnceATurn m_updating{[this] { updateActions(); }};
};

}  // namespace hitscope
