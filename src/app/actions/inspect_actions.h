// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "session/session.h"

class QAction;
class QActionGroup;
class QMenu;
class QSettings;
class QToolBar;

namespace hitscope {

class InspectTool;
class Viewport;

/// The actions of the viewport's tools: Shoot, Inspect, Brush or Move, and how Inspect selects. Its choices
/// are remembered.
class InspectActions : public QObject {
    Q_OBJECT
public:
    /// All outlive this but `parent`.
    InspectActions(Session& session, Viewport& viewport, QObject* parent);

    void fill(QMenu& menu);
    void fill(QToolBar& bar);
    void save(QSettings& settings) const;
    /// Takes the Inspect tool.
    [[nodiscard]] QAction* inspect() const { return m_inspect; }

private:
    QAction* addTool(const QString& text, const QString& toolTip, const QString& icon);
    void load(const QSettings& settings);
    void selectAllChanged();
    void follow();

    Session& m_session;
    Viewport& m_viewport;
    InspectTool& m_tool;
    QActionGroup* m_tools;
    QAction* m_shoot = nullptr;
    QAction* m_inspect = nullptr;
    QAction* m_brush = nullptr;
    QAction* m_move = nullptr;
    QAction* m_toggle = nullptr;
    QActionGroup* m_outlines;
    QAction* m_rectangle = nullptr;
    QAction* m_lasso = nullptr;
    QAction* m_hidden = nullptr;
    QAction* m_all = nullptr;
    QAction* m_none = nullptr;
};

}  // namespace hitscope
