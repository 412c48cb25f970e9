// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "viewport/navigation_preset.h"

class QAction;
class QMainWindow;

namespace hitscope {

struct KeysLine {
    QString keys;
    QString meaning;
};
struct KeysSection {
    QString title;
    std::vector<KeysLine> lines;
};

/// What mouse and trackpad do in the viewport, as the navigation preset has it.
[[nodiscard]] KeysSection mouseKeys(NavigationPreset preset, OrbitMode mode);

/// Keys that the viewport handles itself, since they may be held down: no action knows them.
[[nodiscard]] KeysSection heldKeys();

/// The shortcuts of a window's actions as they are now: a section a menu, then one for each dock that has
/// keys of its own.
[[nodiscard]] std::vector<KeysSection> actionKeys(const QMainWindow& window);

/// Lists the action under other keys and words than its own: one line for several actions.
void listKeysAs(QAction& action, const QString& keys, const QString& meaning);
/// Another line stands for this action.
void leaveOutOfKeys(QAction& action);

}  // namespace hitscope
