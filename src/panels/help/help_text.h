// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;
class QWidget;

namespace hitscope {

/// Enables or disables it. `why` is a sentence for its tooltip while it is disabled.
void enableIf(QAction& action, bool enabled, const QString& why);
void enableIf(QWidget& widget, bool enabled, const QString& why);

/// That sentence; of a widget also when one around it is disabled. Empty while enabled, or when nobody said.
[[nodiscard]] QString whyDisabled(const QAction& action);
[[nodiscard]] QString whyDisabled(const QWidget& widget);

/// What a tooltip says: what it is, its key, and why it is disabled.
[[nodiscard]] QString helpOf(const QAction& action);
/// Likewise; of a button with an action, that of the action.
[[nodiscard]] QString helpOf(const QWidget& widget);
/// In a menu, which shows name and key itself: what there is to say beyond; empty: nothing.
[[nodiscard]] QString menuHelpOf(const QAction& action);

}  // namespace hitscope
