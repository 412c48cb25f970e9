// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "core/parameter.h"

class QGridLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace hitscope {

class NumberBox;

/// Label, slider, spin box and reset button for one parameter, made from its descriptor and put into a row of
/// a grid. What it shows can be another unit than the one its values are in.
class ParameterEditor : public QObject {
    Q_OBJECT
public:
    /// Columns 0 to 3 of `row`. `parent` owns the widgets. The box takes what `parameter` allows, and the
    /// slider goes over the range of `usual`.
    ParameterEditor(const ParameterDescriptor& parameter, const ParameterDescriptor& usual, QGridLayout& grid,
                    int row, QWidget* parent);

    /// Shows values times `scale` in `unit`, which may be empty.
    void setUnit(double scale, const QString& unit);
    void setSpan(double scale);  ///< the slider goes over its range times `scale`
    /// Where the reset button goes; at first the default. `tip`: says so, with %1 for the value and its unit.
    void setReset(double value, const QString& tip = {});
    void setValue(double value);  ///< emits nothing
    void showDiffering();         ///< it stands for several values
    void setVisible(bool isVisible);
    void enable(bool enabled, const QString& why);  ///< enableIf()

Q_SIGNALS:
    void edited(double value);
    void finished();  ///< a drag of the slider or a run of edits has ended

protected:
    /// Escape takes back what a drag of the slider did.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void cancelDrag();
    void edit(double shown);
    void showRange();
    [[nodiscard]] double shownOf(double value) const;
    [[nodiscard]] int sliderFor(double value) const;
    [[nodiscard]] double valueFor(int slider) const;

    ParameterDescriptor m_parameter;
    ParameterDescriptor m_usual;
    double m_resetTo;
    QString m_resetTip;
    double m_scale = 1.0;
    double m_span = 1.0;
    QLabel* m_label = nullptr;
    QSlider* m_slider = nullptr;
    NumberBox* m_box = nullptr;
    QToolButton* m_reset = nullptr;
    std::optional<double> m_before;  ///< the drag; nothing: several values
    bool m_isCancelled = false;      ///< the drag, whose button is still held
};

}  // namespace hitscope
