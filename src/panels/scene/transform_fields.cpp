// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/scene/transform_fields.h"

#include <QLabel>

#include "models/quantity_text.h"
#include "models/rotation_angles.h"
#include "panels/fields/number_box.h"
#include "panels/help/help_text.h"

namespace hitscope {

namespace {

constexpr double kFarthest = 1.0e7;  // metres
constexpr double kTurns = 3600.0;    // degrees
constexpr int kAxes = 3;
constexpr int kNameLetters = 24;
constexpr int kNarrowestTransform = 64;  // pixels; what the range would want is far wider

}  // namespace

TransformFields::TransformFields(Session& session, const Boxes& boxes, QLabel& whose, QObject* parent)
    : QObject(parent), m_session(session), m_boxes(boxes), m_whose(whose) {
    for (int axis = 0; axis < kAxes; ++axis) {
        NumberBox& position = *m_boxes.position[static_cast<std::size_t>(axis)];
        position.setRange(-kFarthest, kFarthest);
        position.setUnit(QStringLiteral("m"));
        setUp(axis, position);
        NumberBox& rotation = *m_boxes.rotation[static_cast<std::size_t>(axis)];
        rotation.setDecimals(2);
        rotation.setSingleStep(5.0);
        rotation.setRange(-kTurns, kTurns);
        setUp(kAxes + axis, rotation);
    }
    connect(&session, &Session::sceneReplaced, this, &TransformFields::show);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, [this] {
        m_stepping = -1;
        show();
    });
    connect(&session.targets(), &SessionTargets::changed, this, [this](TargetId id) {
        if (id == m_session.targets().selected()) {
            show();
        }
    });
    show();
}

void TransformFields::setUp(int field, NumberBox& box) {
    box.setMinimumWidth(kNarrowestTransform);
    box.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(&box, &NumberBox::edited, this, [this, field](double value) { apply(field, value); });
    connect(&box, &NumberBox::editingFinished, this, [this] { m_stepping = -1; });
}

void TransformFields::show() {
    const Target* target = m_session.targets().find(m_session.targets().selected());
    const RigidTransform transform = target != nullptr ? target->transform : RigidTransform{};
    const double size = target != nullptr ? static_cast<double>(target->worldBounds().diagonal()) : 0.0;
    m_angles = toAngles(transform.rotation, m_angles);
    for (int axis = 0; axis < kAxes; ++axis) {
        NumberBox& position = *m_boxes.position[static_cast<std::size_t>(axis)];
        enableIf(position, target != nullptr, QObject::tr("Select a target first."));
        position.setStepsWithin(size);
        position.showNumber(static_cast<double>(transform.position[axis]));
        NumberBox& rotation = *m_boxes.rotation[static_cast<std::size_t>(axis)];
        enableIf(rotation, target != nullptr, QObject::tr("Select a target first."));
        rotation.showNumber(m_angles[axis]);
    }
    showWhose(target);
}

/// Of one target there is no doubt.
void TransformFields::showWhose(const Target* target) {
    const std::size_t selected = m_session.targets().allSelected().size();
    if (target != nullptr && selected > 1) {
        const QFontMetrics metrics = m_whose.fontMetrics();
        m_whose.setText(QObject::tr("Position and rotation of “%1”; a change moves all %2")
                            .arg(metrics.elidedText(target->name, Qt::ElideMiddle,
                                                    kNameLetters * metrics.averageCharWidth()),
                                 countText(selected)));
    }
    m_whose.setVisible(target != nullptr && selected > 1);
}

void TransformFields::apply(int field, double value) {
    const TargetId selected = m_session.targets().selected();
    const Target* target = m_session.targets().find(selected);
    if (target == nullptr) {
        return;
    }
    const int axis = field % kAxes;
    const RigidTransform before = target->transform;
    const double turn = value - m_angles[axis];
    std::vector<TargetPlace> places;
    for (const TargetId id : m_session.targets().allSelected()) {
        RigidTransform transform = m_session.targets().find(id)->transform;
        if (field < kAxes) {
            const float step = static_cast<float>(value) - before.position[axis];
            transform.position[axis] =
                id == selected ? static_cast<float>(value) : transform.position[axis] + step;
        } else {
            glm::dvec3 angles = toAngles(transform.rotation, m_angles);
            angles[axis] = id == selected ? value : angles[axis] + turn;
            transform.rotation = fromAngles(angles);
        }
        places.push_back({id, transform});
    }
    m_angles[axis] = field < kAxes ? m_angles[axis] : value;
    const auto merge = m_stepping == field ? SessionUndo::Merge::WithSameKind : SessionUndo::Merge::Never;
    m_stepping = field;
    if (!m_session.targets().setTransforms(places, merge).ok()) {
        show();
    }
}

}  // namespace hitscope
