// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/parameter_editor.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "panels/icons/themed_icon.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kSliderSteps = 1000;

/// Ranges span several powers of ten, and the useful values sit near the lower end; the slider's travel is
/// spread so that the default value is in its middle.
double exponentOf(const ParameterDescriptor& parameter) {
    const double share =
        (parameter.defaultValue - parameter.minimum) / (parameter.maximum - parameter.minimum);
    return share > 0.0 && share < 0.5 ? std::log(share) / std::log(0.5) : 1.0;
}

}  // namespace

ParameterEditor::ParameterEditor(const ParameterDescriptor& parameter, QGridLayout& grid, int row,
                                 QWidget* parent)
    : QObject(parent),
      m_parameter(parameter),
      m_slider(new QSlider(Qt::Horizontal, parent)),
      m_spinBox(new QDoubleSpinBox(parent)),
      m_reset(new QToolButton(parent)) {
    auto* label = new QLabel(QString::fromUtf8(parameter.label), parent);
    label->setBuddy(m_spinBox);
    m_slider->setRange(0, kSliderSteps);
    m_slider->setMinimumWidth(60);
    m_spinBox->setRange(parameter.minimum, parameter.maximum);
    m_spinBox->setDecimals(parameter.decimals);
    m_spinBox->setSingleStep(parameter.step);
    m_spinBox->setKeyboardTracking(false);
    if (!parameter.unit.empty()) {
        m_spinBox->setSuffix(u' ' + QString::fromUtf8(parameter.unit));
    }
    m_spinBox->setObjectName(QString::fromUtf8(parameter.key));
    m_reset->setIcon(themedIcon(QStringLiteral("reset")));
    m_reset->setAutoRaise(true);
    m_reset->setToolTip(
        tr("Back to %1 %2").arg(shownNumber(parameter.defaultValue), QString::fromUtf8(parameter.unit)));
    const QString range = tr("%1\nFrom %2 to %3.")
                              .arg(QString::fromUtf8(parameter.description), shownNumber(parameter.minimum),
                                   shownNumber(parameter.maximum));
    for (QWidget* widget :
         {static_cast<QWidget*>(label), static_cast<QWidget*>(m_slider), static_cast<QWidget*>(m_spinBox)}) {
        widget->setToolTip(range);
    }
    grid.addWidget(label, row, 0);
    grid.addWidget(m_slider, row, 1);
    grid.addWidget(m_spinBox, row, 2);
    grid.addWidget(m_reset, row, 3);

    connect(m_slider, &QSlider::valueChanged, this, [this](int slider) { show(valueFor(slider)); });
    connect(m_slider, &QSlider::valueChanged, this, [this] { Q_EMIT edited(m_spinBox->value()); });
    connect(m_spinBox, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        setValue(value);
        Q_EMIT edited(value);
    });
    connect(m_reset, &QToolButton::clicked, this, [this] { m_spinBox->setValue(m_parameter.defaultValue); });
}

void ParameterEditor::show(double value) {
    const QSignalBlocker quiet(m_spinBox);
    m_spinBox->setValue(value);
    m_reset->setEnabled(std::abs(m_spinBox->value() - m_parameter.defaultValue) >
                        0.5 * std::pow(10.0, -m_parameter.decimals));
}

void ParameterEditor::setValue(double value) {
    show(value);
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(sliderFor(value));
}

int ParameterEditor::sliderFor(double value) const {
    const double share = (value - m_parameter.minimum) / (m_parameter.maximum - m_parameter.minimum);
    return static_cast<int>(std::lround(kSliderSteps * std::pow(share, 1.0 / exponentOf(m_parameter))));
}

double ParameterEditor::valueFor(int slider) const {
    const double share = std::pow(static_cast<double>(slider) / kSliderSteps, exponentOf(m_parameter));
    return m_parameter.minimum + share * (m_parameter.maximum - m_parameter.minimum);
}

}  // namespace hitscope
