// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <glm/vec3.hpp>
#include <optional>

class QSlider;

namespace hitscope {

class NumberBox;

// Angles of unit vectors: degrees, as DirectionFields has them, to two decimals.

/// Nothing: it is straight up or down, and has none.
[[nodiscard]] std::optional<double> azimuthOf(const glm::vec3& direction);
[[nodiscard]] double elevationOf(const glm::vec3& direction);
/// The direction with this azimuth and its own elevation. One straight up or down stays as it is.
[[nodiscard]] glm::vec3 withAzimuth(const glm::vec3& direction, double azimuth);
/// The direction with this elevation and its own azimuth, or the given one where it has none.
[[nodiscard]] glm::vec3 withElevation(const glm::vec3& direction, double elevation, double azimuth);

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

    void show(const glm::vec3& direction);             ///< unit; emits nothing
    void showDiffering(bool azimuth, bool elevation);  ///< which of them stands for several
    /// Shown or edited last: straight up or down has one here, too.
    [[nodiscard]] double azimuth() const { return m_azimuth; }

Q_SIGNALS:
    void azimuthEdited(double degrees);
    void elevationEdited(double degrees);
    void finished();

private:
    Widgets m_widgets;
    double m_azimuth = 0.0;
};

}  // namespace hitscope
