// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QObject>
#include <QPointF>
#include <optional>
#include <vector>

#include "session/frame_costs.h"

class QCPGraph;
class QCPItemStraightLine;
class QCPItemText;
class QCustomPlot;

namespace hitscope {

/// Frame times as a scrolling graph in a plot. The wheel (or + and -) zooms the time, dragging (or the arrow
/// keys) pauses and goes back in it, a double click (or Home) comes back to the present; pointing reads one
/// frame. Only the frames in sight are looked at.
class FrameGraph : public QObject {
    Q_OBJECT
public:
    /// Both outlive the graph.
    FrameGraph(QCustomPlot& plot, const FrameCosts& costs, QObject* parent = nullptr);

    enum Curve { Frame, Cpu, Gpu, Physics, Deformation, ReadBack, CurveCount };
    void setCurveShown(Curve curve, bool shown);
    /// Frame: of the last frame's pipeline.
    [[nodiscard]] QColor colour(Curve curve) const;
    /// Frames a second instead of times; the parts of a frame are not shown then.
    void setPerSecond(bool perSecond);
    void setPaused(bool paused);
    [[nodiscard]] bool isPaused() const { return m_paused; }
    /// Frames up to now are no longer shown.
    void clear();

    void refresh();  ///< draws, if there is anything new
    /// Whether it scrolls on: a second after the last frame it stands still until the next one.
    [[nodiscard]] bool isMoving() const;
    [[nodiscard]] double seconds() const { return m_seconds; }  ///< in sight
    [[nodiscard]] const std::optional<FrameCost>& hovered() const { return m_hovered; }
    /// All that are shown or can be gone back to, oldest first.
    [[nodiscard]] std::vector<FrameCost> frames() const;
    /// A frame in words, a line a figure.
    [[nodiscard]] QString describe(const FrameCost& frame) const;

Q_SIGNALS:
    void pausedChanged(bool paused);
    void drawn();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static constexpr double kFirstSeconds = 10.0;

    void applyPalette();
    void makeCurves();
    void makeTargetLines();
    void fill();
    void fillFrame(const FrameCost& frame, double key, double& highest);
    void fitRange(double highest);
    void zoom(double factor, double atX);
    void pan(double seconds);
    void goLive();
    bool handleKey(int key);
    void hover(const QPointF& position);
    void endHover();
    void redraw();
    [[nodiscard]] double present() const;
    [[nodiscard]] std::size_t frameCount() const;
    [[nodiscard]] const FrameCost& frame(std::size_t index) const;
    [[nodiscard]] std::size_t firstFrameEndingAfter(double time) const;

    QCustomPlot& m_plot;
    const FrameCosts& m_costs;
    std::vector<QCPGraph*> m_frameCurves;  ///< by PipelineKind
    QCPGraph* m_curves[CurveCount] = {};   ///< Frame: none
    QCPGraph* m_hits = nullptr;
    std::vector<QCPItemStraightLine*> m_targetLines;
    std::vector<QCPItemText*> m_targetTexts;
    QCPItemStraightLine* m_pointer = nullptr;

    bool m_shown[CurveCount] = {true, true, true, true, true, true};
    bool m_perSecond = false;
    bool m_paused = false;
    double m_pausedAt = 0.0;           ///< seconds by FrameCosts::now()
    std::vector<FrameCost> m_frozen;   ///< while paused: what there was then
    double m_seconds = kFirstSeconds;  ///< in sight
    double m_back = 0.0;               ///< seconds from the right edge to the present; paused only
    std::uint64_t m_firstShown = 0;    ///< number of the first frame after clear()
    bool m_isDue = true;               ///< something but time has changed what is seen
    std::optional<double> m_dragX;     ///< pixels
    std::optional<QPointF> m_mouse;    ///< over the plot
    std::optional<FrameCost> m_hovered;
};

}  // namespace hitscope
