// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "analysis/change_values.h"
#include "analysis/comparison.h"
#include "view/display_options.h"

namespace Ui {
class Change;
}

namespace hitscope {

/// The dock "Change": what surfaces are coloured by, the range of the colours with a histogram, and how the
/// original is shown beside what became of it.
class ChangePanel : public QWidget {
    Q_OBJECT
public:
    /// All outlive the panel.
    ChangePanel(ChangeValues& values, Comparison& comparison, const Session& session,
                QWidget* parent = nullptr);
    ~ChangePanel() override;

    /// What is shown; emits nothing.
    void setOptions(const DisplayOptions& display);

Q_SIGNALS:
    void mapEdited(const hitscope::ChangeMapOptions& map);
    void beforeAfterEdited(const hitscope::BeforeAfterOptions& beforeAfter);
    void sideBySideEdited(bool on);
    void otherChosen(std::optional<hitscope::PipelineKind> other);
    void shownOrHidden();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void fillBoxes();
    void connectMap();
    void connectBeforeAfter();
    void connectComparison();
    void listPipelines();
    void showReport();
    void showBeforeAfter();
    void show(const ChangeMapOptions& map);
    void showSummary();
    void showRange();
    void showNumbers();
    void showHistogram();
    void editMap();
    void setFixedRange(double low, double high);

    ChangeValues& m_values;
    Comparison& m_comparison;
    const Session& m_session;
    std::unique_ptr<Ui::Change> m_ui;
    ChangeMapOptions m_map;
    BeforeAfterOptions m_beforeAfter;
    QTimer m_summaryTimer;  ///< to when another summary may be shown
    bool m_isSummaryNew = false;
    bool m_showing = false;  ///< the widgets are being set, nobody edits
};

}  // namespace hitscope
