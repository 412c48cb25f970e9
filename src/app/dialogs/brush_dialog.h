// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;

namespace hitscope {

class BrushTool;

/// The brush's size, strength, spacing and direction. Stays open beside the window.
class BrushDialog : public QDialog {
    Q_OBJECT
public:
    /// `brush` outlives this.
    BrushDialog(BrushTool& brush, QWidget* parent);

private:
    void showSettings();
    void apply();

    BrushTool& m_brush;
    QDoubleSpinBox* m_size;
    QDoubleSpinBox* m_strength;
    QComboBox* m_unit;
    QDoubleSpinBox* m_spacing;
    QDoubleSpinBox* m_millimetres;
    QComboBox* m_direction;
    bool m_isShowing = false;
};

}  // namespace hitscope
