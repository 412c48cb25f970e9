// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/fields/context_menu.h"

#include <QMenu>
#include <QWidget>

namespace hitscope {

void showActionsAsMenu(QWidget& widget) {
    widget.setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(&widget, &QWidget::customContextMenuRequested, &widget, [&widget](const QPoint& at) {
        auto* menu = new QMenu(&widget);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->setToolTipsVisible(true);
        menu->addActions(widget.actions());
        menu->popup(widget.mapToGlobal(at));
    });
}

}  // namespace hitscope
