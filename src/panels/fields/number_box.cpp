// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/fields/number_box.h"

#include <QEvent>
#include <QFocusEvent>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QTimer>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "models/plain_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kDecimals = 24;           // none is lost of the smallest number a hit may have
constexpr double kStepsToNumber = 5.0;  // of its leading digit: 0.5 goes by 0.02 or so
constexpr double kLeastStep = 1.0e-12;
constexpr double kResolution = 1.0e-3;  // of what is shown, times the step
constexpr int kWidest = 9;              // characters
constexpr int kMostDigits = 6;          // of what is wider, and rounded

struct LengthUnit {
    QLatin1String name;
    double metres;
};

/// Of a number with its unit; empty: it has none of these. The longer names come before those they end with.
std::optional<LengthUnit> unitAtEnd(const QString& text) {
    constexpr std::array<LengthUnit, 5> kUnits{{{QLatin1String("um"), 1.0e-6},
                                                {QLatin1String("mm"), 1.0e-3},
                                                {QLatin1String("cm"), 1.0e-2},
                                                {QLatin1String("km"), 1.0e3},
                                                {QLatin1String("m"), 1.0}}};
    const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                   [&text](const LengthUnit& each) { return text.endsWith(each.name); });
    return unit != kUnits.end() ? std::optional(*unit) : std::nullopt;
}

bool isLength(const QString& unit) {
    const auto known = unitAtEnd(unit);
    return known && unit == known->name;
}

/// With a point or a comma, of which there is one: boxes show no thousands apart.
std::optional<double> readNumber(QString text) {
    text.replace(u',', u'.');
    bool isNumber = false;
    const double number = QLocale::c().toDouble(text, &isNumber);
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

QString roundedTo(double value, int digits) {
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
    return locale.toString(value, 'g', digits);
}

}  // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setDecimals(kDecimals);
    setKeyboardTracking(false);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (std::exchange(m_differs, false)) {
            showText();  // Qt has just shown again that they differ
        }
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
    const bool isRounded = m_resolution > 0.0 && !hasFocus();
    QString text = shownFloat(
        static_cast<float>(isRounded ? std::round(value / m_resolution) * m_resolution + 0.0 : value));
    for (int digits = kMostDigits; !hasFocus() && text.size() > kWidest && digits > 2; --digits) {
        text = roundedTo(value, digits);
    }
    return text;
}

/// What was typed, without prefix and suffix; of "30 cm" the unit stays.
QString NumberBox::number(const QString& text) const {
    QString number = text.trimmed();
    if (const QString before = prefix().trimmed(); !before.isEmpty() && number.startsWith(before)) {
        number.remove(0, before.size());
    }
    const QString unit = suffix().trimmed();
    if (!unit.isEmpty() && number.endsWith(unit)) {
        const QString rest = number.chopped(unit.size());
        // What is typed comes before the box's own suffix.
        const bool isWhole = suffix().front().isSpace() && number.endsWith(suffix());
        const bool isOtherUnit =
            !isWhole && !rest.isEmpty() && QStringLiteral("umck\u00b5\u03bc").contains(rest.back());
        number = isOtherUnit ? number : rest;
    }
    return number.trimmed();
}

/// In the unit that the box shows.
std::optional<double> NumberBox::read(const QString& text) const {
    const QString typed = number(text);
    if (const std::optional<double> plain = readNumber(typed)) {
        return plain;
    }
    const QString own = m_unit.isEmpty() ? suffix().trimmed() : m_unit;
    QString length = typed;
    length.replace(QChar(0xb5), u'u').replace(QChar(0x3bc), u'u');  // the two characters for micro
    const auto unit = unitAtEnd(length);
    if (!unit || !isLength(own)) {
        return std::nullopt;
    }
    const std::optional<double> read = readNumber(length.chopped(unit->name.size()).trimmed());
    return read ? std::optional(*read * (unit->metres / unitAtEnd(own)->metres)) : std::nullopt;
}

/// A number that is shown rounded is still the one it was.
double NumberBox::valueFromText(const QString& text) const {
    const QString shown = number(text);
    return shown == textFromValue(value()) ? value() : read(text).value_or(value());
}

QValidator::State NumberBox::validate(QString& text, int& /*position*/) const {
    const std::optional<double> typed = read(text);
    const bool isLeft = number(text) == textFromValue(value()).trimmed();  // as where several differ
    return isLeft || (typed && *typed >= minimum() && *typed <= maximum()) ? QValidator::Acceptable
                                                                           : QValidator::Intermediate;
}

/// The number stays what it was.
void NumberBox::fixup(QString& text) const {
    const bool isUnitTaken = isLength(m_unit.isEmpty() ? suffix().trimmed() : m_unit);
    const QString said =
        (isUnitTaken
             ? tr("“%1” was not taken: type a number from %2 to %3. It may be in µm, mm, cm, m or km.")
             : tr("“%1” was not taken: type a number from %2 to %3."))
            .arg(number(text), shownFloat(static_cast<float>(minimum())),
                 shownFloat(static_cast<float>(maximum())) + suffix());
    // Later: Return gives the focus away, which hides the tip that is shown.
    auto* box = const_cast<NumberBox*>(this);
    QTimer::singleShot(0, box, [box, said] {
        QToolTip::showText(box->mapToGlobal(box->rect().bottomLeft()), asPlainText(said), box);
    });
}

/// In full while it is edited.
void NumberBox::showText() {
    if (!lineEdit()->isModified()) {
        const QSignalBlocker quiet(lineEdit());
        lineEdit()->setText(prefix() + textFromValue(value()) + suffix());
    }
}

/// Behind the unit nothing can be typed: a click there means the end of the number.
void NumberBox::keyPressEvent(QKeyEvent* event) {
    const auto end = static_cast<int>(lineEdit()->text().size() - suffix().size());
    if (lineEdit()->cursorPosition() > end && !lineEdit()->hasSelectedText() &&
        lineEdit()->text().endsWith(suffix())) {
        lineEdit()->setCursorPosition(end);
    }
    QDoubleSpinBox::keyPressEvent(event);
}

void NumberBox::focusInEvent(QFocusEvent* event) {
    showText();
    QDoubleSpinBox::focusInEvent(event);
}

void NumberBox::focusOutEvent(QFocusEvent* event) {
    QDoubleSpinBox::focusOutEvent(event);
    showText();
}

void NumberBox::setStepsWithin(double span) {
    // Qt shows the number anew for each step that is set, over what is being typed.
    if (span > 0.0 && std::isfinite(span) && !isTyping()) {
        setSingleStep(std::pow(10.0, std::floor(std::log10(span)) - 1.0));
        m_resolution = kResolution * singleStep();
    }
}

double NumberBox::stepAt(double value) const {
    const double size = std::max(std::abs(value), kLeastStep);
    return std::pow(10.0, std::floor(std::log10(size))) / kStepsToNumber;
}

/// To round numbers, so that steps up and down meet.
void NumberBox::stepBy(int steps) {
    const double step = singleStep() != 0.0 ? singleStep() : stepAt(value());
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
