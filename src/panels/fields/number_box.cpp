// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/fields/number_box.h"

#include <QEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <algorithm>
#include <cmath>
#include <utility>

#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kDecimals = 24;           // none is lost of the smallest number a hit may have
constexpr double kStepsToNumber = 5.0;  // of its leading digit: 0.5 goes by 0.02 or so
constexpr double kLeastStep = 1.0e-12;
constexpr int kWidest = 9;  // characters

}  // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(kDecimals);
    setKeyboardTracking(false);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        m_differs = false;
        Q_EMIT edited(value);
    });
    lineEdit()->installEventFilter(this);
    connect(this, &QDoubleSpinBox::editingFinished, this, &NumberBox::finishTyping);
}

bool NumberBox::isTyping() const {
    return hasFocus() && lineEdit()->isModified();
}

/// Typing the number that stands for those that differ changes them all the same.
void NumberBox::finishTyping() {
    const bool wasTyping = lineEdit()->isModified();
    lineEdit()->setModified(false);
    if (m_differs && wasTyping) {
        m_differs = false;
        Q_EMIT edited(value());
    }
}

void NumberBox::showNumber(double value) {
    const QSignalBlocker quiet(this);
    const bool differed = std::exchange(m_differs, false);
    if (!isTyping() && (differed || value != this->value())) {
        setValue(value);
        lineEdit()->setText(prefix() + textFromValue(this->value()) + suffix());
    }
}

void NumberBox::showDiffering() {
    m_differs = true;
    if (!isTyping()) {
        const QSignalBlocker quiet(lineEdit());
        lineEdit()->setText(prefix() + textFromValue(value()) + suffix());
    }
}

QString NumberBox::textFromValue(double value) const {
    if (m_differs) {
        const bool touches = !suffix().isEmpty() && !suffix().front().isSpace();  // as "°" does
        return touches ? tr("differ") + u' ' : tr("differ");
    }
    return shownFloat(static_cast<float>(value));
}

QString NumberBox::number(const QString& text) const {
    QString number = text.trimmed();
    if (!suffix().isEmpty() && number.endsWith(suffix().trimmed())) {
        number.chop(suffix().trimmed().size());
    }
    return number.trimmed();
}

double NumberBox::valueFromText(const QString& text) const {
    bool isNumber = false;
    const double read = locale().toDouble(number(text), &isNumber);
    return isNumber ? read : value();
}

QValidator::State NumberBox::validate(QString& text, int& /*position*/) const {
    bool isNumber = false;
    const double read = locale().toDouble(number(text), &isNumber);
    if (isNumber || (m_differs && number(text) == textFromValue(value()).trimmed())) {
        return !isNumber || (read >= minimum() && read <= maximum()) ? QValidator::Acceptable
                                                                     : QValidator::Intermediate;
    }
    const QString typed = number(text);
    const QString allowed = QStringLiteral("0123456789+-eE") + locale().decimalPoint();
    const bool mayBecome = std::all_of(typed.begin(), typed.end(),
                                       [&allowed](QChar character) { return allowed.contains(character); });
    return mayBecome ? QValidator::Intermediate : QValidator::Invalid;
}

double NumberBox::stepAt(double value) const {
    const double size = std::max(std::abs(value), kLeastStep);
    return std::pow(10.0, std::floor(std::log10(size))) / kStepsToNumber;
}

/// To round numbers, so that steps up and down meet.
void NumberBox::stepBy(int steps) {
    const bool isAngle = singleStep() != 0.0;
    const double step = isAngle ? singleStep() : stepAt(value());
    const double next = std::clamp(std::round(value() / step + steps) * step, minimum(), maximum());
    if (m_differs && next == value()) {
        m_differs = false;
        Q_EMIT edited(next);
    } else {
        setValue(next);
    }
    lineEdit()->setModified(false);
}

bool NumberBox::eventFilter(QObject* watched, QEvent* event) {
    if (watched == lineEdit() && event->type() == QEvent::MouseButtonDblClick) {
        selectAll();
        return true;
    }
    return QDoubleSpinBox::eventFilter(watched, event);
}

QSize NumberBox::sizeHint() const {
    const int width =
        fontMetrics().horizontalAdvance(QString(kWidest, u'0') + suffix()) + fontMetrics().averageCharWidth();
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option,
                                     QSize(width, lineEdit()->sizeHint().height()), this);
}

}  // namespace hitscope
