// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "session/session.h"

class QAction;
class QActionGroup;
class QDoubleSpinBox;
class QMenu;
class QToolBar;
class QWidget;

namespace hitscope {

/// Pause, single step, slow motion, time scale and physics step, for menu and tool bar.
class TimeActions : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit TimeActions(Session& session, QObject* parent = nullptr);

    void fill(QMenu& menu);    ///< once
    void fill(QToolBar& bar);  ///< once

    static constexpr double kSlowMotion = 0.1;  ///< time scale

Q_SIGNALS:
    void numberTyped();  ///< in the tool bar: the keys are expected elsewhere next

private:
    QAction* makeAction(const QString& text, const QKeySequence& key, const QString& icon);
    void fillStepMenu(QMenu& menu);
    void stepOnce();
    void follow();

    Session& m_session;
    QAction* m_pause = nullptr;
    QAction* m_step = nullptr;
    QAction* m_slow = nullptr;
    QActionGroup* m_steps = nullptr;
    QDoubleSpinBox* m_scale = nullptr;
};

}  // namespace hitscope
