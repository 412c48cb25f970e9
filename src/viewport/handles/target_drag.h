// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "session/target_state.h"

namespace hitscope {

class Viewport;

inline constexpr std::size_t kAxes = 3;  ///< of the world: x, y, z
[[nodiscard]] glm::vec3 axisOf(std::size_t axis);
/// The unit vector at an angle (radians) about an axis, from the axis after it to the one after that.
[[nodiscard]] glm::vec3 onCircle(std::size_t axis, double angle);
[[nodiscard]] QChar letterOf(std::size_t axis);
/// Logical pixels, from the middle of the handles to the end of an axis seen from the side.
inline constexpr float kHandleReach = 92.0f;
inline constexpr float kCircleRadius = 0.8f;  ///< of the circles to turn by, times the reach

/// One drag of targets in the picture, from where they were when it began: along an axis, about one, or
/// across the line of sight.
class TargetDrag {
public:
    struct Kind {
        bool turns = false;
        std::size_t axis = kAxes;  ///< kAxes: across the line of sight

        bool operator==(const Kind&) const = default;
    };
    /// `middle`: world; what turns turns about it. `from`: logical pixels of the viewport, which outlives
    /// this.
    TargetDrag(Viewport& viewport, std::vector<TargetPlace> before, const glm::vec3& middle, QPointF from,
               Kind kind);

    [[nodiscard]] const Kind& kind() const { return m_kind; }
    [[nodiscard]] bool moves(TargetId id) const;
    [[nodiscard]] glm::vec3 middle() const { return m_middle + m_shift; }  ///< as it is now
    [[nodiscard]] double turned() const { return m_turned; }               ///< radians
    [[nodiscard]] std::vector<TargetPlace> places() const;                 ///< of the targets, now
    [[nodiscard]] QString text() const;  ///< how far it has come: "X +0.25 m"

    /// rounds: by round steps only. Where a place means nothing, as beyond the horizon, the drag stays where
    /// it was.
    void dragTo(const QPointF& to, bool rounds);
    void takeBack();

private:
    [[nodiscard]] QPointF onLine(const QPointF& to) const;
    [[nodiscard]] glm::vec3 shiftTo(const QPointF& to, bool rounds) const;
    [[nodiscard]] double angleTo(const QPointF& to) const;

    Viewport& m_viewport;
    std::vector<TargetPlace> m_before;
    glm::vec3 m_middle;
    QPointF m_from;
    Kind m_kind;
    glm::vec3 m_shift = glm::vec3(0.0f);  ///< metres, world
    double m_angle = 0.0;                 ///< radians, as the cursor has it
    double m_turned = 0.0;
};

}  // namespace hitscope
