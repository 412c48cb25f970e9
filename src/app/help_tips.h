// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace hitscope {

/// Shows the tooltips of actions, in menus and on buttons, and of what is disabled: helpOf() and
/// menuHelpOf(), worked out when they are shown, so that they are true then. The others are left to Qt.
class HelpTips : public QObject {
    Q_OBJECT
public:
    /// Watches the whole application while it lives.
    explicit HelpTips(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hitscope
