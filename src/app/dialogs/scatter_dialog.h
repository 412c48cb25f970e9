// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/dialogs/plan_dialog.h"

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace hitscope {

class NumberBox;

/// Asks how hits shall be scattered over the target in focus. What was asked for last is remembered.
class ScatterDialog : public PlanDialog {
    Q_OBJECT
public:
    ScatterDialog(Session& session, Viewport& viewport, QWidget* parent);

    /// In the target's local frame, as it stands now.
    [[nodiscard]] ScatterPlan plan() const;

protected:
    void replan() override;
    [[nodiscard]] HitGroupKind kind() const override { return HitGroupKind::Scatter; }
    [[nodiscard]] QString summary(const HitPlanner::Plan& plan) const override;
    void hideEvent(QHideEvent* event) override;

private:
    void addFields();
    void showAmount();
    void restore();

    QComboBox* m_region;
    QComboBox* m_amount;
    QSpinBox* m_count;
    NumberBox* m_density;
    QDoubleSpinBox* m_size;
    QComboBox* m_direction;
    QDoubleSpinBox* m_cone;
    QSpinBox* m_seed;
};

}  // namespace hitscope
