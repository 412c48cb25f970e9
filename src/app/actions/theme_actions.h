// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMenu;

namespace hitscope {

struct AppSettings;
class Viewport;

/// The window's theme and the picture's background.
class ThemeActions : public QObject {
    Q_OBJECT
public:
    /// Both outlive this. Applies the settings' theme.
    ThemeActions(AppSettings& settings, Viewport& viewport, QObject* parent = nullptr);

    void fill(QMenu& menu);  ///< once
    /// The picture's background, to the window's where it goes by that; also when the palette has changed.
    void followWindow();

private:
    AppSettings& m_settings;
    Viewport& m_viewport;
};

}  // namespace hitscope
