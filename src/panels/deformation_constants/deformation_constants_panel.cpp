// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/deformation_constants_panel.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>

#include "analysis/changed_settings.h"
#include "models/plain_text.h"
#include "panels/deformation_constants/form_fields.h"
#include "panels/deformation_constants/parameter_editor.h"
#include "panels/help/help_text.h"
#include "session/hit_editing.h"
#include "session/shown_number.h"
#include "session/usual_dent.h"
#include "ui_deformation_constants.h"

namespace hitscope {

namespace {

constexpr double kPerCent = 100.0;
constexpr int kCurvePart = 3;  // of gestures; the constants come before
constexpr double kPerSize = 1.0 / static_cast<double>(kUsualExtent);

enum Size { Relative, InMetres };  // rows of the form's combo box

/// "12 mm", "5.125 m": four digits at most, in the unit that keeps them readable.
QString lengthText(double metres) {
    constexpr double kRounded = 1.00005;  // so that what four digits make 1 mm of is no 1,000 µm
    const double size = metres * kRounded;
    if (size >= 1000.0) {
        return DeformationConstantsPanel::tr("%1 km").arg(shownNumber(metres / 1000.0, 'g', 4));
    }
    if (size >= 1.0 || metres == 0.0) {
        return DeformationConstantsPanel::tr("%1 m").arg(shownNumber(metres, 'g', 4));
    }
    return size >= 1.0e-3 ? DeformationConstantsPanel::tr("%1 mm").arg(shownNumber(metres * 1.0e3, 'g', 4))
                          : DeformationConstantsPanel::tr("%1 µm").arg(shownNumber(metres * 1.0e6, 'g', 4));
}

/// All visible targets are of one size: one that stands for all; null: they differ, or there are none.
const Target* ofOneSize(const Session& session) {
    const Target* first = nullptr;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (!target->visible) {
            continue;
        }
        if (first != nullptr && sizeFactor(first->extent()) != sizeFactor(target->extent())) {
            return nullptr;
        }
        first = first != nullptr ? first : target.get();
    }
    return first;
}

}  // namespace

DeformationConstantsPanel::DeformationConstantsPanel(Session& session, HitEditing& editing, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_editing(editing),
      m_ui(std::make_unique<Ui::DeformationConstantsForm>()) {
    m_ui->setupUi(this);
    QSettings settings;
    m_presets.load(settings);
    makeEditors();
    makeForm();
    makePresetMenu();
    connect(m_ui->preset, &QComboBox::activated, this, &DeformationConstantsPanel::choosePreset);
    connect(m_ui->size, &QComboBox::activated, this, [this](int row) {
        apply({m_session.settings().constants(), row == Relative,
               m_session.settings().constantsSetting().form});
    });
    connect(m_ui->applyToSelected, &QPushButton::clicked, this,
            [this] { m_session.hits().giveConstants(m_editing.rows()); });
    connect(m_ui->applyToAll, &QPushButton::clicked, &session.hits(), &SessionHits::giveConstantsToAll);
    connect(&editing, &HitEditing::rowsChanged, this, &DeformationConstantsPanel::showHits);
    connect(&session.hits(), &SessionHits::appended, this, &DeformationConstantsPanel::showHits);
    connect(&session.hits(), &SessionHits::reset, this, &DeformationConstantsPanel::showHits);
    connect(&session.settings(), &SessionSettings::projectileChanged, this,
            &DeformationConstantsPanel::showInForce);
    connect(&session.settings(), &SessionSettings::flightModeChanged, this,
            &DeformationConstantsPanel::showInForce);
    connect(&session.settings(), &SessionSettings::constantsChanged, this,
            &DeformationConstantsPanel::showConstants);
    connect(&session.targets(), &SessionTargets::selectedChanged, this,
            &DeformationConstantsPanel::showInForce);
    connect(&session, &Session::sceneReplaced, this, &DeformationConstantsPanel::showInForce);
    for (const auto signal : {&SessionTargets::added, &SessionTargets::removed, &SessionTargets::changed}) {
        connect(&session.targets(), signal, this, [this] { m_showing.want(); });
    }
    listPresets();
    showConstants();
    showHits();
}

DeformationConstantsPanel::~DeformationConstantsPanel() = default;

void DeformationConstantsPanel::makeEditors() {
    const auto& parameters = deformationParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        auto* editor =
            new ParameterEditor(parameters[i], parameters[i], *m_ui->parameters, static_cast<int>(i), this);
        connect(editor, &ParameterEditor::edited, this, [this, i](double value) {
            ConstantsSetting setting = m_session.settings().constantsSetting();
            setParameterValue(setting.constants, i, value);
            apply(setting, m_gesture.change(static_cast<int>(i)));
        });
        connect(editor, &ParameterEditor::finished, this, [this] { m_gesture.end(); });
        m_editors.push_back(editor);
    }
}

void DeformationConstantsPanel::makeForm() {
    m_form = new FormFields(this);
    m_ui->layout->insertWidget(m_ui->layout->indexOf(m_ui->choices) + 1, m_form);
    connect(m_form, &FormFields::profileChosen, this, [this](DentProfile profile) {
        DentForm form = m_session.settings().constantsSetting().form;
        form.profile = profile;
        setForm(form);
    });
    connect(m_form, &FormFields::directionChosen, this, [this](DentDirection direction) {
        DentForm form = m_session.settings().constantsSetting().form;
        form.direction = direction;
        setForm(form);
    });
    connect(m_ui->falloff, &FalloffPlot::curveEdited, this, [this](const CurveOrdinates& curve) {
        DentForm form = m_session.settings().constantsSetting().form;
        form.curve = curve;
        setForm(form, m_gesture.change(kCurvePart));
    });
    connect(m_ui->falloff, &FalloffPlot::curveFinished, this, [this] { m_gesture.end(); });
}

void DeformationConstantsPanel::setForm(const DentForm& form, SessionUndo::Merge merge) {
    const ConstantsSetting& now = m_session.settings().constantsSetting();
    apply({now.constants, now.relative, form}, merge);
}

void DeformationConstantsPanel::showForm() {
    const DentForm& form = m_session.settings().constantsSetting().form;
    m_form->show(form);
    m_editors[kMaxDistance]->enable(form.usesDistance(),
                                    tr("A press reaches as far as the projectile does."));
    m_editors[kPower]->enable(form.usesPower(),
                              tr("Power has a part in the profiles Paper and Smooth only."));
}

DentForm DeformationConstantsPanel::formOn(TargetId target) const {
    Hit hit;
    hit.target = target;
    const DentForm& form = m_session.settings().constantsSetting().form;
    return form.presses() ? withRadius(m_session, form, hit) : form;
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
    const bool relative = m_session.settings().constantsSetting().relative;
    for (std::size_t i = 0; i < m_editors.size(); ++i) {
        const bool isPower = i == kPower;
        m_editors[i]->setUnit(relative ? kPerCent * (isPower ? kPerSize * kPerSize : kPerSize) : 1.0,
                              relative ? tr("%") : QString::fromUtf8(deformationParameters()[i].unit));
        m_editors[i]->setValue(parameterValue(m_session.settings().constants(), i));
    }
    const std::optional<std::size_t> preset = presetInForce();
    showForm();
    m_ui->preset->setCurrentIndex(preset ? static_cast<int>(*preset) : -1);
    m_ui->size->setCurrentIndex(relative ? Relative : InMetres);
    enableIf(*m_delete, preset && !m_presets.all()[*preset].isOurs,
             preset ? tr("This preset belongs to Hitscope.") : tr("Choose a preset of your own first."));
    showInForce();
}

void DeformationConstantsPanel::showInForce() {
    const bool relative = m_session.settings().constantsSetting().relative;
    const Target* selected = m_session.targets().find(m_session.targets().selected());
    const Target* target = selected != nullptr ? selected : ofOneSize(m_session);
    if (relative && target == nullptr) {
        // Power is per cent of a square: in these units of length it is a hundred times as much.
        const auto scale = static_cast<float>(kPerCent * kPerSize);
        DentForm form = formOn({});
        form.radius *= scale;
        m_ui->falloff->show(scaled(m_session.settings().constants(), scale), form,
                            FalloffPlot::Unit::PerCentOfTarget);
    } else {
        m_ui->falloff->show(
            target != nullptr ? m_session.settings().constantsOn(*target) : m_session.settings().constants(),
            formOn(target != nullptr ? target->id : TargetId{}));
    }
    QString text = inForceText();
    const ProjectileSettings& projectile = m_session.settings().projectile();
    if (projectile.powerFollowsImpulse) {
        text += u' ' + tr("Power follows the impulse: it is this at %1 N·s.")
                           .arg(shownFloat(projectile.referenceImpulse));
    }
    if (const DentForm form = formOn(target != nullptr ? target->id : TargetId{}); form.presses()) {
        text += u' ' + tr("Press: the projectile's radius, %1 now, and half of it in at most.")
                           .arg(lengthText(static_cast<double>(form.radius)));
    }
    m_ui->inForce->setText(text);
}

QString DeformationConstantsPanel::inForceText() const {
    if (!m_session.settings().constantsSetting().relative) {
        return tr("In force: these numbers, on every target.");
    }
    const Target* selected = m_session.targets().find(m_session.targets().selected());
    const Target* target = selected != nullptr ? selected : ofOneSize(m_session);
    if (target == nullptr) {
        return m_session.targets().empty()
                   ? tr("Per cent of a target's largest extent; power: of its square.")
                   : tr("Per cent of a target's largest extent; power: of its square. The targets differ in "
                        "size: select one to see what is in force on it.");
    }
    QString size = lengthText(target->extent());
    if (const QString counted = lengthText(sizeFactor(target->extent()) * kUsualExtent); counted != size) {
        size = tr("%1, rounded to %2").arg(size, counted);
    }
    const DeformationConstants constants = m_session.settings().constantsOn(*target);
    const bool isOnly = selected != nullptr || m_session.targets().size() == 1;
    return tr("In force on %1 (%2): max distance %3, power %4 m², max magnitude %5.")
        .arg(isOnly ? target->name : tr("every target"), size, lengthText(constants.maxDistance),
             shownNumber(constants.power, 'g', 4), lengthText(constants.maxMagnitude));
}

void DeformationConstantsPanel::showHits() {
    const std::size_t selected = m_editing.rows().size();
    const std::size_t all = m_session.hits().history().size();
    m_ui->applyToSelected->setText(tr("Selected (%1)").arg(shownCount(selected)));
    enableIf(*m_ui->applyToSelected, selected > 0, tr("No hit is selected."));
    m_ui->applyToAll->setText(tr("All (%1)").arg(shownCount(all)));
    enableIf(*m_ui->applyToAll, all > 0, tr("There are no hits yet."));
}

void DeformationConstantsPanel::apply(const ConstantsSetting& setting, SessionUndo::Merge merge) {
    // The editors keep to the ranges that the session checks; should it refuse, they show what holds.
    if (!m_session.settings().setConstants(setting, merge)) {
        showConstants();
    }
}

void DeformationConstantsPanel::choosePreset(int row) {
    const ConstantsPreset& preset = m_presets.all()[static_cast<std::size_t>(row)];
    const ConstantsSetting& now = m_session.settings().constantsSetting();
    apply({preset.constants, now.relative, preset.form.value_or(now.form)});
}

std::optional<std::size_t> DeformationConstantsPanel::presetInForce() const {
    return m_presets.find(m_session.settings().constants(), m_session.settings().constantsSetting().form);
}

/// Another Hitscope may have changed them meanwhile.
void DeformationConstantsPanel::takePresetsOfOthers(QSettings& settings) {
    settings.sync();
    if (settings.status() == QSettings::NoError) {
        m_presets.load(settings);
    }
}

void DeformationConstantsPanel::savePreset() {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Save as Preset"), tr("Name:"), QLineEdit::Normal,
                                               QString(), &accepted);
    if (!accepted) {
        return;
    }
    const ConstantsSetting& now = m_session.settings().constantsSetting();
    const ChangedSettings settings;
    takePresetsOfOthers(*settings);
    const Status saved = m_presets.save(name, now.constants, now.form);
    if (saved) {
        m_presets.store(*settings);
    }
    listPresets();
    showConstants();
    Q_EMIT presetsChanged();
    if (!saved) {
        QMessageBox::warning(this, tr("Save as Preset"),
                             asPlainText(QString::fromStdString(saved.error().message())));
    }
}

void DeformationConstantsPanel::deletePreset() {
    if (const std::optional<std::size_t> preset = presetInForce()) {
        const QString name = m_presets.all()[*preset].name;
        const ChangedSettings settings;
        takePresetsOfOthers(*settings);
        m_presets.remove(name);
        m_presets.store(*settings);
        listPresets();
        showConstants();
        Q_EMIT presetsChanged();
    }
}

}  // namespace hitscope
