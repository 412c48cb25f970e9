// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace hitscope {

/// Shows the widget's actions as its context menu, as Qt::ActionsContextMenu does, and with their tool tips:
/// those of disabled actions say why.
void showActionsAsMenu(QWidget& widget);

}  // namespace hitscope
