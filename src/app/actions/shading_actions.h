// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <span>
#include <vector>

#include "view/display_options.h"

class QAction;
class QMenu;

namespace hitscope {

using DisplayOption = bool DisplayOptions::*;

/// A way to draw surfaces that is on or off.
struct ShadingSwitch {
    const char* key;   ///< in the settings
    const char* text;  ///< to be translated, as are those below
    const char* toolTip;
    const char* shortcut;
    DisplayOption option;
    bool first;  ///< whether it is on when the program starts for the first time
};

[[nodiscard]] std::span<const ShadingSwitch> shadingSwitches();

/// The menu of them.
class ShadingActions : public QObject {
    Q_OBJECT
public:
    explicit ShadingActions(QObject* parent = nullptr);

    void fill(QMenu& menu);                    ///< once
    void show(const DisplayOptions& options);  ///< emits nothing
    /// There is no such way to draw here; why: a sentence.
    void disable(DisplayOption option, const QString& why);

Q_SIGNALS:
    void switched(hitscope::DisplayOption option, bool on);

private:
    std::vector<QAction*> m_actions;  ///< one a switch
};

}  // namespace hitscope
