// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QToolButton>

namespace hitscope {

/// Shows a colour; a click opens a dialog to choose another, which is followed live.
class ColourButton : public QToolButton {
    Q_OBJECT
public:
    explicit ColourButton(QWidget* parent = nullptr);

    [[nodiscard]] QColor colour() const { return m_colour; }
    void setColour(const QColor& colour);  ///< emits nothing

Q_SIGNALS:
    void colourPicked(const QColor& colour);

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose();
    void drawSwatch();

    QColor m_colour = Qt::white;
};

}  // namespace hitscope
