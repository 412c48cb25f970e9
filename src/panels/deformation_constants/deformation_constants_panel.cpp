// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/deformation_constants_panel.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>

#include "models/focus_target.h"
#include "panels/deformation_constants/parameter_editor.h"
#include "session/shown_number.h"
#include "ui_deformation_constants.h"

namespace hitscope {

namespace {

enum Size { Relative, InMetres };  // rows of the form's combo box

/// "12.0 mm", "5.00 m": three digits, in the unit that keeps them readable.
QString lengthText(double metres) {
    if (metres >= 1000.0) {
        return DeformationConstantsPanel::tr("%1 km").arg(shownNumber(metres / 1000.0, 'g', 3));
    }
    if (metres >= 1.0 || metres == 0.0) {
        return DeformationConstantsPanel::tr("%1 m").arg(shownNumber(metres, 'g', 3));
    }
    return metres >= 1.0e-3 ? DeformationConstantsPanel::tr("%1 mm").arg(shownNumber(metres * 1.0e3, 'g', 3))
                            : DeformationConstantsPanel::tr("%1 µm").arg(shownNumber(metres * 1.0e6, 'g', 3));
}

}  // namespace

DeformationConstantsPanel::DeformationConstantsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_ui(std::make_unique<Ui::DeformationConstantsForm>()) {
    m_ui->setupUi(this);
    QSettings settings;
    m_presets.load(settings);
    makeEditors();
    makePresetMenu();
    connect(m_ui->preset, &QComboBox::activated, this, &DeformationConstantsPanel::choosePreset);
    connect(m_ui->size, &QComboBox::activated, this, [this](int row) {
        apply({m_session.constants(), row == Relative});
    });
    connect(m_ui->past, &QCheckBox::toggled, this, [this](bool past) {
        if (past) {
            apply(m_session.constantsSetting());
        }
    });
    connect(&session, &Session::constantsChanged, this, &DeformationConstantsPanel::showConstants);
    connect(&session, &Session::targetSelected, this, &DeformationConstantsPanel::showInForce);
    connect(&session, &Session::sceneReplaced, this, &DeformationConstantsPanel::showInForce);
    connect(&session, &Session::targetAdded, this, &DeformationConstantsPanel::showInForce);
    connect(&session, &Session::targetRemoved, this, &DeformationConstantsPanel::showInForce);
    connect(&session, &Session::targetChanged, this, &DeformationConstantsPanel::showInForce);
    listPresets();
    showConstants();
}

DeformationConstantsPanel::~DeformationConstantsPanel() = default;

void DeformationConstantsPanel::makeEditors() {
    const auto& parameters = deformationParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        auto* editor = new ParameterEditor(parameters[i], *m_ui->parameters, static_cast<int>(i), this);
        connect(editor, &ParameterEditor::edited, this, [this, i](double value) {
            ConstantsSetting setting = m_session.constantsSetting();
            setParameterValue(setting.constants, i, value);
            apply(setting);
        });
        m_editors.push_back(editor);
    }
}

void DeformationConstantsPanel::makePresetMenu() {
    auto* menu = new QMenu(m_ui->presets);
    menu->addAction(tr("Save as Preset…"), this, &DeformationConstantsPanel::savePreset);
    m_delete = menu->addAction(tr("Delete Preset"), this, &DeformationConstantsPanel::deletePreset);
    // Not setMenu(): its arrow would stand beside the dots.
    connect(m_ui->presets, &QToolButton::clicked, menu,
            [this, menu] { menu->popup(m_ui->presets->mapToGlobal(m_ui->presets->rect().bottomLeft())); });
}

void DeformationConstantsPanel::listPresets() {
    m_ui->preset->clear();
    for (const ConstantsPreset& preset : m_presets.all()) {
        m_ui->preset->addItem(preset.name);
    }
    m_ui->preset->setPlaceholderText(tr("Own values"));
}

void DeformationConstantsPanel::showConstants() {
    for (std::size_t i = 0; i < m_editors.size(); ++i) {
        m_editors[i]->setValue(parameterValue(m_session.constants(), i));
    }
    const std::optional<std::size_t> preset = m_presets.find(m_session.constants());
    m_ui->preset->setCurrentIndex(preset ? static_cast<int>(*preset) : -1);
    m_ui->size->setCurrentIndex(m_session.constantsSetting().relative ? Relative : InMetres);
    m_delete->setEnabled(preset && !m_presets.all()[*preset].isOurs);
    showInForce();
}

void DeformationConstantsPanel::showInForce() {
    const Target* target = focusTarget(m_session);
    const DeformationConstants constants =
        target != nullptr ? m_session.constantsOn(*target) : m_session.constants();
    m_ui->falloff->show(constants);
    if (!m_session.constantsSetting().relative) {
        m_ui->inForce->setText(tr("In force: these numbers, on every target."));
    } else if (target == nullptr) {
        m_ui->inForce->setText(tr("In force: these numbers, for each 5 m of a target's largest extent."));
    } else if (constants == m_session.constants()) {
        m_ui->inForce->setText(
            tr("In force on %1 (%2): these numbers.").arg(target->name, lengthText(target->extent())));
    } else {
        m_ui->inForce->setText(
            tr("In force on %1 (%2): max distance %3, power %4 m², max magnitude %5.")
                .arg(target->name, lengthText(target->extent()), lengthText(constants.maxDistance))
                .arg(shownNumber(constants.power, 'g', 3))
                .arg(lengthText(constants.maxMagnitude)));
    }
}

void DeformationConstantsPanel::apply(const ConstantsSetting& setting) {
    // The editors keep to the ranges that the session checks; should it refuse, they show what holds.
    if (!m_session.setConstants(setting, m_ui->past->isChecked())) {
        showConstants();
    }
}

void DeformationConstantsPanel::choosePreset(int row) {
    apply({m_presets.all()[static_cast<std::size_t>(row)].constants, m_session.constantsSetting().relative});
}

void DeformationConstantsPanel::savePreset() {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Save as Preset"), tr("Name:"), QLineEdit::Normal,
                                               QString(), &accepted);
    if (!accepted) {
        return;
    }
    if (Status status = m_presets.save(name, m_session.constants()); !status) {
        QMessageBox::warning(this, tr("Save as Preset"), QString::fromStdString(status.error().message()));
        return;
    }
    QSettings settings;
    m_presets.store(settings);
    listPresets();
    showConstants();
}

void DeformationConstantsPanel::deletePreset() {
    const std::optional<std::size_t> preset = m_presets.find(m_session.constants());
    if (preset) {
        m_presets.remove(*preset);
        QSettings settings;
        m_presets.store(settings);
        listPresets();
        showConstants();
    }
}

}  // namespace hitscope
