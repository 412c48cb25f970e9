// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <glm/vec3.hpp>

class QSlider;

namespace hitscope {

class NumberBox;

/// The two angles of a direction in a target's frame, each with a slider and a box: the azimuth is about y
/// and counts from z towards x, the elevation is above the plane of x and z. Degrees.
class DirectionFields : public QObject {
    Q_OBJECT
public:
    struct Widgets {
        NumberBox* azimuth = nullptr;
        QSlider* azimuthSlider = nullptr;
        NumberBox* elevation = nullptr;
        QSlider* elevationSlider = nullptr;
    };
    DirectionFields(const Widgets& widgets, QObject* parent);

    void show(const glm::vec3& direction);  ///< unit; emits nothing
    void showDiffering();

Q_SIGNALS:
    void edited(const glm::vec3& direction);  ///< unit
    void finished();

private:
    void take(double azimuth, double elevation);

    Widgets m_widgets;
    double m_azimuth = 0.0;  ///< of straight up or down, too
    double m_elevation = 0.0;
};

}  // namespace hitscope
