// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/projectile_dialog.h"

#include <QPushButton>

#include "ui_projectile_settings.h"

namespace hitscope {

ProjectileDialog::ProjectileDialog(Session& session, QWidget* parent)
    : QDialog(parent), m_session(session), m_ui(std::make_unique<Ui::ProjectileSettings>()) {
    m_ui->setupUi(this);
    for (QDoubleSpinBox* box : {m_ui->speed, m_ui->radius, m_ui->mass, m_ui->lifetime}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &ProjectileDialog::apply);
    }
    connect(m_ui->bounces, &QCheckBox::toggled, this, &ProjectileDialog::apply);
    for (QAbstractButton* button : m_ui->buttons->buttons()) {
        // Enter ends the editing of a number and presses nothing.
        qobject_cast<QPushButton*>(button)->setAutoDefault(false);
    }
    connect(m_ui->buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_ui->buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] { m_session.setProjectileSettings(ProjectileSettings{}); });
    connect(&session, &Session::projectileSettingsChanged, this, &ProjectileDialog::showSettings);
    showSettings();
}

ProjectileDialog::~ProjectileDialog() = default;

void ProjectileDialog::showSettings() {
    const ProjectileSettings settings = m_session.projectileSettings();
    m_showing = true;
    m_ui->speed->setValue(static_cast<double>(settings.speed));
    m_ui->radius->setValue(static_cast<double>(settings.radius));
    m_ui->mass->setValue(static_cast<double>(settings.mass));
    m_ui->lifetime->setValue(static_cast<double>(settings.lifetime));
    m_ui->bounces->setChecked(settings.bouncesCount);
    m_showing = false;
}

void ProjectileDialog::apply() {
    if (m_showing) {
        return;
    }
    ProjectileSettings settings;
    settings.speed = static_cast<float>(m_ui->speed->value());
    settings.radius = static_cast<float>(m_ui->radius->value());
    settings.mass = static_cast<float>(m_ui->mass->value());
    settings.lifetime = static_cast<float>(m_ui->lifetime->value());
    settings.bouncesCount = m_ui->bounces->isChecked();
    m_session.setProjectileSettings(settings);
}

}  // namespace hitscope
