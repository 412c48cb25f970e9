// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "deform/deformation_constants.h"
#include "deform/dent_form.h"

class QCPItemLine;
class QCPItemText;
class QCustomPlot;

namespace hitscope {

/// How far a vertex moves by its distance from the hit point, on a plane that is hit straight on, as deform()
/// has it. Of the paper's function: flat up to the cap's corner, then power / r, then the step to nothing at
/// the rim. The points of a free curve can be dragged, or chosen and moved by the arrow keys.
class FalloffPlot : public QWidget {
    Q_OBJECT
public:
    explicit FalloffPlot(QWidget* parent = nullptr);

    enum class Unit { Metres, PerCentOfTarget };
    /// `constants` and the form's radius are in that unit, and power in its square.
    void show(const DeformationConstants& constants, const DentForm& form = {}, Unit unit = Unit::Metres);

Q_SIGNALS:
    void curveEdited(const hitscope::CurveOrdinates& curve);
    void curveFinished();  ///< a drag or a key's move is over

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void takeMouse();
    void press(const QPointF& at);
    void dragTo(const QPointF& at);
    void setOrdinate(double ordinate);
    void setCurve(const CurveOrdinates& curve);
    void drawPaper();
    void drawForm();
    void drawPoints();
    void setRange(double lowest, double highest);
    [[nodiscard]] double rim() const;
    [[nodiscard]] bool isEditable() const;
    void makeItems();
    void applyPalette();
    void placeCorner(double distance, double magnitude);
    void placeStep(double rim, double step, double above);

    void nameUnit(Unit unit);

    QCustomPlot* m_plot = nullptr;
    QString m_unit;
    DeformationConstants m_constants;
    DentForm m_form;
    Unit m_unitShown = Unit::Metres;
    int m_point = 0;            ///< of the curve: chosen
    CurveOrdinates m_before{};  ///< the drag
    bool m_isDragging = false;  ///< m_point
    QCPItemLine* m_step = nullptr;
    QCPItemText* m_cornerText = nullptr;
    QCPItemText* m_stepText = nullptr;
};

}  // namespace hitscope
