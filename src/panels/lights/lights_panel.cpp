// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/lights/lights_panel.h"

#include <QSignalBlocker>
#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "panels/fields/number_box.h"
#include "panels/lights/colour_button.h"
#include "panels/lights/light_swatch_delegate.h"
#include "ui_lights.h"

namespace hitscope {

namespace {

constexpr double kDegrees = 57.29577951308232;
constexpr float kLeastEdge = 0.00873f;       // radians, half a degree: the cone's edge stays smooth
constexpr double kFarthestLight = 1.0e7;     // metres
constexpr double kMostAttenuation = 1.0e15;  // that of a scene of micrometres

}  // namespace

LightsPanel::LightsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_model(session), m_ui(std::make_unique<Ui::LightsForm>()) {
    m_ui->setupUi(this);
    m_ui->list->setModel(&m_model);
    m_ui->list->setItemDelegate(new LightSwatchDelegate(m_ui->list));
    m_ui->list->setCurrentIndex(m_model.index(DirectionalRow));
    const int rows = m_ui->list->sizeHintForRow(0) * LightRowCount;
    m_ui->list->setFixedHeight(rows + 2 * m_ui->list->frameWidth());
    makeFields();
    setRanges();
    connect(m_ui->list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &LightsPanel::showLight);
    connect(m_ui->list->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this] { m_gesture.end(); });
    makeColour();
    connect(m_ui->atEye, &QCheckBox::toggled, this,
            [this](bool on) { change([on](Lights& lights) { lights.spot.atEye = on; }); });
    connect(m_ui->reset, &QPushButton::clicked, this,
            [this] { m_session.settings().setLights(defaultLights(m_session.settings().lightSpace())); });
    connect(&session.settings(), &SessionSettings::lightsChanged, this, &LightsPanel::showLight);
    showLight();
}

LightsPanel::~LightsPanel() = default;

int LightsPanel::row() const {
    return std::max(m_ui->list->currentIndex().row(), 0);
}

/// What is tried is no step of its own: the colour that is taken is one, and none is left without it.
void LightsPanel::makeColour() {
    const auto linear = [](const QColor& colour) {
        return linearColour(colour.redF(), colour.greenF(), colour.blueF());
    };
    m_ui->colour->setDialogTitle(tr("Colour of the Light"));
    connect(m_ui->colour, &ColourButton::colourTried, this, [this, linear](const QColor& colour) {
        if (!m_untried) {
            Lights lights = m_session.settings().lights();
            m_untried = lightTerms(lights, row()).colour;
        }
        tint(linear(colour));
    });
    connect(m_ui->colour, &ColourButton::cancelled, this, &LightsPanel::endTrial);
    connect(m_ui->colour, &ColourButton::colourPicked, this, [this, linear](const QColor& colour) {
        if (m_untried) {
            endTrial();
            change([this, &colour, linear](Lights& lights) {
                lightTerms(lights, row()).colour = linear(colour);
            });
        }
    });
}

void LightsPanel::tint(const glm::vec3& colour) {
    Lights lights = m_session.settings().lights();
    lightTerms(lights, row()).colour = colour;
    m_session.settings().restoreLights(lights);
}

void LightsPanel::endTrial() {
    if (const std::optional<glm::vec3> untried = std::exchange(m_untried, std::nullopt)) {
        tint(*untried);
    }
}

void LightsPanel::makeFields() {
    const auto term = [](float LightTerms::*part) {
        return [part](Lights& lights, int row) { return &(lightTerms(lights, row).*part); };
    };
    addField(m_ui->diffuse, term(&LightTerms::diffuse));
    addField(m_ui->ambient, term(&LightTerms::ambient));
    addField(m_ui->specular, term(&LightTerms::specular));
    addPoint({m_ui->positionX, m_ui->positionY, m_ui->positionZ}, lightPosition);
    addPoint({m_ui->directionX, m_ui->directionY, m_ui->directionZ}, lightDirection);
    const auto factor = [](float Attenuation::*part) {
        return [part](Lights& lights, int row) {
            Attenuation* attenuation = lightAttenuation(lights, row);
            return attenuation != nullptr ? &(attenuation->*part) : nullptr;
        };
    };
    addField(m_ui->constant, factor(&Attenuation::constant));
    addField(m_ui->linear, factor(&Attenuation::linear));
    addField(m_ui->quadratic, factor(&Attenuation::quadratic));
    const auto angle = [](float SpotLight::*part) {
        return [part](Lights& lights, int row) { return row == SpotRow ? &(lights.spot.*part) : nullptr; };
    };
    addField(m_ui->innerAngle, angle(&SpotLight::innerAngle), kDegrees);
    addField(m_ui->outerAngle, angle(&SpotLight::outerAngle), kDegrees);
}

void LightsPanel::addPoint(QDoubleSpinBox* const (&boxes)[3], glm::vec3* (*point)(Lights&, int)) {
    for (int axis = 0; axis < 3; ++axis) {
        addField(boxes[axis], [point, axis](Lights& lights, int row) -> float* {
            glm::vec3* found = point(lights, row);
            return found != nullptr ? &(*found)[axis] : nullptr;
        });
    }
}

void LightsPanel::addField(QDoubleSpinBox* box, Value value, double scale) {
    box->setKeyboardTracking(false);  // what is typed can be dropped
    m_fields.push_back({box, qobject_cast<NumberBox*>(box), std::move(value), scale});
    const std::size_t index = m_fields.size() - 1;
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, index](double shown) { changeField(m_fields[index], shown); });
    connect(box, &QDoubleSpinBox::editingFinished, this, [this] { m_gesture.end(); });
}

void LightsPanel::change(const std::function<void(Lights&)>& change, SessionUndo::Merge merge) {
    Lights lights = m_session.settings().lights();
    change(lights);
    m_session.settings().setLights(lights, merge);
}

void LightsPanel::changeField(const Field& field, double shown) {
    change(
        [this, &field, shown](Lights& lights) {
            if (float* value = field.value(lights, row())) {
                *value = static_cast<float>(shown / field.scale);
            }
            // The cone's other angle gives way.
            SpotLight& spot = lights.spot;
            if (field.box == m_ui->innerAngle) {
                spot.outerAngle = std::max(spot.outerAngle, spot.innerAngle + kLeastEdge);
            } else if (field.box == m_ui->outerAngle) {
                spot.innerAngle = std::clamp(spot.innerAngle, 0.0f, spot.outerAngle - kLeastEdge);
            }
        },
        m_gesture.change(static_cast<int>(&field - m_fields.data())));
}

void LightsPanel::showLight() {
    Lights lights = m_session.settings().lights();
    setSteps(lights);
    for (const Field& field : m_fields) {
        const float* value = field.value(lights, row());
        // What is being typed is not replaced by its rounded self.
        if (value != nullptr && static_cast<float>(field.box->value() / field.scale) != *value) {
            const QSignalBlocker quiet(field.box);
            const double shown = static_cast<double>(*value) * field.scale;
            field.ofAnySize != nullptr ? field.ofAnySize->showNumber(shown) : field.box->setValue(shown);
        }
    }
    m_ui->colour->setColour(QColor(colourName(lightTerms(lights, row()).colour)));
    const QSignalBlocker quiet(m_ui->atEye);
    m_ui->atEye->setChecked(lights.spot.atEye);
    showRows(lights);
}

void LightsPanel::setRanges() {
    for (NumberBox* box : {m_ui->positionX, m_ui->positionY, m_ui->positionZ, m_ui->directionX,
                           m_ui->directionY, m_ui->directionZ}) {
        box->setRange(-kFarthestLight, kFarthestLight);
    }
    for (NumberBox* box : {m_ui->positionX, m_ui->positionY, m_ui->positionZ}) {
        box->setUnit(QStringLiteral("m"));
    }
    m_ui->linear->setRange(0.0, kMostAttenuation);
    m_ui->quadratic->setRange(0.0, kMostAttenuation);
    for (const Field& field : m_fields) {
        if (field.ofAnySize != nullptr) {  // else three of them would make the dock wide
            field.ofAnySize->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        }
    }
}

/// By the size of the scene: light that fades over a small one has a great attenuation.
void LightsPanel::setSteps(Lights& lights) {
    const auto extent = static_cast<double>(m_session.settings().lightSpace().extent);
    for (NumberBox* box : {m_ui->positionX, m_ui->positionY, m_ui->positionZ}) {
        box->setStepsWithin(extent);
    }
    if (const glm::vec3* direction = lightDirection(lights, row())) {
        for (NumberBox* box : {m_ui->directionX, m_ui->directionY, m_ui->directionZ}) {
            box->setStepsWithin(static_cast<double>(glm::length(*direction)));
        }
    }
    m_ui->linear->setStepsWithin(1.0 / extent);
    m_ui->quadratic->setStepsWithin(1.0 / (extent * extent));
}

void LightsPanel::showRows(const Lights& lights) {
    const bool isSpot = row() == SpotRow;
    const bool isDirectional = row() == DirectionalRow;
    const bool isFixed = !isSpot || !lights.spot.atEye;
    m_ui->form->setRowVisible(m_ui->atEye, isSpot);
    m_ui->form->setRowVisible(m_ui->coneRow, isSpot);
    m_ui->form->setRowVisible(m_ui->positionRow, isFixed && !isDirectional);
    m_ui->form->setRowVisible(m_ui->directionRow, isFixed && (isSpot || isDirectional));
    m_ui->form->setRowVisible(m_ui->attenuationRow, !isDirectional);
}

}  // namespace hitscope
