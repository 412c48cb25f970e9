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

glm::vec3 pointed(double sine, double cosine, double azimuth) {
    const double about = azimuth / kDegreesInRadian;
    return {static_cast<float>(cosine * std::sin(about)), static_cast<float>(sine),
            static_cast<float>(cosine * std::cos(about))};
}

double turnAbout(const glm::vec3& direction) {
    return std::atan2(static_cast<double>(direction.x), static_cast<double>(direction.z)) * kDegreesInRadian;
}

bool isUpright(const glm::vec3& direction) {
    return std::abs(static_cast<double>(direction.y)) >= kUpright;
}

}  // namespace

std::optional<double> azimuthOf(const glm::vec3& direction) {
    return isUpright(direction) ? std::nullopt : std::optional(rounded(turnAbout(direction)));
}

double elevationOf(const glm::vec3& direction) {
    return rounded(std::asin(std::clamp(static_cast<double>(direction.y), -1.0, 1.0)) * kDegreesInRadian);
}

glm::vec3 withAzimuth(const glm::vec3& direction, double azimuth) {
    const double across = std::hypot(static_cast<double>(direction.x), static_cast<double>(direction.z));
    return isUpright(direction) ? direction : pointed(static_cast<double>(direction.y), across, azimuth);
}

glm::vec3 withElevation(const glm::vec3& direction, double elevation, double azimuth) {
    const double up = elevation / kDegreesInRadian;
    return pointed(std::sin(up), std::cos(up), isUpright(direction) ? azimuth : turnAbout(direction));
}

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
    const auto takeAzimuth = [this](double degrees) {
        m_azimuth = degrees;
        Q_EMIT azimuthEdited(degrees);
    };
    connect(widgets.azimuth, &NumberBox::edited, this, takeAzimuth);
    connect(widgets.elevation, &NumberBox::edited, this, &DirectionFields::elevationEdited);
    connect(widgets.azimuthSlider, &QSlider::valueChanged, this, takeAzimuth);
    connect(widgets.elevationSlider, &QSlider::valueChanged, this, &DirectionFields::elevationEdited);
}

void DirectionFields::show(const glm::vec3& direction) {
    m_azimuth = azimuthOf(direction).value_or(m_azimuth);
    const double elevation = elevationOf(direction);
    m_widgets.azimuth->showNumber(m_azimuth);
    m_widgets.elevation->showNumber(elevation);
    const auto place = [](QSlider& slider, double degrees) {
        if (!slider.isSliderDown()) {
            const QSignalBlocker quiet(slider);
            slider.setValue(static_cast<int>(std::lround(degrees)));
        }
    };
    place(*m_widgets.azimuthSlider, m_azimuth);
    place(*m_widgets.elevationSlider, elevation);
}

void DirectionFields::showDiffering(bool azimuth, bool elevation) {
    if (azimuth) {
        m_widgets.azimuth->showDiffering();
    }
    if (elevation) {
        m_widgets.elevation->showDiffering();
    }
}

}  // namespace hitscope
