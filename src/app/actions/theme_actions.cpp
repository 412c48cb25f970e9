// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/theme_actions.h"

#include <QActionGroup>
#include <QMenu>
#include <utility>

#include "app/actions/menu_building.h"
#include "app/settings/app_settings.h"
#include "app/theme.h"
#include "viewport/viewport.h"

namespace hitscope {

ThemeActions::ThemeActions(AppSettings& settings, Viewport& viewport, QObject* parent)
    : QObject(parent), m_settings(settings), m_viewport(viewport) {
    applyTheme(settings.theme);
}

void ThemeActions::fill(QMenu& menu) {
    QMenu& window = *menu.addMenu(tr("&Theme"));
    auto* themes = new QActionGroup(this);
    const std::pair<QString, ThemeChoice> choices[] = {{tr("&Follow Desktop"), ThemeChoice::System},
                                                       {tr("&Light"), ThemeChoice::Light},
                                                       {tr("&Dark"), ThemeChoice::Dark}};
    for (const auto& [name, choice] : choices) {
        addChoice(window, *themes, name, m_settings.theme == choice, this, [this, chosen = choice] {
            m_settings.theme = chosen;
            applyTheme(chosen);
            followWindow();
        });
    }
    QMenu& viewport = *menu.addMenu(tr("Viewport &Background"));
    auto* backgrounds = new QActionGroup(this);
    const std::pair<QString, std::optional<Theme>> shades[] = {
        {tr("Follow &Window"), std::nullopt}, {tr("&Light"), Theme::Light}, {tr("&Dark"), Theme::Dark}};
    for (const auto& [name, shade] : shades) {
        addChoice(viewport, *backgrounds, name, m_settings.viewportTheme == shade, this,
                  [this, chosen = shade] {
                      m_settings.viewportTheme = chosen;
                      followWindow();
                  });
    }
}

void ThemeActions::followWindow() {
    DisplayOptions display = m_viewport.options();
    display.theme = m_settings.viewportTheme.value_or(isDark(m_viewport.window()->palette()) ? Theme::Dark
                                                                                             : Theme::Light);
    m_viewport.setOptions(display);
}

}  // namespace hitscope
