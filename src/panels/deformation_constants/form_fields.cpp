// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/form_fields.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

#include "models/dent_form_names.h"
#include "panels/help/help_text.h"

namespace hitscope {

namespace {

QComboBox* makeBox(QWidget& parent, const QString& name, const QString& objectName, const QString& toolTip) {
    auto* box = new QComboBox(&parent);
    box->setObjectName(objectName);
    box->setAccessibleName(name);
    box->setToolTip(toolTip);
    box->setPlaceholderText(FormFields::tr("Several"));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    parent.layout()->addWidget(box);
    return box;
}

}  // namespace

FormFields::FormFields(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    auto* label = new QLabel(tr("Fall-off"), this);
    row->addWidget(label);
    m_profile = makeBox(
        *this, tr("Fall-off profile"), QStringLiteral("profile"),
        tr("How far vertices move by their distance from the hit. Paper: power / distance, with a step at "
           "the rim. Smooth: the same without the step. Wendland C2, linear and crater: from max magnitude "
           "to "
           "nothing at max distance. Free curve: through the eight points of the plot."));
    label->setBuddy(m_profile);
    m_direction = makeBox(
        *this, tr("Direction of dents"), QStringLiteral("dentDirection"),
        tr("Which way vertices move. As it flew: in the direction of the projectile. Into the surface: "
           "against "
           "its normal at the hit. Press: out of the projectile's sphere, so that the dent has its shape."));
    for (std::size_t i = 0; i < kDentProfileKeys.size(); ++i) {
        m_profile->addItem(nameOf(static_cast<DentProfile>(i)));
    }
    for (std::size_t i = 0; i < kDentDirectionKeys.size(); ++i) {
        m_direction->addItem(nameOf(static_cast<DentDirection>(i)));
    }
    connect(m_profile, &QComboBox::activated, this,
            [this](int index) { Q_EMIT profileChosen(static_cast<DentProfile>(index)); });
    connect(m_direction, &QComboBox::activated, this,
            [this](int index) { Q_EMIT directionChosen(static_cast<DentDirection>(index)); });
}

void FormFields::show(const DentForm& form) {
    m_profile->setCurrentIndex(static_cast<int>(form.profile));
    m_direction->setCurrentIndex(static_cast<int>(form.direction));
    enableIf(*m_profile, !form.presses(), tr("A press has the shape of the projectile."));
}

void FormFields::showDiffering(bool profile, bool direction) {
    if (profile) {
        m_profile->setCurrentIndex(-1);
    }
    if (direction) {
        m_direction->setCurrentIndex(-1);
        enableIf(*m_profile, true, {});
    }
}

}  // namespace hitscope
