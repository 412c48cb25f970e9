// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "analysis/change_values.h"
#include "analysis/comparison.h"
#include "view/display_options.h"

class QAction;
class QMenu;

namespace hitscope {

class ChangePanel;
class HitEffects;
class Viewport;

/// Everything about showing change: the values behind it, the dock, the menu and its keys, held together with
/// the viewport's options.
class ChangeActions : public QObject {
    Q_OBJECT
public:
    /// All outlive this, or are children of the same parent. The panel is for a dock.
    ChangeActions(Session& session, HitEffects& effects, Viewport& viewport, QObject* parent);

    [[nodiscard]] ChangePanel* panel() { return m_panel; }
    void fill(QMenu& menu);  ///< once
    [[nodiscard]] ChangeValues& values() { return m_values; }
    [[nodiscard]] Comparison& comparison() { return m_comparison; }

    /// Somebody else has set the viewport's options.
    void follow();

private:
    void change(const std::function<void(DisplayOptions&)>& edit);
    void followCounts(HitEffects& effects);
    void fillQuantities(QMenu& menu);
    void fillGhosts(QMenu& menu);
    void fillPipelines(QMenu& menu);
    void followComparison();
    void setSideBySide(bool on);
    [[nodiscard]] PipelineKind usualOther() const;
    void chooseOther(std::optional<PipelineKind> other);
    QAction* addToggle(QMenu& menu, const QString& text, const QKeySequence& keys,
                       std::function<void(DisplayOptions&, bool)> edit);

    Session& m_session;
    Viewport& m_viewport;
    ChangeValues m_values;
    Comparison m_comparison;
    ChangePanel* m_panel;
    std::map<TargetId, std::set<std::uint32_t>>
        m_recounting;  ///< clusters whose numbers of hits may be behind
    QAction* m_on = nullptr;
    QAction* m_isolines = nullptr;
    QAction* m_wipe = nullptr;
    QAction* m_exaggerate = nullptr;
    QAction* m_sideBySide = nullptr;
    std::vector<QAction*> m_quantities;
    std::vector<QAction*> m_ghosts;
};

}  // namespace hitscope
