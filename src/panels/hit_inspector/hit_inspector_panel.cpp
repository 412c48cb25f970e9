// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_inspector/hit_inspector_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QToolButton>
#include <algorithm>
#include <glm/geometric.hpp>

#include "panels/deformation_constants/falloff_plot.h"
#include "panels/deformation_constants/form_fields.h"
#include "panels/deformation_constants/parameter_editor.h"
#include "panels/fields/number_box.h"
#include "panels/help/help_text.h"
#include "panels/hit_inspector/direction_fields.h"
#include "session/shown_number.h"
#include "session/usual_dent.h"
#include "ui_hit_inspector.h"

namespace hitscope {

namespace {

constexpr std::size_t kRadiusParameter = 1;  // of projectileParameters()
constexpr float kSameDirection = 4.5e-4f;    // between unit vectors

bool isAlong(const glm::vec3& one, const glm::vec3& other) {
    return glm::distance(one, other) < kSameDirection;  // a cosine is rounded by more than that
}

/// As the projectile had it.
glm::vec3 flightOf(const Hit& hit) {
    return hit.flight != glm::vec3(0.0f) ? hit.flight : hit.direction;
}

bool knowsSurface(const Hit& hit) {
    return hit.normal != glm::vec3(0.0f);
}

void turn(Hit& hit, const glm::vec3& direction) {
    hit.flight = flightOf(hit);
    hit.direction = direction;
}

void turnBack(Hit& hit) {
    hit.direction = flightOf(hit);
    hit.flight = glm::vec3(0.0f);
}

void turnIntoSurface(Hit& hit) {
    if (knowsSurface(hit)) {
        turn(hit, -hit.normal);
    }
}

}  // namespace

HitInspectorPanel::HitInspectorPanel(Session& session, HitEditing& editing, QWidget* parent)
    : QWidget(parent), m_session(session), m_editing(editing), m_ui(std::make_unique<Ui::HitInspector>()) {
    m_ui->setupUi(this);
    makeEditors();
    makeForm();
    makeDirection();
    makePoint();
    listPresets();
    connect(m_ui->preset, &QComboBox::activated, this, &HitInspectorPanel::choosePreset);
    connect(&editing, &HitEditing::rowsChanged, this, &HitInspectorPanel::followPresets);
    connect(&editing, &HitEditing::edited, this, &HitInspectorPanel::show);
    connect(&editing, &HitEditing::refused, this,
            [this](const Error& error) { m_ui->problem->setText(QString::fromStdString(error.what)); });
    connect(&session.targets(), &SessionTargets::changed, this, &HitInspectorPanel::showTitle);
    connect(&session.settings(), &SessionSettings::constantsChanged, this, &HitInspectorPanel::show);
    show();
}

HitInspectorPanel::~HitInspectorPanel() = default;

void HitInspectorPanel::editFirst() {
    if (NumberBox* box =
            findChild<NumberBox*>(QString::fromUtf8(deformationParameters()[kMaxDistance].key))) {
        box->setFocus();
        box->selectAll();
    }
}

void HitInspectorPanel::followPresets() {
    listPresets();
    show();
}

void HitInspectorPanel::makeEditors() {
    for (std::size_t i = 0; i < hitParameters().size(); ++i) {
        auto* editor = new ParameterEditor(hitParameters()[i], deformationParameters()[i], *m_ui->parameters,
                                           static_cast<int>(i), this);
        connect(editor, &ParameterEditor::edited, this, [this, i](double value) {
            m_editing.change(static_cast<int>(i),
                             [i, value](Hit& hit) { setParameterValue(hit.constants, i, value); });
        });
        connect(editor, &ParameterEditor::finished, &m_editing, &HitEditing::endGesture);
        m_editors.push_back(editor);
    }
}

void HitInspectorPanel::makeForm() {
    m_form = new FormFields(this);
    m_falloff = new FalloffPlot(this);
    const int below = m_ui->fieldsLayout->indexOf(m_ui->parameters) + 1;
    m_ui->fieldsLayout->insertWidget(below, m_form);
    m_ui->fieldsLayout->insertWidget(below + 1, m_falloff);
    ParameterDescriptor radius = projectileParameters()[kRadiusParameter];
    radius.key = "press_radius";
    radius.label = "Press radius";
    radius.description = "Radius of the sphere that vertices are pushed out of.";
    m_radius =
        new ParameterEditor(radius, radius, *m_ui->parameters, static_cast<int>(m_editors.size()), this);
    connect(m_radius, &ParameterEditor::edited, this, [this](double value) {
        m_editing.change(Radius, [value](Hit& hit) { hit.form.radius = static_cast<float>(value); });
    });
    connect(m_radius, &ParameterEditor::finished, &m_editing, &HitEditing::endGesture);
    connect(m_form, &FormFields::profileChosen, this, [this](DentProfile profile) {
        const CurveOrdinates curve = m_session.settings().constantsSetting().form.curve;
        once(Profile, [profile, curve](Hit& hit) {
            const bool hadCurve = hit.form.profile == DentProfile::Curve;
            hit.form.profile = profile;
            hit.form.curve = hadCurve ? hit.form.curve : curve;
        });
    });
    connect(m_form, &FormFields::directionChosen, this, [this](DentDirection direction) {
        once(Push, [this, direction](Hit& hit) {
            DentForm form = hit.form;
            form.direction = direction;
            hit.form = withRadius(m_session, form, hit);
        });
    });
    connect(m_falloff, &FalloffPlot::curveEdited, this, [this](const CurveOrdinates& curve) {
        m_editing.change(Curve, [curve](Hit& hit) {
            if (hit.form.profile == DentProfile::Curve) {
                hit.form.curve = curve;
            }
        });
    });
    connect(m_falloff, &FalloffPlot::curveFinished, &m_editing, &HitEditing::endGesture);
}

void HitInspectorPanel::showForm(const Hit& hit) {
    const DentForm& form = hit.form;
    const bool sameProfile = isSame(hit, [](const Hit& one) { return one.form.profile; });
    const bool sameDirection = isSame(hit, [](const Hit& one) { return one.form.direction; });
    m_form->show(form);
    m_form->showDiffering(!sameProfile, !sameDirection);
    m_editors[kMaxDistance]->enable(form.usesDistance() || !sameDirection,
                                    tr("A press reaches as far as the projectile does."));
    m_editors[kPower]->enable(form.usesPower() || !sameProfile || !sameDirection,
                              tr("Power has a part in the profiles Paper and Smooth only."));
    m_radius->setVisible(form.presses());
    m_radius->setValue(static_cast<double>(form.radius));
    if (!isSame(hit, [](const Hit& one) { return one.form.radius; })) {
        m_radius->showDiffering();
    }
    const bool turns = form.direction != DentDirection::IntoSurface || !knowsSurface(hit) || !sameDirection;
    for (QWidget* widget :
         {static_cast<QWidget*>(m_ui->azimuth), static_cast<QWidget*>(m_ui->azimuthSlider),
          static_cast<QWidget*>(m_ui->elevation), static_cast<QWidget*>(m_ui->elevationSlider)}) {
        enableIf(*widget, turns, tr("Vertices move into the surface, wherever the projectile came from."));
    }
    m_falloff->setVisible(!form.hasPaperFunction());
    m_falloff->show(hit.constants, form);
}

void HitInspectorPanel::makeDirection() {
    m_direction = new DirectionFields(
        {m_ui->azimuth, m_ui->azimuthSlider, m_ui->elevation, m_ui->elevationSlider}, this);
    connect(m_direction, &DirectionFields::azimuthEdited, this, [this](double degrees) {
        m_editing.change(Direction, [degrees](Hit& hit) {
            if (const glm::vec3 direction = withAzimuth(hit.direction, degrees); direction != hit.direction) {
                turn(hit, direction);
            }
        });
    });
    connect(m_direction, &DirectionFields::elevationEdited, this, [this](double degrees) {
        const double azimuth = m_direction->azimuth();
        m_editing.change(Elevation, [degrees, azimuth](Hit& hit) {
            turn(hit, withElevation(hit.direction, degrees, azimuth));
        });
    });
    connect(m_direction, &DirectionFields::finished, &m_editing, &HitEditing::endGesture);
    connect(m_ui->asShot, &QToolButton::clicked, this, [this] { once(Direction, turnBack); });
    connect(m_ui->intoSurface, &QToolButton::clicked, this, [this] { once(Direction, turnIntoSurface); });
}

void HitInspectorPanel::makePoint() {
    m_point = {m_ui->pointX, m_ui->pointY, m_ui->pointZ};
    const double farthest = hitParameters()[kMaxDistance].maximum;
    for (int axis = 0; axis < 3; ++axis) {
        NumberBox& box = *m_point[static_cast<std::size_t>(axis)];
        box.setUnit(QStringLiteral("m"));
        box.setRange(-farthest, farthest);
        connect(&box, &NumberBox::edited, this, [this, axis](double value) {
            m_editing.change(PointX + axis,
                             [axis, value](Hit& hit) { hit.point[axis] = static_cast<float>(value); });
        });
        connect(&box, &NumberBox::editingFinished, &m_editing, &HitEditing::endGesture);
    }
}

void HitInspectorPanel::listPresets() {
    m_presets = ConstantsPresets();
    QSettings settings;
    m_presets.load(settings);
    m_ui->preset->clear();
    for (const ConstantsPreset& preset : m_presets.all()) {
        m_ui->preset->addItem(preset.name);
    }
    m_ui->preset->addItem(tr("As the next hit"));
    m_ui->preset->setPlaceholderText(tr("Own values"));
}

template <class Value>
bool HitInspectorPanel::isSame(const Hit& hit, const Value& part) const {
    const std::span<const Hit> hits = m_session.hits().history().hits();
    const std::span<const std::size_t> rows = m_editing.rows();
    return std::all_of(rows.begin(), rows.end(),
                       [&](std::size_t row) { return row >= hits.size() || part(hits[row]) == part(hit); });
}

void HitInspectorPanel::show() {
    const Hit* hit = m_editing.current();
    m_ui->problem->clear();
    enableIf(*m_ui->fields, hit != nullptr, tr("Select a hit first."));
    m_ui->fields->setVisible(hit != nullptr);  // else they had numbers of no hit
    showTitle();
    if (hit != nullptr) {
        showConstants(*hit);
        showForm(*hit);
        showPreset(*hit);
        showDirection(*hit);
        showPoint(*hit);
    }
}

void HitInspectorPanel::showTitle() {
    const Hit* hit = m_editing.current();
    const std::size_t count = m_editing.rows().size();
    if (hit == nullptr) {
        m_ui->title->setText(
            tr("No hit is selected. Click a dent with the Inspect tool, or a row of the hit history."));
    } else if (count > 1) {
        m_ui->title->setText(
            tr("%Ln hits are selected. A change applies to all of them.", nullptr, trCount(count)));
    } else {
        const Target* target = m_session.targets().find(hit->target);
        const QString name = target != nullptr ? target->name : QString();
        const QString number = shownCount(*m_session.hits().selected() + 1);
        m_ui->title->setText(hit->enabled ? tr("Hit %1 on %2").arg(number, name)
                                          : tr("Hit %1 on %2, disabled").arg(number, name));
    }
}

void HitInspectorPanel::showConstants(const Hit& hit) {
    const Target* target = m_session.targets().find(hit.target);
    const double size = target != nullptr ? static_cast<double>(sizeFactor(target->extent())) : 1.0;
    const DeformationConstants next = usualConstants(m_session, hit);
    for (std::size_t i = 0; i < m_editors.size(); ++i) {
        const auto value = [i](const Hit& one) { return parameterValue(one.constants, i); };
        m_editors[i]->setSpan(i == 1 ? size * size : size);
        m_editors[i]->setReset(parameterValue(next, i), tr("As the next hit: %1"));
        m_editors[i]->setValue(value(hit));
        if (!isSame(hit, value)) {
            m_editors[i]->showDiffering();
        }
    }
}

DeformationConstants HitInspectorPanel::presetFor(const ConstantsPreset& preset, const Hit& hit) const {
    const Target* target = m_session.targets().find(hit.target);
    return target != nullptr
               ? constantsOn(target->extent(),
                             {preset.constants, m_session.settings().constantsSetting().relative})
               : preset.constants;
}

void HitInspectorPanel::showPreset(const Hit& hit) {
    int shown = -1;
    if (isSame(hit, [](const Hit& one) { return one.constants; }) &&
        isSame(hit, [](const Hit& one) { return one.form; })) {
        for (std::size_t i = 0; i < m_presets.all().size() && shown < 0; ++i) {
            const ConstantsPreset& preset = m_presets.all()[i];
            const bool isIt = presetFor(preset, hit) == hit.constants && preset.holdsFor(hit.form);
            shown = isIt ? static_cast<int>(i) : -1;
        }
    }
    m_ui->preset->setCurrentIndex(shown);
}

void HitInspectorPanel::choosePreset(int row) {
    const auto preset = static_cast<std::size_t>(row);
    if (preset < m_presets.all().size()) {
        once(Preset, [this, chosen = m_presets.all()[preset]](Hit& hit) {
            hit.constants = presetFor(chosen, hit);
            if (chosen.form) {
                hit.form = withRadius(m_session, *chosen.form, hit);
            }
        });
    } else {
        once(Preset, [this](Hit& hit) {
            hit.constants = usualConstants(m_session, hit);
            hit.form = usualForm(m_session, hit);
        });
    }
    show();
}

void HitInspectorPanel::once(int part, const HitEditing::Edit& edit) {
    m_editing.endGesture();
    m_editing.change(part, edit);
    m_editing.endGesture();
}

void HitInspectorPanel::showDirection(const Hit& hit) {
    m_direction->show(hit.direction);
    m_direction->showDiffering(!isSame(hit, [](const Hit& one) { return azimuthOf(one.direction); }),
                               !isSame(hit, [](const Hit& one) { return elevationOf(one.direction); }));
    m_ui->asShot->setChecked(isAlong(hit.direction, flightOf(hit)));
    m_ui->intoSurface->setChecked(knowsSurface(hit) && isAlong(hit.direction, -hit.normal));
    enableIf(*m_ui->intoSurface, knowsSurface(hit),
             tr("It is not known how the surface stood where it was hit."));
}

void HitInspectorPanel::showPoint(const Hit& hit) {
    const Target* target = m_session.targets().find(hit.target);
    for (int axis = 0; axis < 3; ++axis) {
        NumberBox& box = *m_point[static_cast<std::size_t>(axis)];
        box.setStepsWithin(target != nullptr ? static_cast<double>(target->extent()) : 0.0);
        box.showNumber(static_cast<double>(hit.point[axis]));
        if (!isSame(hit, [axis](const Hit& one) { return one.point[axis]; })) {
            box.showDiffering();
        }
    }
}

}  // namespace hitscope
