// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/bounds.h"
#include "models/hit_list.h"

class QAction;

namespace hitscope {
class HitFilterBar;
}

namespace Ui {
class HitHistory;
}

namespace hitscope {

/// The dock "Hit history": a row a hit, with a check box that enables it. The current row's hit is marked in
/// the viewport; the selected ones can be disabled, moved (also by dragging), removed and copied as CSV, and
/// one can be edited, from the context menu or by key. Rows can be filtered, and sorted by a column, and
/// columns shown and hidden. The hits of a group can be selected together: by a double click on its name.
/// Below, a slider goes back and forth through the hits, and it says how many there are and, for a pipeline
/// with a capacity, how full it is.
class HitHistoryPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` and `model` outlive the panel.
    HitHistoryPanel(Session& session, HitHistoryModel& model, QWidget* parent = nullptr);
    ~HitHistoryPanel() override;

    /// Widths, order and visibility of the columns, to be kept for the next start.
    [[nodiscard]] QByteArray columns() const;
    void setColumns(const QByteArray& columns);  ///< what columns() gave once; else nothing happens
    /// Puts more actions, about all hits, at the end of the context menu.
    void addHitActions(const QList<QAction*>& actions);

Q_SIGNALS:
    /// A person wants to look at a hit: this part of the world.
    void flyWanted(const hitscope::Bounds& part);
    void editWanted();                                        ///< of the selected hits
    void rowsSelected(const std::vector<std::size_t>& rows);  ///< of the history, ascending

private:
    void setUpTable();
    void connectAll();
    void makeActions();
    QAction* makeAction(const QString& text, const QKeySequence& key, void (HitHistoryPanel::*act)());
    void toggleSelected();
    void moveSelectedUp();
    void moveSelectedDown();
    void removeSelected();
    void copySelected();
    void flyToCurrent();
    void toggleFilter();
    void selectTargetsHits();
    void selectGroup();
    /// Those in the list for whom `isWanted` of the hit says so.
    void selectHits(const std::function<bool(const Hit&)>& isWanted);
    void groupSelected();
    void ungroupSelected();
    void activate(const QModelIndex& index);
    void showSelectedHit();  ///< session -> table
    void followSelection();  ///< table -> session
    void updateSummary();
    void updateActions();
    void scrollToNewest();
    /// Ascending. Costs what is selected, not what there is.
    [[nodiscard]] std::vector<std::size_t> selectedRows() const;  ///< of the history
    /// Of the history; nothing: no row is current.
    [[nodiscard]] std::optional<std::size_t> currentHit() const;
    [[nodiscard]] bool isAnyEnabled(const std::vector<std::size_t>& rows) const;

    Session& m_session;
    HitHistoryModel& m_model;
    HitList m_list;
    std::unique_ptr<Ui::HitHistory> m_ui;
    QAction* m_toggle = nullptr;
    QAction* m_up = nullptr;
    QAction* m_down = nullptr;
    QAction* m_remove = nullptr;
    QAction* m_copy = nullptr;
    QAction* m_selectTargets = nullptr;
    QAction* m_selectGroup = nullptr;
    QAction* m_group = nullptr;
    QAction* m_ungroup = nullptr;
    QAction* m_edit = nullptr;
    QAction* m_fly = nullptr;
    QAction* m_filter = nullptr;
    HitFilterBar* m_filterBar = nullptr;
    bool m_atNewest = true;  ///< the table stood at its end before rows came
    bool m_following = false;
};

}  // namespace hitscope
