// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>
#include <memory>
#include <optional>

#include "session/session.h"

class QDoubleSpinBox;

namespace Ui {
class ProjectileSettings;
}

namespace hitscope {

/// How projectiles are shot; what is set holds for the next shot, so the dialog can stay open.
class ProjectileDialog : public QDialog {
    Q_OBJECT
public:
    /// `session` outlives the dialog.
    explicit ProjectileDialog(Session& session, QWidget* parent = nullptr);
    ~ProjectileDialog() override;

private:
    void makeColour();
    void tint(const glm::vec3& colour);  ///< for the moment: nothing to undo
    void endTrial();
    void showSettings();
    void apply();
    void showInForce();

    Session& m_session;
    std::unique_ptr<Ui::ProjectileSettings> m_ui;
    std::array<QDoubleSpinBox*, 8> m_numbers{};  ///< in the order of projectileParameters()
    bool m_showing = false;
    std::optional<glm::vec3> m_untried;  ///< the colour before others are tried; none is
};

}  // namespace hitscope
