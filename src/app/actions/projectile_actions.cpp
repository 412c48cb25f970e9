// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/projectile_actions.h"

#include <QAction>
#include <QMenu>

#include "app/actions/menu_building.h"
#include "app/dialogs/projectile_dialog.h"
#include "session/session.h"

namespace hitscope {

ProjectileActions::ProjectileActions(Session& session, QWidget& window)
    : QObject(&window), m_session(session), m_window(window) {}

void ProjectileActions::fill(QMenu& menu) {
    QAction* bounces = addToggle(menu, tr("&Bounces Count as Hits"), {},
                                 m_session.settings().projectile().bouncesCount, this, [this](bool on) {
                                     ProjectileSettings settings = m_session.settings().projectile();
                                     settings.bouncesCount = on;
                                     m_session.settings().setProjectile(settings);
                                 });
    addAction(menu, tr("&Projectile…"), {}, this, [this] { showDialog(); });
    connect(&m_session.settings(), &SessionSettings::projectileChanged, this,
            [this, bounces] { bounces->setChecked(m_session.settings().projectile().bouncesCount); });
}

void ProjectileActions::showDialog() {
    auto* dialog = m_window.findChild<ProjectileDialog*>();
    if (dialog == nullptr) {
        dialog = new ProjectileDialog(m_session, &m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

}  // namespace hitscope
