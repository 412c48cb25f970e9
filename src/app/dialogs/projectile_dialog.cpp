// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/projectile_dialog.h"

#include <QComboBox>
#include <QPushButton>
#include <utility>

#include "app/flight_chooser.h"
#include "app/flight_text.h"
#include "panels/help/help_text.h"
#include "ui_projectile_settings.h"

namespace hitscope {

namespace {

void describe(QDoubleSpinBox& box, const ParameterDescriptor& parameter) {
    box.setDecimals(parameter.decimals);
    box.setRange(parameter.minimum, parameter.maximum);
    box.setSingleStep(parameter.step);
    box.setToolTip(QString::fromUtf8(parameter.description));
    box.setKeyboardTracking(false);
    if (!parameter.unit.empty()) {
        box.setSuffix(QStringLiteral(" ") + QString::fromUtf8(parameter.unit));
    }
}

}  // namespace

ProjectileDialog::ProjectileDialog(Session& session, QWidget* parent)
    : QDialog(parent), m_session(session), m_ui(std::make_unique<Ui::ProjectileSettings>()) {
    m_ui->setupUi(this);
    m_numbers = {m_ui->speed,     m_ui->radius,           m_ui->mass,   m_ui->lifetime, m_ui->rateOfFire,
                 m_ui->mostAlive, m_ui->referenceImpulse, m_ui->gravity};
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        describe(*m_numbers[i], projectileParameters()[i]);
        connect(m_numbers[i], &QDoubleSpinBox::valueChanged, this, &ProjectileDialog::apply);
    }
    connect(m_ui->bounces, &QCheckBox::toggled, this, &ProjectileDialog::apply);
    connect(m_ui->powerFollowsImpulse, &QCheckBox::toggled, this, &ProjectileDialog::apply);
    makeColour();
    for (QAbstractButton* button : m_ui->buttons->buttons()) {
        // Enter ends the editing of a number and presses nothing.
        qobject_cast<QPushButton*>(button)->setAutoDefault(false);
    }
    connect(m_ui->buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_ui->buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] { m_session.settings().setProjectile(ProjectileSettings{}); });
    QComboBox* flight = makeFlightBox(session, this);
    m_ui->flightPlace->addWidget(flight);
    m_ui->flightLabel->setBuddy(flight);
    connect(&session.settings(), &SessionSettings::projectileChanged, this, &ProjectileDialog::showSettings);
    connect(&session.settings(), &SessionSettings::flightModeChanged, this, &ProjectileDialog::showInForce);
    connect(&session, &Session::sceneReplaced, this, &ProjectileDialog::showInForce);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &ProjectileDialog::showInForce);
    connect(&session.targets(), &SessionTargets::added, this, &ProjectileDialog::showInForce);
    connect(&session.targets(), &SessionTargets::removed, this, &ProjectileDialog::showInForce);
    showSettings();
    showInForce();
}

ProjectileDialog::~ProjectileDialog() = default;

/// What is tried is no step of its own: the colour that is taken is one, and none is left without it.
void ProjectileDialog::makeColour() {
    m_ui->colour->setDialogTitle(tr("Colour of the Projectiles"));
    connect(m_ui->colour, &ColourButton::colourTried, this, [this](const QColor& colour) {
        m_untried = m_untried.value_or(m_session.settings().projectile().colour);
        tint({colour.redF(), colour.greenF(), colour.blueF()});
    });
    connect(m_ui->colour, &ColourButton::cancelled, this, &ProjectileDialog::endTrial);
    connect(m_ui->colour, &ColourButton::colourPicked, this, [this](const QColor& colour) {
        if (m_untried) {
            endTrial();
            m_ui->colour->setColour(colour);
            apply();
        }
    });
}

void ProjectileDialog::tint(const glm::vec3& colour) {
    ProjectileSettings settings = m_session.settings().projectile();
    settings.colour = colour;
    m_session.settings().restoreProjectile(settings, m_session.settings().flightMode());
}

void ProjectileDialog::endTrial() {
    if (const std::optional<glm::vec3> untried = std::exchange(m_untried, std::nullopt)) {
        tint(*untried);
    }
}

void ProjectileDialog::showSettings() {
    const ProjectileSettings settings = m_session.settings().projectile();
    m_showing = true;
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        m_numbers[i]->setValue(parameterValue(settings, i));
    }
    const glm::vec3& colour = settings.colour;
    m_ui->colour->setColour(QColor::fromRgbF(colour.r, colour.g, colour.b));
    m_ui->bounces->setChecked(settings.bouncesCount);
    m_ui->powerFollowsImpulse->setChecked(settings.powerFollowsImpulse);
    enableIf(*m_ui->referenceImpulse, settings.powerFollowsImpulse,
             tr("Only where the dent's depth follows the impulse."));
    m_showing = false;
}

/// The numbers that the flight decides: as set, or in words.
void ProjectileDialog::showInForce() {
    const FlightMode mode = m_session.settings().flightMode();
    for (QWidget* field : {m_ui->speed, m_ui->radius, m_ui->lifetime, m_ui->gravity}) {
        m_ui->form->setRowVisible(field, mode == FlightMode::Own);
    }
    m_ui->form->setRowVisible(m_ui->inForce, mode != FlightMode::Own);
    m_ui->inForce->setText(flightText(m_session));
}

void ProjectileDialog::apply() {
    if (m_showing) {
        return;
    }
    ProjectileSettings settings = m_session.settings().projectile();
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        setParameterValue(settings, i, m_numbers[i]->value());
    }
    const QColor colour = m_ui->colour->colour();
    settings.colour = {colour.redF(), colour.greenF(), colour.blueF()};
    settings.bouncesCount = m_ui->bounces->isChecked();
    settings.powerFollowsImpulse = m_ui->powerFollowsImpulse->isChecked();
    m_session.settings().setProjectile(settings);
}

}  // namespace hitscope
