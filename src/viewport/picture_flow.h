// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <cstdint>
#include <functional>
#include <string>

#include "scene/scene_gpu.h"
#include "viewport/picture_motion.h"
#include "viewport/picture_refiner.h"
#include "viewport/surface/picture_ahead.h"

namespace hitscope {

class FrameCosts;
class PictureSurface;
class ViewportScene;

/// A viewport's pictures, from what is wanted to what its window shows: in motion with less detail, at rest
/// refined; where the CPU draws, ahead and kept in memory.
class PictureFlow : public QObject {
    Q_OBJECT
public:
    struct Hooks {
        std::function<SceneGpu::View()> view;  ///< what there is to be seen now
        std::function<bool()> followsOn;       ///< another frame comes right after this one
    };
    /// All of them outlive it; nothing is asked of them yet.
    PictureFlow(ViewportScene& scene, PictureSurface& surface, FrameCosts& costs, Hooks hooks);
    ~PictureFlow() override;

    /// A picture of what there is to be seen now comes.
    void want() { m_ahead.want(); }
    /// Whether the next one is a frame right after the last.
    void setFollows(bool on) { m_frameFollows = on; }
    void pause() { m_sinceFrame.invalidate(); }  ///< the next one is not, whatever draws it
    /// What is under way shows nothing that is still wanted.
    void drop() { m_ahead.drop(); }
    /// isMeasured: each is drawn anew, in full.
    void setQuality(const DisplayOptions& options, bool isMeasured);

    // What the surface asks for.

    void draw(unsigned framebuffer);           ///< as PictureSurface::Hooks::draw
    [[nodiscard]] QImage kept(bool byWindow);  ///< as PictureSurface::Hooks::kept
    void windowPainted();                      ///< as PictureSurface::Hooks::shown

    /// The context goes; it is current.
    void releaseGpu();
    [[nodiscard]] PictureRefiner& refiner() { return m_refiner; }
    [[nodiscard]] PictureMotion& motion() { return m_motion; }
    /// What was drawn last, at most so many pixels wide, in its own shape; null where nothing was.
    [[nodiscard]] QImage thumbnail(int width);
    /// The reason there is no picture; empty: there is one.
    [[nodiscard]] const std::string& error() const { return m_error; }
    void report(const Error& error);

Q_SIGNALS:
    /// A picture was drawn, of what there is now, and shown() follows; not where another one comes first.
    void drawn();
    void shown();  ///< by the window
    /// A frame is shown, which was not a refined picture. Seconds: from the frame before while frames follow
    /// each other, else what it took to draw.
    void framePainted(double seconds);
    void failed(const hitscope::Error& error);  ///< no picture can be drawn; emitted once for each reason

private:
    [[nodiscard]] PictureAhead::Hooks aheadHooks();
    [[nodiscard]] PictureRefiner::Hooks refinerHooks();
    [[nodiscard]] bool prepareAhead();
    [[nodiscard]] bool beginAhead();
    [[nodiscard]] bool showAhead();
    [[nodiscard]] SceneGpu::View begin();
    void begun();
    void complete();
    [[nodiscard]] Status drawKept(SceneGpu& scene);
    void readKept(SceneGpu& scene);

    ViewportScene& m_scene;
    PictureSurface& m_surface;
    FrameCosts& m_costs;
    Hooks m_hooks;
    PictureRefiner m_refiner{refinerHooks()};
    PictureMotion m_motion;
    PictureAhead m_ahead{aheadHooks()};
    std::string m_error;

    QImage m_kept;                ///< what was drawn last, where pictures are kept in memory
    QSize m_keptFor;              ///< pixels of the viewport when that was drawn
    QElapsedTimer m_sinceFrame;   ///< since the last frame was shown; invalid: it was before a pause
    QElapsedTimer m_sinceBegin;   ///< since the last picture was begun
    double m_prepared = 0.0;      ///< seconds that what came before it took, without the events between
    double m_preparing = 0.0;     ///< of the next picture, so far
    bool m_frameFollows = false;  ///< the picture to come was asked for right after the last
    bool m_follows = false;       ///< the one that was begun last was
    bool m_isDrawn = false;       ///< since a frame was shown
    enum class Painted : std::uint8_t { Nothing, Alone, Following };
    Painted m_painted = Painted::Nothing;  ///< a frame that is not shown yet, perhaps right after another
};

}  // namespace hitscope
