// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "analysis/cost_curves.h"
#include "analysis/cost_measurement.h"
#include "models/costs_csv.h"

class QCPGraph;
class QCPItemStraightLine;
class QCustomPlot;

namespace Ui {
class CostView;
}

namespace hitscope {

/// What a frame and a hit cost, for each pipeline: against the number of hits, collected as one works or
/// measured by themselves in the background; or against the number of vertices, measured so.
class CostView : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the view.
    CostView(Session& session, const CostMeter& meter, QWidget* parent = nullptr);
    ~CostView() override;

    /// Where "Measure now" looks from.
    void setCamera(std::function<Camera()> camera) { m_camera = std::move(camera); }
    void setPlan(CostPlan plan) { m_plan = std::move(plan); }
    void setSizePlan(SizePlan plan) { m_sizePlan = std::move(plan); }
    /// Takes what frames have cost since the last time, and draws if anything has changed.
    void refresh();
    void clear();
    [[nodiscard]] std::vector<NamedCurve> curves() const;  ///< as shown
    [[nodiscard]] CostAxis axis() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void applyPalette();
    void follow(CostMeasurement& measurement);
    void followAxis();
    void measureOrCancel();
    void measureScene();
    void measureSizes();
    void followMeasurement();
    void say(const QString& text);
    void followScene();
    void collect();
    void draw();
    void drawAxes(double most, double mostTime, double leastTime);
    void drawCrossover(QCPItemStraightLine& line, std::optional<double> at);
    [[nodiscard]] bool isMeasuring() const { return m_measurement.isRunning() || m_bySize.isRunning(); }
    [[nodiscard]] QString inWords() const;
    [[nodiscard]] QString sourceInWords() const;
    [[nodiscard]] std::optional<double> crossoverOf(CostOf what) const;
    [[nodiscard]] const CostCurves& shown() const;

    Session& m_session;
    std::unique_ptr<Ui::CostView> m_ui;
    std::function<Camera()> m_camera;
    CostPlan m_plan;
    SizePlan m_sizePlan;
    CostMeasurement m_measurement;  ///< against the number of hits
    CostMeasurement m_bySize;       ///< against the number of vertices
    CostCurves m_collected;
    bool m_showsMeasured = false;
    QString m_measuredOn;         ///< scene
    bool m_isOfThisScene = true;  ///< what was measured
    bool m_leftOut = false;       ///< some frames, since two pipelines had a part in them
    bool m_isDue = true;
    std::uint64_t m_nextToCollect = 0;  ///< frame number
    struct Curves {
        PipelineKind pipeline = PipelineKind::TransformFeedback;
        QCPGraph* frame = nullptr;
        QCPGraph* hit = nullptr;
    };
    std::vector<Curves> m_curves;  ///< one a pipeline
    QCPItemStraightLine* m_crossover = nullptr;
};

}  // namespace hitscope
