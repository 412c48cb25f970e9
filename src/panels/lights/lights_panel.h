// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <memory>

#include "session/session.h"

class QCheckBox;
class QDoubleSpinBox;
class QSlider;

namespace Ui {
class LightsForm;
}

namespace hitscope {

class ColourButton;

/// The dock "Lights": each kind of light on or off, its diffuse colour and intensity. The four point lights
/// are set together.
class LightsPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel.
    explicit LightsPanel(Session& session, QWidget* parent = nullptr);
    ~LightsPanel() override;

private:
    enum Kind : std::size_t { Directional, Points, Spot, KindCount };
    struct Row {
        QCheckBox* on = nullptr;
        ColourButton* colour = nullptr;
        QSlider* slider = nullptr;
        QDoubleSpinBox* intensity = nullptr;
    };

    void connectRow(Kind kind);
    void showLights();
    void applyRow(Kind kind);
    void reset();

    Session& m_session;
    std::unique_ptr<Ui::LightsForm> m_ui;
    std::array<Row, KindCount> m_rows;
    bool m_applying = false;
};

}  // namespace hitscope
