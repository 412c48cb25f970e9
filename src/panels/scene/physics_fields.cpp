// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/scene/physics_fields.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "panels/fields/number_box.h"
#include "panels/help/help_text.h"

namespace hitscope {

namespace {

constexpr int kNarrowestPhysics = 64;  // pixels; what the range would want is far wider

}  // namespace

PhysicsFields::PhysicsFields(Session& session, QCheckBox& dynamic, const Boxes& boxes, QLabel& trouble,
                             QObject* parent)
    : QObject(parent), m_session(session), m_dynamic(dynamic), m_boxes(boxes), m_trouble(trouble) {
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        const ParameterDescriptor& parameter = targetParameters()[i];
        NumberBox& box = *m_boxes[i];
        box.setDecimals(parameter.decimals);
        box.setSingleStep(parameter.step);
        box.setRange(parameter.minimum, parameter.maximum);
        box.setToolTip(QString::fromUtf8(parameter.description));
        box.setMinimumWidth(kNarrowestPhysics);
        box.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(&box, &NumberBox::edited, this, [this, i](double value) {
            apply([i, value](TargetPhysics& physics) { setParameterValue(physics, i, value); });
        });
    }
    connect(&m_dynamic, &QCheckBox::toggled, this, [this](bool isDynamic) {
        apply([isDynamic](TargetPhysics& physics) { physics.isDynamic = isDynamic; });
    });
    connect(&session, &Session::sceneReplaced, this, &PhysicsFields::show);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &PhysicsFields::show);
    connect(&session.targets(), &SessionTargets::changed, this, [this](TargetId id) {
        if (id == m_session.targets().selected()) {
            show();
        } else if (m_session.targets().isSelected(id) && !std::exchange(m_isToShow, true)) {
            // Once for all: many may move at a time.
            QTimer::singleShot(0, this, [this] {
                m_isToShow = false;
                show();
            });
        }
    });
    show();
}

void PhysicsFields::show() {
    const Target* target = m_session.targets().find(m_session.targets().selected());
    const TargetPhysics physics = target != nullptr ? target->physics : TargetPhysics{};
    const SessionTargets& targets = m_session.targets();
    const QSignalBlocker quiet(m_dynamic);
    enableIf(m_dynamic, target != nullptr, QObject::tr("Select a target first."));
    m_dynamic.setChecked(physics.isDynamic);
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_boxes[i]->showNumber(parameterValue(physics, i));
        if (std::any_of(targets.begin(), targets.end(), [&](const std::unique_ptr<Target>& each) {
                return targets.isSelected(each->id) &&
                       parameterValue(each->physics, i) != parameterValue(physics, i);
            })) {
            m_boxes[i]->showDiffering();
        }
        // What stays where it is has no mass that matters.
        enableIf(*m_boxes[i], target != nullptr && (i > 0 || physics.isDynamic),
                 target == nullptr ? QObject::tr("Select a target first.")
                                   : QObject::tr("Only a dynamic target has a mass."));
    }
    const QString reason = target != nullptr ? m_session.simulation().whyNotHittable(target->id) : QString();
    m_trouble.setText(reason);
    m_trouble.setVisible(!reason.isEmpty());
}

void PhysicsFields::apply(const std::function<void(TargetPhysics&)>& change) {
    const std::vector<TargetId> selected = m_session.targets().allSelected();
    if (const Status set = m_session.targets().setPhysics(selected, change); !set) {
        show();
        m_trouble.setText(QString::fromStdString(set.error().message()));
        m_trouble.show();
    }
}

}  // namespace hitscope
