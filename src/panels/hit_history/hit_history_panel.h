// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "models/hit_history_model.h"

class QAction;

namespace Ui {
class HitHistory;
}

namespace hitscope {

/// The dock "Hit history": a row a hit. The current row's hit is marked in the viewport; Delete removes the
/// selected hits, Ctrl+C copies them as CSV.
class HitHistoryPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` and `model` outlive the panel.
    HitHistoryPanel(Session& session, HitHistoryModel& model, QWidget* parent = nullptr);
    ~HitHistoryPanel() override;

private:
    void makeActions();
    void removeSelected();
    void copySelected();
    void showSelectedHit();  ///< session -> table
    void followSelection();  ///< table -> session
    void updateSummary();
    void scrollToNewest();
    [[nodiscard]] std::vector<int> selectedRows() const;  ///< ascending

    Session& m_session;
    HitHistoryModel& m_model;
    std::unique_ptr<Ui::HitHistory> m_ui;
    QAction* m_remove = nullptr;
    QAction* m_copy = nullptr;
    bool m_atNewest = true;  ///< the table stood at its end before rows came
    bool m_following = false;
};

}  // namespace hitscope
