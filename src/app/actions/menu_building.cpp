// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/menu_building.h"

#include <QActionGroup>
#include <QMenu>
#include <utility>

#include "panels/icons/themed_icon.h"

namespace hitscope {

QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& keys, const QObject* context,
                   std::function<void()> act, const QString& icon) {
    QAction* action = menu.addAction(text);
    action->setShortcut(keys);
    if (!icon.isEmpty()) {
        action->setIcon(themedIcon(icon));
    }
    QObject::connect(action, &QAction::triggered, context, [run = std::move(act)] { run(); });
    return action;
}

QAction* addToggle(QMenu& menu, const QString& text, const QKeySequence& keys, bool on,
                   const QObject* context, std::function<void(bool)> act) {
    QAction* action = menu.addAction(text);
    action->setShortcut(keys);
    action->setCheckable(true);
    action->setChecked(on);
    QObject::connect(action, &QAction::triggered, context,
                     [run = std::move(act)](bool checked) { run(checked); });
    return action;
}

QAction* addChoice(QMenu& menu, QActionGroup& group, const QString& text, bool on, const QObject* context,
                   std::function<void()> act) {
    QAction* action = addToggle(menu, text, {}, on, context, [run = std::move(act)](bool) { run(); });
    group.addAction(action);
    return action;
}

QAction* addHeldKey(QMenu& menu, const QString& text, const QString& key, const QObject* context,
                    std::function<void()> act) {
    return addAction(menu, text + u'\t' + key, {}, context, std::move(act));
}

QString menuText(QString name) {
    return name.replace(u'&', QLatin1String("&&"));
}

}  // namespace hitscope
