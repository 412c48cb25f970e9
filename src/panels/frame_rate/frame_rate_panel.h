// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/frame_times.h"
#include "core/result.h"
#include "panels/frame_rate/frame_graph.h"

class QAction;
class QComboBox;
class QLabel;
class QToolButton;

namespace Ui {
class FrameRate;
}

namespace hitscope {

class CostView;
struct CostMeter;
class Session;

/// The dock "Frame rate": read-outs and a graph of the frames drawn, and what frames and hits cost against
/// the number of hits, or of vertices.
class FrameRatePanel : public QWidget {
    Q_OBJECT
public:
    /// `continuous` is offered as a button; both outlive the panel.
    FrameRatePanel(Session& session, QAction& continuous, const CostMeter& meter, QWidget* parent = nullptr);
    ~FrameRatePanel() override;

    void clear();
    /// While `isHeld`, the panel shows nothing new by itself: the window has better to do.
    void setHeld(std::function<bool()> isHeld) { m_isHeld = std::move(isHeld); }
    void refresh();  ///< shows what is new
    [[nodiscard]] FrameTimes::Summary summary();
    [[nodiscard]] FrameGraph& graph() { return *m_graph; }
    [[nodiscard]] CostView& costs() { return *m_costView; }
    /// What the tab in front shows, as CSV, whole or not at all.
    [[nodiscard]] Status saveCsv(const QString& path) const;

    // Which curves are shown, and as what; for settings.
    [[nodiscard]] QByteArray saveState() const;
    void restoreState(const QByteArray& state);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeReadOuts();
    void makeLegend();
    QComboBox* makeQuantity();
    void makeButtons(QAction& continuous);
    void chooseCsv();
    void showReadOuts();
    void takeFramesAlone();
    void colourLegend();

    Session& m_session;
    std::unique_ptr<Ui::FrameRate> m_ui;
    FrameTimes m_frames;                 ///< since frames were of as many pipelines as now
    std::vector<std::uint64_t> m_alone;  ///< numbers of frames that are not in m_frames yet
    std::uint8_t m_pipelines = 1;
    FrameGraph* m_graph = nullptr;
    CostView* m_costView = nullptr;
    QTimer m_timer;
    std::function<bool()> m_isHeld = [] { return false; };
    bool m_isNew = false;  ///< a frame came since the last refresh
    struct ReadOuts {
        QLabel* framesPerSecond = nullptr;
        QLabel* mean = nullptr;
        QLabel* median = nullptr;
        QLabel* low = nullptr;
        QLabel* percentile99 = nullptr;
        QLabel* worst = nullptr;
    } m_readOuts;
    std::array<QToolButton*, FrameGraph::CurveCount> m_legend = {};
    QComboBox* m_quantity = nullptr;
    QToolButton* m_pause = nullptr;
    QColor m_frameColour;  ///< in the legend
};

}  // namespace hitscope
