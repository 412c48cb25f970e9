// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <glm/vec3.hpp>

#include "session/session.h"

class QLabel;

namespace hitscope {

class NumberBox;

/// Six number fields that show where the selected target is: x, y, z in metres, then the angles about x, y, z
/// in degrees. A change of a number moves or turns all that are selected by as much, so a label says whose
/// numbers they are; typed, it is one step to undo, and so is a run of steps by wheel or arrow keys in one
/// field.
class TransformFields : public QObject {
    Q_OBJECT
public:
    struct Boxes {
        std::array<NumberBox*, 3> position{};
        std::array<NumberBox*, 3> rotation{};
    };
    /// `session`, the boxes and `whose` outlive this.
    TransformFields(Session& session, const Boxes& boxes, QLabel& whose, QObject* parent = nullptr);

private:
    void show();
    void showWhose(const Target* target);
    void setUp(int field, NumberBox& box);
    void apply(int field, double value);

    Session& m_session;
    Boxes m_boxes;
    QLabel& m_whose;
    glm::dvec3 m_angles{0.0};  ///< shown; degrees
    int m_stepping = -1;       ///< field whose next change belongs to the last one; -1: none
};

}  // namespace hitscope
