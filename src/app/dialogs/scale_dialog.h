// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace hitscope {

class NumberBox;

/// Asks for the size that a target's mesh shall have: its largest extent, or how many times as large it is.
class ScaleDialog : public QDialog {
    Q_OBJECT
public:
    /// `extent`: metres, as it is now; > 0. `name`: of the target.
    ScaleDialog(const QString& name, double extent, QWidget* parent);

    [[nodiscard]] double extent() const;  ///< metres

private:
    double m_now;
    NumberBox* m_extent;
    NumberBox* m_factor;
};

}  // namespace hitscope
