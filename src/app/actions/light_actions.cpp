// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/light_actions.h"

#include <QAction>
#include <QMenu>
#include <algorithm>

#include "app/actions/menu_building.h"
#include "panels/help/help_text.h"
#include "session/session.h"

namespace hitscope {

LightActions::LightActions(Session& session, QObject* parent) : QObject(parent), m_session(session) {}

void LightActions::fill(QMenu& menu) {
    m_directional = addToggle(menu, tr("&Directional"), Qt::Key_G, true, this, [this](bool on) {
        change([on](Lights& lights) { lights.directional.on = on; });
    });
    m_points = addToggle(menu, tr("&Point Lights"), Qt::Key_H, true, this, [this](bool on) {
        change([on](Lights& lights) {
            for (PointLight& light : lights.points) {
                light.on = on;
            }
        });
    });
    m_spot = addToggle(menu, tr("&Spotlight"), Qt::Key_J, true, this,
                       [this](bool on) { change([on](Lights& lights) { lights.spot.on = on; }); });
    connect(&m_session.settings(), &SessionSettings::lightsChanged, this, &LightActions::follow);
    follow();
}

void LightActions::setEnvironment(bool on) {
    for (QAction* action : {m_directional, m_points, m_spot}) {
        enableIf(*action, !on, tr("The environment lights the scene: View > Shading > Environment Light."));
    }
}

void LightActions::change(const std::function<void(Lights&)>& how) {
    Lights lights = m_session.settings().lights();
    how(lights);
    m_session.settings().setLights(lights);
}

void LightActions::follow() {
    const Lights& lights = m_session.settings().lights();
    m_directional->setChecked(lights.directional.on);
    m_points->setChecked(std::any_of(lights.points.begin(), lights.points.end(),
                                     [](const PointLight& light) { return light.on; }));
    m_spot->setChecked(lights.spot.on);
}

}  // namespace hitscope
