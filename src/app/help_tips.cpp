// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_tips.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QMenu>
#include <QToolButton>
#include <QToolTip>

#include "panels/help/help_text.h"
#include "viewport/axis_gizmo.h"

namespace hitscope {

namespace {

/// Empty: Qt knows better.
QString toolTipOf(const QWidget& widget, const QPoint& at) {
    if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        const QAction* action = menu->actionAt(at);
        return action != nullptr ? menuHelpOf(*action) : QString();
    }
    if (const auto* axes = qobject_cast<const AxisGizmo*>(&widget)) {
        const auto view = axes->endAt(at);
        const QAction* action = view ? axes->action(*view) : nullptr;
        return action != nullptr ? helpOf(*action) : QString();
    }
    const auto* button = qobject_cast<const QToolButton*>(&widget);
    const bool isOurs = button != nullptr && button->defaultAction() != nullptr;
    return isOurs || !whyDisabled(widget).isEmpty() ? helpOf(widget) : QString();
}

}  // namespace

HelpTips::HelpTips(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool HelpTips::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ToolTip || !watched->isWidgetType()) {
        return false;
    }
    auto* widget = static_cast<QWidget*>(watched);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text = toolTipOf(*widget, help->pos());
    if (text.isEmpty()) {
        return false;
    }
    QToolTip::showText(help->globalPos(), text, widget);
    return true;
}

}  // namespace hitscope
