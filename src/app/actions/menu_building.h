// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>
#include <functional>

class QAction;
class QActionGroup;
class QMenu;
class QObject;

namespace hitscope {

/// Adds an action that does `act`, as long as `context` is there. `icon`: a name for themedIcon().
QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& keys, const QObject* context,
                   std::function<void()> act, const QString& icon = {});
/// One that is on or off.
QAction* addToggle(QMenu& menu, const QString& text, const QKeySequence& keys, bool on,
                   const QObject* context, std::function<void(bool)> act);
/// A checkable one in a group of which one is on.
QAction* addChoice(QMenu& menu, QActionGroup& group, const QString& text, bool on, const QObject* context,
                   std::function<void()> act);
/// One whose key the viewport handles itself, since it is held down; the menu shows it.
QAction* addHeldKey(QMenu& menu, const QString& text, const QString& key, const QObject* context,
                    std::function<void()> act);
/// A name as a menu shows it, with each "&" that is in it: else that would mark a key.
[[nodiscard]] QString menuText(QString name);

}  // namespace hitscope
