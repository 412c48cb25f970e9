// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

#include "app/theme.h"
#include "session/session.h"
#include "view/display_options.h"

class QSettings;

namespace hitscope {

/// What is remembered from one start to the next, apart from the window's own geometry. What was never saved,
/// or no longer makes sense, is as on the first start.
struct AppSettings {
    ThemeChoice theme = ThemeChoice::System;
    std::optional<Theme> viewportTheme;  ///< nothing: as the window
    DisplayOptions display;
    int coverTexture = 0;                     ///< TextureChooser::chosen()
    std::optional<NormalMode> exportNormals;  ///< nothing: those on the screen
    double stretchLimit = 2.0;                ///< mesh health: length now over length before
    QStringList recentFiles;                  ///< newest first
    QString folder;                           ///< where the last file was opened or saved

    static constexpr int kMostRecentFiles = 10;
    void addRecentFile(const QString& path);
};

inline constexpr const char* kRecentFilesKey = "recentFiles";
/// Of this window and of others, newest first. `before`: those that both began with; who has cleared one of
/// them decides for both. No more than kMostRecentFiles.
[[nodiscard]] QStringList mergedRecentFiles(const QStringList& mine, const QStringList& before,
                                            const QStringList& theirs);

[[nodiscard]] AppSettings loadAppSettings(const QSettings& settings);
void saveAppSettings(QSettings& settings, const AppSettings& values);

/// The session's settings: pipeline, lights, deformation constants, projectiles; not its scene or hits.
void loadSessionSettings(const QSettings& settings, Session& session);
void saveSessionSettings(QSettings& settings, const Session& session);

}  // namespace hitscope
