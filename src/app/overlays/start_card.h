// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "viewport/inspect_tool.h"

class QAction;
class QLabel;
class QMenu;
class QSettings;

namespace hitscope {

class Session;
class Viewport;

/// What to do first, below the picture: shoot, inspect, export, open, samples. Shown from the first start on
/// until a shot is fired or it is closed, which is remembered; its action brings it back. After a shot it
/// says what comes next and stays until there is another scene: going, it would give its room to the picture,
/// which would jump under the cursor.
class StartCard : public QFrame {
    Q_OBJECT
public:
    /// The window's own actions and menu, which the card's buttons trigger; all outlive the card.
    struct Offers {
        QAction* inspect = nullptr;
        QAction* exportMesh = nullptr;
        QAction* open = nullptr;
        QMenu* samples = nullptr;
    };
    explicit StartCard(const Offers& offers, QWidget* parent = nullptr);

    /// Says what can be done next in this window. Both outlive the card.
    void follow(Viewport& viewport, const Session& session);

    /// Shows it unless it was dismissed before.
    void restore(const QSettings& settings);
    /// Shows or hides the card; checkable.
    [[nodiscard]] QAction* toggle() const { return m_toggle; }
    /// Hides it for this start and those to come.
    void dismiss();

private:
    void set(bool on);
    void setTool(Tool tool);
    void shotFired();
    void addOffer(QLayout& layout, QAction* action, const QString& text, const char* name);

    QAction* m_toggle;
    QLabel* m_words;
    bool m_hasShot = false;
    Tool m_tool = Tool::Shoot;
};

}  // namespace hitscope
