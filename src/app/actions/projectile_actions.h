// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMenu;
class QWidget;

namespace hitscope {

class Session;

/// What projectiles are and do: whether their bounces count, and the dialog with the rest.
class ProjectileActions : public QObject {
    Q_OBJECT
public:
    /// Both outlive this; the dialog belongs to `window`.
    ProjectileActions(Session& session, QWidget& window);

    void fill(QMenu& menu);  ///< once

private:
    void showDialog();

    Session& m_session;
    QWidget& m_window;
};

}  // namespace hitscope
