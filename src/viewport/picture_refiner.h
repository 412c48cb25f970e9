// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>

#include "core/result.h"
#include "scene/refined_view.h"

namespace hitscope {

/// Draws a picture in full where the one that is shown is coarse, and refines it, while nothing else happens:
/// a sample at a time, or a part of one, between events, until there are as many as are wanted. Then nothing
/// runs.
class PictureRefiner : public QObject {
    Q_OBJECT
public:
    struct Hooks {
        std::function<bool()> mayRefine;             ///< nothing moves, and there is something to draw into
        std::function<bool(RefinedView&)> isBehind;  ///< with what was added before
        std::function<Status(RefinedView&)> addSample;  ///< with the context current
        std::function<bool()> isCoarse;                 ///< what is shown is: any picture is better
        std::function<void()> show;                     ///< asks for a frame
    };
    explicit PictureRefiner(Hooks hooks, QObject* parent = nullptr);
    ~PictureRefiner() override;

    /// Off: what there is is forgotten. The context is current, or there is nothing.
    void setOn(bool on);
    /// How many samples a picture gets; 0: it is not refined. Likewise.
    void setWanted(int samples);
    /// To be given to SceneGpu::draw(); null: nothing is refined.
    [[nodiscard]] RefinedView* view() { return m_view.get(); }
    /// Whether the last frame was the refined picture: nothing new was drawn.
    [[nodiscard]] bool wasShown() const { return m_view && m_view->wasShown(); }
    [[nodiscard]] int samples() const { return m_view ? m_view->samples() : 0; }
    /// Samples are being added, or will be if nothing happens. What does not matter to the user's work had
    /// better not be painted meanwhile: where the window is composed, that takes as long as a sample.
    [[nodiscard]] bool isUnderWay() const { return m_timer.isActive(); }
    /// Why nothing is refined here; empty: nothing is in the way.
    [[nodiscard]] const QString& whyNot() const { return m_whyNot; }

    void framePainted();  ///< one was
    void inputCame();     ///< what is under way waits until no more comes
    void releaseGpu();    ///< the context goes; it is current

    static constexpr int kRest =
        20;  ///< milliseconds without frame or input before the first sample, at least

Q_SIGNALS:
    void refined(int samples);  ///< one sample more
    void aboutToShow();         ///< what there is so far comes to the window
    void failed();              ///< whyNot() says more

private:
    void step();
    [[nodiscard]] bool isDone() const;
    [[nodiscard]] int rest() const;

    Hooks m_hooks;
    std::unique_ptr<RefinedView> m_view;  ///< null: off
    bool m_on = false;
    int m_wanted = 0;
    QString m_whyNot;
    QTimer m_timer;
    QElapsedTimer m_sinceShown;
    QElapsedTimer m_sinceStep;
    qint64 m_sampleTime = 0;  ///< milliseconds
};

}  // namespace hitscope
