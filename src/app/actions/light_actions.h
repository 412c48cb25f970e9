// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "view/lights.h"

class QAction;
class QMenu;

namespace hitscope {

class Session;

/// The kinds of light, on and off.
class LightActions : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit LightActions(Session& session, QObject* parent = nullptr);

    void fill(QMenu& menu);  ///< once
    /// Whether the environment takes the place of these lights.
    void setEnvironment(bool on);

private:
    void change(const std::function<void(Lights&)>& how);
    void follow();

    Session& m_session;
    QAction* m_directional = nullptr;
    QAction* m_points = nullptr;
    QAction* m_spot = nullptr;
};

}  // namespace hitscope
