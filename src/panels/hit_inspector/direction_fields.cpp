// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_inspector/direction_fields.h"

#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "panels/fields/number_box.h"

namespace hitscope {

namespace {

constexpr double kDegreesInRadian = 57.29577951308232;
constexpr double kUpright = 0.999999;  // sine of an elevation where the azimuth is not known

double rounded(double degrees) {
    return std::round(degrees * 100.0) / 100.0;
}

}  // namespace

DirectionFields::DirectionFields(const Widgets& widgets, QObject* parent)
    : QObject(parent), m_widgets(widgets) {
    const auto setUp = [this](NumberBox& box, QSlider& slider, int limit) {
        box.setRange(-limit, limit);
        box.setSingleStep(5.0);
        box.setSuffix(QStringLiteral("°"));
        slider.setRange(-limit, limit);
        slider.setPageStep(15);
        connect(&box, &NumberBox::editingFinished, this, &DirectionFields::finished);
        connect(&slider, &QSlider::sliderReleased, this, &DirectionFields::finished);
    };
    setUp(*widgets.azimuth, *widgets.azimuthSlider, 180);
    setUp(*widgets.elevation, *widgets.elevationSlider, 90);
    const auto takeAzimuth = [this](double degrees) { take(degrees, m_elevation); };
    const auto takeElevation = [this](double degrees) { take(m_azimuth, degrees); };
    connect(widgets.azimuth, &NumberBox::edited, this, takeAzimuth);
    connect(widgets.elevation, &NumberBox::edited, this, takeElevation);
    connect(widgets.azimuthSlider, &QSlider::valueChanged, this, takeAzimuth);
    connect(widgets.elevationSlider, &QSlider::valueChanged, this, takeElevation);
}

void DirectionFields::show(const glm::vec3& direction) {
    const auto x = static_cast<double>(direction.x);
    const auto y = static_cast<double>(direction.y);
    const auto z = static_cast<double>(direction.z);
    if (std::abs(y) < kUpright) {
        m_azimuth = rounded(std::atan2(x, z) * kDegreesInRadian);
    }
    m_elevation = rounded(std::asin(std::clamp(y, -1.0, 1.0)) * kDegreesInRadian);
    m_widgets.azimuth->showNumber(m_azimuth);
    m_widgets.elevation->showNumber(m_elevation);
    const auto place = [](QSlider& slider, double degrees) {
        if (!slider.isSliderDown()) {
            const QSignalBlocker quiet(slider);
            slider.setValue(static_cast<int>(std::lround(degrees)));
        }
    };
    place(*m_widgets.azimuthSlider, m_azimuth);
    place(*m_widgets.elevationSlider, m_elevation);
}

void DirectionFields::showDiffering() {
    m_widgets.azimuth->showDiffering();
    m_widgets.elevation->showDiffering();
}

void DirectionFields::take(double azimuth, double elevation) {
    m_azimuth = azimuth;
    m_elevation = elevation;
    const double up = elevation / kDegreesInRadian;
    const double about = azimuth / kDegreesInRadian;
    Q_EMIT edited(glm::vec3(static_cast<float>(std::cos(up) * std::sin(about)),
                            static_cast<float>(std::sin(up)),
                            static_cast<float>(std::cos(up) * std::cos(about))));
}

}  // namespace hitscope
