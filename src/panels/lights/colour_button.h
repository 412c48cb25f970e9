// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QToolButton>

namespace hitscope {

/// Shows a colour; a click opens a dialog to choose another, which is followed live until it is taken or not.
class ColourButton : public QToolButton {
    Q_OBJECT
public:
    explicit ColourButton(QWidget* parent = nullptr);

    void setDialogTitle(const QString& title) { m_dialogTitle = title; }  ///< says whose colour it is
    [[nodiscard]] QColor colour() const { return m_colour; }
    void setColour(const QColor& colour);  ///< emits nothing

Q_SIGNALS:
    void colourTried(const QColor& colour);   ///< to be shown; not yet taken
    void colourPicked(const QColor& colour);  ///< taken; all that was tried before is not
    void cancelled();                         ///< likewise none is taken

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose();
    void drawSwatch();

    QColor m_colour = Qt::white;
    QString m_dialogTitle;
};

}  // namespace hitscope
