// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "models/lights_model.h"

class QDoubleSpinBox;

namespace Ui {
class LightsForm;
}

namespace hitscope {

class NumberBox;

/// The dock "Lights": a list of all six with a switch each, and below it what the chosen one is made of,
/// edited live.
class LightsPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel.
    explicit LightsPanel(Session& session, QWidget* parent = nullptr);
    ~LightsPanel() override;

private:
    /// A number of the chosen light; null: it has none.
    using Value = std::function<float*(Lights&, int row)>;
    struct Field {
        QDoubleSpinBox* box = nullptr;
        NumberBox* ofAnySize = nullptr;  ///< the same, where it is one
        Value value;
        double scale = 1.0;  ///< what is shown over what is kept
    };

    void makeColour();
    void tint(const glm::vec3& colour);  ///< the chosen light, for the moment: nothing to undo
    void endTrial();
    void makeFields();
    void addField(QDoubleSpinBox* box, Value value, double scale = 1.0);
    void setRanges();
    void setSteps(Lights& lights);
    void addPoint(QDoubleSpinBox* const (&boxes)[3], glm::vec3* (*point)(Lights&, int));
    [[nodiscard]] int row() const;
    void change(const std::function<void(Lights&)>& change,
                SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void changeField(const Field& field, double shown);
    void showLight();
    void showRows(const Lights& lights);

    Session& m_session;
    UndoGesture m_gesture;
    LightsModel m_model;
    std::unique_ptr<Ui::LightsForm> m_ui;
    std::vector<Field> m_fields;
    std::optional<glm::vec3> m_untried;  ///< the light's colour before others are tried; none is
};

}  // namespace hitscope
