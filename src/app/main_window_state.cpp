// SPDX-License-Identifier: GPL-3.0-or-later
// What of the window outlives it: its settings, and how it ends.
#include <QCloseEvent>
#include <QScreen>
#include <QSettings>
#include <QStyle>

#include "app/actions/camera_actions.h"
#include "app/actions/hit_actions.h"
#include "app/actions/inspect_actions.h"
#include "app/dialogs/texture_chooser.h"
#include "app/discard_guard.h"
#include "app/full_view.h"
#include "app/main_window.h"
#include "app/scene_files.h"
#include "app/settings/settings_keeper.h"
#include "panels/frame_rate/frame_rate_panel.h"
#include "panels/mesh_statistics/mesh_statistics_panel.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kLayoutVersion = 5;  // docks that are gone or new make an old layout useless

}  // namespace

void MainWindow::restoreWindow() {
    // On a small screen no part of it is out of sight at first.
    // The desktop's frame comes on top, and is not known before it does.
    const int frame = style()->pixelMetric(QStyle::PM_TitleBarHeight);
    resize(QSize(1440, 900).boundedTo(screen()->availableSize() - QSize(0, frame)));
    m_firstLayout = saveState(kLayoutVersion);
    const QSettings settings;
    m_frameRate->restoreState(settings.value(QStringLiteral("window/frameRate")).toByteArray());
    m_statisticsPanel->restoreState(settings.value(QStringLiteral("window/meshStatistics")).toByteArray());
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/layout")).toByteArray(), kLayoutVersion);
}

void MainWindow::resetLayout() {
    restoreState(m_firstLayout, kLayoutVersion);
}

void MainWindow::saveSettings(QSettings& settings) {
    if (!m_fullView->isOn()) {  // what is remembered is the window with all its parts
        settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
        settings.setValue(QStringLiteral("window/layout"), saveState(kLayoutVersion));
    }
    settings.setValue(QStringLiteral("window/frameRate"), m_frameRate->saveState());
    settings.setValue(QStringLiteral("window/meshStatistics"), m_statisticsPanel->saveState());
    m_cameraActions->save(settings);
    m_settings.display = m_viewport->options();
    m_settings.coverTexture = m_textureChooser->chosen();
    m_settings.stretchLimit = static_cast<double>(m_meshStatistics.measuring().stretchLimit());
    saveAppSettings(settings, m_settings);
    m_hitActions->save(settings);
    saveSessionSettings(settings, m_session);
    m_inspect->save(settings);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (m_guard->isAtRisk()) {
        event->ignore();
        m_guard->ask([this] {
            m_guard->letGo();
            close();
        });
        return;
    }
    endInOrder();
    event->accept();
}

void MainWindow::endInOrder() {
    m_files->cancel();
    m_fullView->set(false);
    m_keeper->saveNow();
}

}  // namespace hitscope
