// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/parameter_editor.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "panels/fields/number_box.h"
#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kSliderSteps = 1000;
constexpr int kSliderDigits = 3;  // that it gives

/// Ranges span several powers of ten, and the useful values sit near the lower end; the slider's travel is
/// spread so that the default value is in its middle.
double exponentOf(const ParameterDescriptor& parameter) {
    const double share =
        (parameter.defaultValue - parameter.minimum) / (parameter.maximum - parameter.minimum);
    return share > 0.0 && share < 0.5 ? std::log(share) / std::log(0.5) : 1.0;
}

double toDigits(double value, int digits) {
    return QString::number(value, 'g', digits).toDouble();
}

/// 0.3 and not 0.30000001192: what a float's shortest decimal is.
double decimalOf(double value) {
    return toDigits(value, 7);
}

}  // namespace

ParameterEditor::ParameterEditor(const ParameterDescriptor& parameter, const ParameterDescriptor& usual,
                                 QGridLayout& grid, int row, QWidget* parent)
    : QObject(parent),
      m_parameter(parameter),
      m_usual(usual),
      m_resetTo(usual.defaultValue),
      m_label(new QLabel(QString::fromUtf8(parameter.label), parent)),
      m_slider(new QSlider(Qt::Horizontal, parent)),
      m_box(new NumberBox(parent)),
      m_reset(new QToolButton(parent)) {
    m_label->setBuddy(m_box);
    m_slider->setRange(0, kSliderSteps);
    m_slider->setMinimumWidth(60);
    m_slider->setAccessibleName(m_label->text());
    m_box->setObjectName(QString::fromUtf8(parameter.key));
    m_box->setSingleStep(0.0);
    m_reset->setIcon(themedIcon(QStringLiteral("reset")));
    m_reset->setAutoRaise(true);
    setUnit(1.0, QString::fromUtf8(parameter.unit));
    grid.addWidget(m_label, row, 0);
    grid.addWidget(m_slider, row, 1);
    grid.addWidget(m_box, row, 2);
    grid.addWidget(m_reset, row, 3);

    connect(m_slider, &QSlider::valueChanged, this, [this](int slider) {
        const double shown = toDigits(shownOf(valueFor(slider)), kSliderDigits);
        m_box->showNumber(shown);
        Q_EMIT edited(decimalOf(shown / m_scale));
    });
    m_slider->installEventFilter(this);
    connect(m_slider, &QSlider::sliderPressed, this,
            [this] { m_before = m_box->differs() ? std::nullopt : std::optional(m_box->value()); });
    connect(m_slider, &QSlider::sliderReleased, this, &ParameterEditor::finished);
    connect(m_box, &NumberBox::edited, this, &ParameterEditor::edit);
    connect(m_box, &NumberBox::editingFinished, this, &ParameterEditor::finished);
    connect(m_reset, &QToolButton::clicked, this, [this] {
        Q_EMIT finished();
        Q_EMIT edited(m_resetTo);
        Q_EMIT finished();
    });
}

bool ParameterEditor::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    // The type first: events also arrive while the slider is being destroyed, when it is a plain QWidget.
    if (watched == m_slider && (type == QEvent::ShortcutOverride || type == QEvent::KeyPress) &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && m_slider->isSliderDown()) {
        event->accept();
        if (type == QEvent::KeyPress) {
            cancelDrag();
        }
        return true;
    }
    if (watched == m_slider && type == QEvent::MouseButtonRelease) {
        m_isCancelled = false;
    }
    return m_isCancelled && watched == m_slider && type == QEvent::MouseMove;
}

void ParameterEditor::cancelDrag() {
    if (m_before) {
        m_isCancelled = true;
        m_box->showNumber(*m_before);
        edit(*m_before);
        m_slider->setSliderDown(false);
    }
}

void ParameterEditor::edit(double shown) {
    const double value = m_scale == 1.0 ? shown : decimalOf(shown / m_scale);
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(sliderFor(value));
    Q_EMIT edited(value);
}

void ParameterEditor::setUnit(double scale, const QString& unit) {
    m_scale = scale;
    const QSignalBlocker quiet(m_box);
    m_box->setSuffix(unit.isEmpty() ? unit : QChar(u' ') + unit);
    m_box->setRange(shownOf(m_parameter.minimum), shownOf(m_parameter.maximum));
    showRange();
}

void ParameterEditor::setSpan(double scale) {
    m_span = scale;
}

void ParameterEditor::setReset(double value, const QString& tip) {
    m_resetTo = value;
    m_resetTip = tip;
    showRange();
}

void ParameterEditor::showRange() {
    const auto text = [this](double value) { return shownFloat(static_cast<float>(shownOf(value))); };
    const QString range = tr("%1\nFrom %2 to %3%4.")
                              .arg(QString::fromUtf8(m_parameter.description), text(m_parameter.minimum),
                                   text(m_parameter.maximum), m_box->suffix());
    for (QWidget* widget :
         {static_cast<QWidget*>(m_label), static_cast<QWidget*>(m_slider), static_cast<QWidget*>(m_box)}) {
        widget->setToolTip(range);
    }
    m_reset->setToolTip(
        (m_resetTip.isEmpty() ? tr("Back to %1") : m_resetTip).arg(text(m_resetTo) + m_box->suffix()));
}

double ParameterEditor::shownOf(double value) const {
    return m_scale == 1.0 ? value : decimalOf(decimalOf(value) * m_scale);
}

void ParameterEditor::setValue(double value) {
    m_box->showNumber(shownOf(value));
    enableIf(*m_reset, static_cast<float>(value) != static_cast<float>(m_resetTo),
             tr("It has this value already."));
    // What is dragged stays under the cursor.
    if (!m_slider->isSliderDown()) {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(sliderFor(value));
    }
}

void ParameterEditor::showDiffering() {
    m_box->showDiffering();
    m_reset->setEnabled(true);
}

void ParameterEditor::setVisible(bool isVisible) {
    for (QWidget* widget : {static_cast<QWidget*>(m_label), static_cast<QWidget*>(m_slider),
                            static_cast<QWidget*>(m_box), static_cast<QWidget*>(m_reset)}) {
        widget->setVisible(isVisible);
    }
}

void ParameterEditor::enable(bool enabled, const QString& why) {
    for (QWidget* widget : {static_cast<QWidget*>(m_slider), static_cast<QWidget*>(m_box)}) {
        enableIf(*widget, enabled, why);
    }
    if (!enabled) {
        enableIf(*m_reset, false, why);
    }
}

int ParameterEditor::sliderFor(double value) const {
    const double share = (value / m_span - m_usual.minimum) / (m_usual.maximum - m_usual.minimum);
    return static_cast<int>(
        std::lround(kSliderSteps * std::pow(std::clamp(share, 0.0, 1.0), 1.0 / exponentOf(m_usual))));
}

double ParameterEditor::valueFor(int slider) const {
    const double share = std::pow(static_cast<double>(slider) / kSliderSteps, exponentOf(m_usual));
    return m_span * (m_usual.minimum + share * (m_usual.maximum - m_usual.minimum));
}

}  // namespace hitscope
