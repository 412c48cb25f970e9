// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/parameter.h"

class QDoubleSpinBox;
class QGridLayout;
class QSlider;
class QToolButton;

namespace hitscope {

/// Label, slider, spin box and reset button for one parameter, made from its descriptor and put into a row of
/// a grid.
class ParameterEditor : public QObject {
    Q_OBJECT
public:
    /// Columns 0 to 3 of `row`. `parent` owns the widgets.
    ParameterEditor(const ParameterDescriptor& parameter, QGridLayout& grid, int row, QWidget* parent);

    void setValue(double value);  ///< emits nothing

Q_SIGNALS:
    void edited(double value);

private:
    void show(double value);
    [[nodiscard]] int sliderFor(double value) const;
    [[nodiscard]] double valueFor(int slider) const;

    ParameterDescriptor m_parameter;
    QSlider* m_slider = nullptr;
    QDoubleSpinBox* m_spinBox = nullptr;
    QToolButton* m_reset = nullptr;
};

}  // namespace hitscope
