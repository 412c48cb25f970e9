// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <functional>

#include "session/session.h"

class QCheckBox;
class QLabel;

namespace hitscope {

class NumberBox;

/// Shows whether the selected target is dynamic, and its physics: mass, friction, restitution, in the order
/// of targetParameters(). What is changed is set for all that are selected, as one step to undo. Below them
/// stands why the target cannot be hit, if so.
class PhysicsFields : public QObject {
    Q_OBJECT
public:
    using Boxes = std::array<NumberBox*, 3>;
    /// `session` and the widgets outlive this.
    PhysicsFields(Session& session, QCheckBox& dynamic, const Boxes& boxes, QLabel& trouble,
                  QObject* parent = nullptr);

private:
    void show();
    void apply(const std::function<void(TargetPhysics&)>& change);

    Session& m_session;
    QCheckBox& m_dynamic;
    Boxes m_boxes;
    QLabel& m_trouble;
    bool m_isToShow = false;  ///< once the event loop has its turn
};

}  // namespace hitscope
