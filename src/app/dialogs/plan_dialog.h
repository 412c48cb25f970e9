// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>

#include "analysis/hit_planner.h"

class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace hitscope {

class Viewport;

/// Asks for many hits at once, and shows ghosts of them in the picture until they are made. Stays open beside
/// the window, so that the camera can be moved.
class PlanDialog : public QDialog {
    Q_OBJECT
public:
    /// All outlive this but `parent`. `apply`: what the button says.
    PlanDialog(Session& session, Viewport& viewport, const QString& title, const QString& apply,
               QWidget* parent);
    ~PlanDialog() override;

    [[nodiscard]] HitPlanner& planner() { return m_planner; }
    /// Makes the hits that are planned, as a group and one step to undo, and closes. Nothing while they are
    /// being worked out, or there are none.
    void apply();

Q_SIGNALS:
    void made(const QString& text);  ///< says what, for the status bar
    void failed(const hitscope::Error& error);

protected:
    /// Asks the planner for what the fields say.
    virtual void replan() = 0;
    [[nodiscard]] virtual HitGroupKind kind() const = 0;
    [[nodiscard]] virtual QString summary(const HitPlanner::Plan& plan) const = 0;
    [[nodiscard]] QFormLayout& fields() { return *m_fields; }
    [[nodiscard]] Session& session() const { return m_session; }
    [[nodiscard]] Viewport& viewport() const { return m_viewport; }
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void followTargets();
    void showPlan();

    Session& m_session;
    Viewport& m_viewport;
    HitPlanner m_planner;
    QTimer m_replan;  ///< once for all that changes in a turn of the event loop
    QFormLayout* m_fields;
    QLabel* m_summary;
    QPushButton* m_apply;
};

}  // namespace hitscope
