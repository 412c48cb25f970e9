// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "deform/deformation_constants.h"

class QCPItemLine;
class QCPItemText;
class QCustomPlot;

namespace hitscope {

/// How far a vertex moves by its distance from the hit point: flat up to the cap's corner, then power / r,
/// then the step to nothing at the rim.
class FalloffPlot : public QWidget {
    Q_OBJECT
public:
    explicit FalloffPlot(QWidget* parent = nullptr);

    enum class Unit { Metres, PerCentOfTarget };
    /// `constants` are in that unit, and power in its square.
    void show(const DeformationConstants& constants, Unit unit = Unit::Metres);

protected:
    void changeEvent(QEvent* event) override;

private:
    void makeItems();
    void applyPalette();
    void placeCorner(double distance, double magnitude);
    void placeStep(double rim, double step, double above);

    void nameUnit(Unit unit);

    QCustomPlot* m_plot = nullptr;
    QString m_unit;
    QCPItemLine* m_step = nullptr;
    QCPItemText* m_cornerText = nullptr;
    QCPItemText* m_stepText = nullptr;
};

}  // namespace hitscope
