// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QWidget>
#include <memory>
#include <vector>

#include "models/hit_history_model.h"

class QAction;

namespace Ui {
class HitHistory;
}

namespace hitscope {

/// The dock "Hit history": a row a hit, with a check box that enables it. The current row's hit is marked in
/// the viewport; the selected ones can be disabled, moved (also by dragging), removed and copied as CSV, from
/// the context menu or by key. Below, how many there are and, for a pipeline with a capacity, how full it is.
class HitHistoryPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` and `model` outlive the panel.
    HitHistoryPanel(Session& session, HitHistoryModel& model, QWidget* parent = nullptr);
    ~HitHistoryPanel() override;

private:
    void setUpTable();
    void connectAll();
    void makeActions();
    QAction* makeAction(const QString& text, const QKeySequence& key, void (HitHistoryPanel::*act)());
    void toggleSelected();
    void moveSelectedUp();
    void moveSelectedDown();
    void moveSelected(std::size_t to);
    void removeSelected();
    void copySelected();
    void selectTargetsHits();
    void showSelectedHit();  ///< session -> table
    void followSelection();  ///< table -> session
    void updateSummary();
    void updateActions();
    void scrollToNewest();
    /// Ascending. Costs what is selected, not what there is.
    [[nodiscard]] std::vector<std::size_t> selectedRows() const;
    [[nodiscard]] bool isAnyEnabled(const std::vector<std::size_t>& rows) const;

    Session& m_session;
    HitHistoryModel& m_model;
    std::unique_ptr<Ui::HitHistory> m_ui;
    QAction* m_toggle = nullptr;
    QAction* m_up = nullptr;
    QAction* m_down = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_copy = nullptr;
    QAction* m_selectTargets = nullptr;
    bool m_atNewest = true;  ///< the table stood at its end before rows came
    bool m_following = false;
};

}  // namespace hitscope
