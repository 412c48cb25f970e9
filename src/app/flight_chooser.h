// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "session/session.h"

class QActionGroup;
class QComboBox;
class QMenu;

namespace hitscope {

/// The choice between flight modes: in the Shoot menu, and in a box for the tool bar and the projectile
/// dialog. What is chosen is kept in the application's settings at once.
class FlightChooser : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this. Takes the mode from the settings.
    FlightChooser(Session& session, QObject* parent);

    void fill(QMenu& menu);  ///< once
    /// For the tool bar; once.
    [[nodiscard]] QComboBox* makeBox(QWidget* parent);

Q_SIGNALS:
    void chosenInBox();

private:
    void follow();

    Session& m_session;
    QActionGroup* m_actions;
    QComboBox* m_box = nullptr;
};

/// A box of all flight modes that follows the session and sets it. `session` outlives it.
[[nodiscard]] QComboBox* makeFlightBox(Session& session, QWidget* parent);

}  // namespace hitscope
