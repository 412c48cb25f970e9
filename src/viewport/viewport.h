// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QPolygonF>
#include <QTimer>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "scene/change_overlay.h"
#include "scene/picture.h"
#include "scene/scene_gpu.h"
#include "viewport/aiming.h"
#include "viewport/catch_up.h"
#include "viewport/navigation.h"
#include "viewport/picture_motion.h"
#include "viewport/picture_refiner.h"
#include "viewport/scene_decorations.h"
#include "viewport/surface/picture_ahead.h"
#include "viewport/surface/picture_surface.h"
#include "viewport/viewport_picking.h"

namespace hitscope {

class BrushTool;
class InspectTool;

/// The picture of a session, and the hand on it: events in, frames out. Makes no GL call itself (SceneGpu
/// does).
///
/// Draws only when something changed; while projectiles fly, keys are held or continuous drawing is on, each
/// frame moves the session on by the time the last one took and asks for the next.
///
/// Drags, the wheel and the keys W A S D E Q move the camera (Navigation). A short stationary left click
/// shoots, a middle click makes the camera look at that spot from now on. Space shoots at the crosshair,
/// repeatedly while held, Escape ends the selection. What the cutting plane hides is not in the way of clicks
/// and shots from its side.
class Viewport : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the viewport.
    explicit Viewport(Session& session, QWidget* parent = nullptr);
    ~Viewport() override;

    [[nodiscard]] const DisplayOptions& options() const { return m_options; }
    void setOptions(const DisplayOptions& options);
    /// What colour maps of change take their range from, and the second pipeline; null: none. They outlive
    /// the viewport or another call.
    void setChangeValues(ChangeValues* values, Comparison* comparison);
    /// A frame after the other even if nothing moves, as many as there can be: for measuring.
    void setDrawsContinuously(bool on);

    [[nodiscard]] Navigation& navigation() { return m_navigation; }
    [[nodiscard]] const Camera& camera() const { return m_navigation.camera(); }
    void frameAll(Navigation::Arrival arrival = Navigation::Arrival::Glide);
    void frameSelection();  ///< the selected target; all if none is
    void shootAtCrosshair();
    // At a place of the picture, in logical pixels: as a click there does.
    void shootAt(const QPointF& position) { shootAlong(m_navigation.rayAt(position)); }
    void centreAt(const QPointF& position) { recentre(position); }
    /// Through a place of the picture, in fractions of its size from the top left corner.
    [[nodiscard]] Ray rayThrough(const QPointF& place) const;
    [[nodiscard]] const Aiming& aiming() const { return m_aiming; }
    [[nodiscard]] ViewportPicking& picking() { return m_picking; }
    /// What shows the pictures, and has their OpenGL context.
    [[nodiscard]] PictureSurface& surface() { return m_surface; }
    [[nodiscard]] PictureRefiner& refiner() { return m_refiner; }
    [[nodiscard]] PictureMotion& motion() { return m_motion; }
    [[nodiscard]] SceneDecorations& decorations() { return m_decorations; }

    /// Shoot, Inspect or Brush, and what Inspect does.
    [[nodiscard]] InspectTool& inspectTool() { return *m_inspect; }
    [[nodiscard]] BrushTool& brushTool() { return *m_brush; }
    void lookAt(const hitscope::VertexRef& vertex);  ///< from now on

    /// What is seen around the session has changed: a picture of what there is now comes.
    void wantPicture() { m_ahead.want(); }
    /// What is seen has changed: a picture comes, with the next ones where many hits are being applied.
    void followPicture();
    /// Brings the GPU and the read-back to the session's state now: before an export. Fails when there is no
    /// GL.
    [[nodiscard]] Status syncNow();
    [[nodiscard]] const Session& session() const { return m_session; }
    /// What is shown now, at the viewport's own pixels.
    [[nodiscard]] PictureRequest pictureRequest() const;
    /// Errors are hitscope::drawPicture()'s, or that there is no GL.
    [[nodiscard]] Result<Image> drawPicture(const PictureRequest& request);
    /// The same of what is shown, with the samples that it has been refined by so far.
    [[nodiscard]] Result<Image> drawShown();
    /// What was drawn last, at most so many pixels wide, in its own shape; null where nothing was.
    [[nodiscard]] QImage thumbnail(int width);
    /// Does something with the scene on the GPU while its context is current; fails when there is none.
    [[nodiscard]] Status withScene(const std::function<Status(SceneGpu&)>& work);
    /// Has some of the large meshes of a scene brought to the GPU before the session gets it: called in turns
    /// of the event loop until it returns true.
    bool bringMeshes(const ScenePlan& scene);
    void dropUnusedMeshes();  ///< gives up those that the session has not got
    /// "llvmpipe (LLVM 15.0.6, 256 bits)"; empty before the first frame.
    [[nodiscard]] QString rendererName() const { return m_rendererName; }
    [[nodiscard]] QString rendererVersion() const { return m_rendererVersion; }
    /// hitscope::graphicsReport() as text, with what the session knows; fails when there is no GL.
    [[nodiscard]] Result<QString> graphicsReport();

    static constexpr int kLongestClick = 500;  ///< milliseconds from press to release

Q_SIGNALS:
    /// A picture was drawn, of what there is now, and pictureShown() follows; not where another one comes
    /// first.
    void pictureDrawn();
    void pictureShown();   ///< by the window
    void windowPainted();  ///< the window has painted itself, perhaps with no other picture
    /// A frame is shown, which was not a refined picture. Seconds: from the frame before while frames follow
    /// each other, else what it took to draw.
    void framePainted(double seconds);
    void rendererKnown();
    void shot(const hitscope::Ray& ray);  ///< by click or key, along this line of sight
    /// The context goes, and with it all GL objects; it is current. The scene is built anew from the session
    /// when there is another.
    void aboutToReleaseGpu();
    void optionsChanged();                      ///< options()
    void failed(const hitscope::Error& error);  ///< no picture can be drawn; emitted once for each reason

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    [[nodiscard]] Result<Image> takePicture(const std::function<Result<Image>(SceneGpu&)>& draw);
    friend class ViewportPicking;

    [[nodiscard]] PictureSurface::Hooks surfaceHooks();
    void surfaceMade();
    void surfaceResized();
    void draw(unsigned framebuffer);
    [[nodiscard]] QImage kept(bool byWindow);
    [[nodiscard]] Status drawKept(SceneGpu& scene);
    void readKept(SceneGpu& scene);
    void pictureComplete();
    void releaseGpu();
    void report(const Error& error);
    [[nodiscard]] PictureAhead::Hooks aheadHooks();
    [[nodiscard]] bool prepareAhead();
    [[nodiscard]] bool drawAhead();
    [[nodiscard]] bool showAhead();
    [[nodiscard]] SceneGpu::View beginPicture();
    void pictureBegun();
    void paintError(QPaintDevice& picture);
    void paintOver(QPaintDevice& picture);
    void endFrame();
    void followViewSize();
    void followScene();
    void followSize();
    [[nodiscard]] SceneInSight sceneInSight() const;
    [[nodiscard]] bool wantsFrames() const;
    void followRefresh();
    void moveOn();      ///< after a frame or a slice: advances what moves by the time since the last
    void startClock();  ///< what begins to move now has moved by the time the next frame is there
    [[nodiscard]] bool isCatchingUp() const;
    void slice();
    void collectCosts();  ///< of the last frames, once no more follow
    void tryNext();
    [[nodiscard]] SceneGpu::View view() const;
    [[nodiscard]] PictureRefiner::Hooks refinerHooks();
    void followQuality();
    void shootAlong(const Ray& sight);
    void click(const QMouseEvent& event);
    void selectAt(const QPointF& position);
    void recentre(const QPointF& position);

    Session& m_session;
    PictureSurface& m_surface{makePictureSurface(*this, surfaceHooks())};
    std::unique_ptr<SceneGpu> m_scene;
    InspectTool* m_inspect;
    BrushTool* m_brush = nullptr;
    QString m_rendererName;
    QString m_rendererVersion;
    bool m_isSoftware = false;  ///< the CPU draws
    std::string m_error;        ///< the reason there is no picture; empty: there is one

    DisplayOptions m_options;
    SceneDecorations m_decorations{[this] { wantPicture(); }};
    ChangeValues* m_changeValues = nullptr;
    Comparison* m_comparison = nullptr;
    ChangeOverlay m_changeOverlay;
    Navigation m_navigation;
    Aiming m_aiming;
    ViewportPicking m_picking{*this};
    PictureRefiner m_refiner{refinerHooks()};
    PictureMotion m_motion;
    PictureAhead m_ahead{aheadHooks()};
    bool m_framed = false;  ///< the scene has been framed at a real size

    bool m_continuous = false;
    bool m_unlimited = false;    ///< frames do not wait for the screen
    QElapsedTimer m_clock;       ///< since moveOn() last ran; invalid while nothing moves
    QElapsedTimer m_sinceFrame;  ///< since the last frame was shown
    QElapsedTimer m_sinceBegin;  ///< since the last picture was begun
    double m_prepared = 0.0;     ///< seconds that what came before it took, without the events between
    double m_preparing = 0.0;    ///< of the next picture, so far
    bool m_isDrawn = false;      ///< since a frame was shown
    QSize m_keptFor;             ///< pixels of the viewport when that was drawn
    QImage m_kept;               ///< what was drawn last, where pictures are kept in memory
    bool m_follows = false;      ///< that picture follows the one before
    enum class Painted : std::uint8_t { Nothing, Alone, Following };
    Painted m_painted = Painted::Nothing;  ///< a frame that is not shown yet, perhaps right after another
    QTimer m_costsTimer;
    QTimer m_trialTimer;  ///< to tryNext(), while something has not been tried
    CatchUp m_catchUp;
    bool m_frameFollows = false;  ///< the frame to come was asked for right after the last

    quint64 m_pressTime = 0;     ///< milliseconds, of the event
    QPointF m_pressedAt;         ///< logical pixels
    bool m_clickCounts = false;  ///< the press may become a click: nothing has moved
    QTimer m_repeatTimer;
    QTimer m_crosshairTimer;  ///< runs while the crosshair shows because Space was used
};

}  // namespace hitscope
