// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/lights/lights_panel.h"

#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/lights/colour_button.h"
#include "ui_lights.h"

namespace hitscope {

namespace {

constexpr double kSliderScale = 100.0;  // slider steps a unit of intensity

/// sRGB's transfer function: lights are linear, colours on buttons are not.
double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decoded(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

QColor toColour(const glm::vec3& linear) {
    const auto part = [](float value) {
        return static_cast<float>(std::clamp(encoded(static_cast<double>(value)), 0.0, 1.0));
    };
    return QColor::fromRgbF(part(linear.r), part(linear.g), part(linear.b));
}

glm::vec3 toLinear(const QColor& colour) {
    const auto part = [](float srgb) { return static_cast<float>(decoded(static_cast<double>(srgb))); };
    return {part(colour.redF()), part(colour.greenF()), part(colour.blueF())};
}

}  // namespace

LightsPanel::LightsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_ui(std::make_unique<Ui::LightsForm>()) {
    m_ui->setupUi(this);
    m_rows = {
        {{m_ui->directionalOn, m_ui->directionalColour, m_ui->directionalSlider, m_ui->directionalIntensity},
         {m_ui->pointsOn, m_ui->pointsColour, m_ui->pointsSlider, m_ui->pointsIntensity},
         {m_ui->spotOn, m_ui->spotColour, m_ui->spotSlider, m_ui->spotIntensity}}};
    for (const Kind kind : {Directional, Points, Spot}) {
        connectRow(kind);
    }
    connect(m_ui->reset, &QPushButton::clicked, this, &LightsPanel::reset);
    connect(&session, &Session::lightsChanged, this, &LightsPanel::showLights);
    showLights();
}

LightsPanel::~LightsPanel() = default;

void LightsPanel::connectRow(Kind kind) {
    const Row& row = m_rows[kind];
    connect(row.on, &QCheckBox::toggled, this, [this, kind] { applyRow(kind); });
    connect(row.colour, &ColourButton::colourPicked, this, [this, kind] { applyRow(kind); });
    connect(row.slider, &QSlider::valueChanged, this,
            [row](int slider) { row.intensity->setValue(slider / kSliderScale); });
    connect(row.intensity, &QDoubleSpinBox::valueChanged, this, [this, kind, row](double intensity) {
        const QSignalBlocker quiet(row.slider);
        row.slider->setValue(static_cast<int>(std::lround(intensity * kSliderScale)));
        applyRow(kind);
    });
}

void LightsPanel::showLights() {
    if (m_applying) {
        return;
    }
    const Lights& lights = m_session.lights();
    const bool anyPoint = std::any_of(lights.points.begin(), lights.points.end(),
                                      [](const PointLight& light) { return light.on; });
    const std::array<std::pair<bool, LightTerms>, KindCount> shown{
        {{lights.directional.on, lights.directional.terms},
         {anyPoint, lights.points.front().terms},
         {lights.spot.on, lights.spot.terms}}};
    for (std::size_t kind = 0; kind < KindCount; ++kind) {
        const Row& row = m_rows[kind];
        const QSignalBlocker quietOn(row.on);
        const QSignalBlocker quietSlider(row.slider);
        const QSignalBlocker quietIntensity(row.intensity);
        const auto& [on, terms] = shown[kind];
        row.on->setChecked(on);
        row.colour->setColour(toColour(terms.colour));
        row.intensity->setValue(static_cast<double>(terms.diffuse));
        row.slider->setValue(
            static_cast<int>(std::lround(static_cast<double>(terms.diffuse) * kSliderScale)));
    }
}

void LightsPanel::applyRow(Kind kind) {
    const Row& row = m_rows[kind];
    const bool on = row.on->isChecked();
    const glm::vec3 colour = toLinear(row.colour->colour());
    const auto diffuse = static_cast<float>(row.intensity->value());
    Lights lights = m_session.lights();
    const auto set = [on, &colour, diffuse](auto& light) {
        light.on = on;
        light.terms.colour = colour;
        light.terms.diffuse = diffuse;
    };
    switch (kind) {
        case Directional:
            set(lights.directional);
            break;
        case Points:
            std::for_each(lights.points.begin(), lights.points.end(), set);
            break;
        default:
            set(lights.spot);
            break;
    }
    m_applying = true;
    m_session.setLights(lights);
    m_applying = false;
}

void LightsPanel::reset() {
    Lights lights = m_session.lights();
    const Lights first;
    const auto restore = [](auto& light, const auto& from) {
        light.on = from.on;
        light.terms = from.terms;
    };
    restore(lights.directional, first.directional);
    for (std::size_t i = 0; i < lights.points.size(); ++i) {
        restore(lights.points[i], first.points[i]);
    }
    restore(lights.spot, first.spot);
    m_session.setLights(lights);
}

}  // namespace hitscope
