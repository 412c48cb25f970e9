// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace hitscope {

/// A spin box for a float of any size: shows the shortest decimal that reads back as the same float, rounded
/// where there is no room for it and it is not being edited, and steps by a fifth of its leading digit, or by
/// singleStep() where that is not 0. It can say that it stands for several numbers which differ.
///
/// Takes a decimal point or comma in any locale, and lengths in µm, mm, cm, m or km; what it does not
/// understand it leaves alone, and says so.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit NumberBox(QWidget* parent = nullptr);

    /// Of lengths, where no suffix shows it but a label does.
    void setUnit(const QString& unit) { m_unit = unit; }
    /// Emits nothing. Keeps what is being typed.
    void showNumber(double value);
    void showDiffering();
    [[nodiscard]] bool differs() const { return m_differs; }  ///< it stands for several numbers

    [[nodiscard]] QString textFromValue(double value) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;
    void stepBy(int steps) override;
    /// Steps by a power of ten, a hundredth to a tenth of that, and shows no more than a thousandth of a step
    /// while it is not edited; nothing where it is not positive.
    void setStepsWithin(double span);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
    /// A double click selects the whole number, and not what is on one side of its point.
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void edited(double value);  ///< by a person, or setValue()

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] std::optional<double> read(const QString& text) const;
    void showText();
    [[nodiscard]] bool isTyping() const;
    [[nodiscard]] double stepAt(double value) const;
    void finishTyping();
    [[nodiscard]] QString number(const QString& text) const;

    bool m_differs = false;
    double m_resolution = 0.0;  ///< 0: all digits
    QString m_unit;
};

}  // namespace hitscope
