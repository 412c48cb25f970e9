// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "scene/change_overlay.h"
#include "scene/picture.h"
#include "viewport/aiming.h"
#include "viewport/frame_loop.h"
#include "viewport/navigation.h"
#include "viewport/picture_flow.h"
#include "viewport/scene_decorations.h"
#include "viewport/surface/picture_surface.h"
#include "viewport/trigger.h"
#include "viewport/viewport_picking.h"
#include "viewport/viewport_scene.h"

namespace hitscope {

class BrushTool;
class InspectTool;

/// The picture of a session, and the hand on it: connects the parts that draw it, and gives them the events.
/// Makes no GL call itself (SceneGpu does).
///
/// Drags, the wheel and the keys W A S D E Q move the camera (Navigation). A short stationary left click
/// shoots, or selects with the Move tool, a middle click makes the camera look at that spot from now on.
/// Space shoots at the crosshair, repeatedly while held, Escape ends the selection. What the cutting plane
/// hides is not in the way of clicks and shots from its side.
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
    /// As FrameLoop::setContinuous().
    void setDrawsContinuously(bool on);

    [[nodiscard]] Navigation& navigation() { return m_navigation; }
    [[nodiscard]] const Camera& camera() const { return m_navigation.camera(); }
    void frameAll(Navigation::Arrival arrival = Navigation::Arrival::Glide);
    void frameAsAtFirst();  ///< all targets, from where a window that opens looks at them
    void frameSelection();  ///< the selected target; all if none is
    /// Frames all where the selected target is out of the picture.
    void bringSelectionIntoSight();
    void lookAt(const hitscope::VertexRef& vertex);  ///< from now on
    void shootAtCrosshair() { m_trigger.pull(); }
    // At a place of the picture, in logical pixels: as a click there does.
    void shootAt(const QPointF& position) { shootAlong(m_navigation.rayAt(position)); }
    void centreAt(const QPointF& position) { recentre(position); }
    /// Through a place of the picture, in fractions of its size from the top left corner.
    [[nodiscard]] Ray rayThrough(const QPointF& place) const;

    // Its parts.

    [[nodiscard]] const Session& session() const { return m_session; }
    /// What shows the pictures, and has their OpenGL context.
    [[nodiscard]] PictureSurface& surface() { return m_surface; }
    [[nodiscard]] ViewportScene& scene() { return m_scene; }
    [[nodiscard]] PictureFlow& pictures() { return m_pictures; }
    [[nodiscard]] const Aiming& aiming() const { return m_aiming; }
    [[nodiscard]] ViewportPicking& picking() { return m_picking; }
    [[nodiscard]] SceneDecorations& decorations() { return m_decorations; }
    /// Shoot, Inspect, Brush or Move, and what Inspect does.
    [[nodiscard]] InspectTool& inspectTool() { return *m_inspect; }
    [[nodiscard]] BrushTool& brushTool() { return *m_brush; }

    /// What is seen around the session has changed: a picture of what there is now comes.
    void wantPicture() { m_pictures.want(); }
    /// As FrameLoop::followPicture().
    void followPicture() { m_loop.followPicture(); }
    /// Brings the GPU and the read-back to the session's state now: before an export. Fails when there is no
    /// GL.
    [[nodiscard]] Status syncNow();
    /// What there is to be seen now, at the viewport's own pixels.
    [[nodiscard]] SceneGpu::View view() const;
    [[nodiscard]] PictureRequest pictureRequest() const;  ///< of the same
    /// Errors are hitscope::drawPicture()'s, or that there is no GL.
    [[nodiscard]] Result<Image> drawPicture(const PictureRequest& request);
    /// Of what is shown now, with the samples that it has been refined by so far.
    [[nodiscard]] Result<Image> drawShown();

    static constexpr int kLongestClick = 500;  ///< milliseconds from press to release

Q_SIGNALS:
    void windowPainted();                 ///< the window has painted itself, perhaps with no other picture
    void shot(const hitscope::Ray& ray);  ///< by click or key, along this line of sight
    void optionsChanged();                ///< options()
    /// No picture can be drawn, or nothing picked in it; emitted once for each reason.
    void failed(const hitscope::Error& error);

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
    /// How many triangles frames draw.
    struct DrawnTriangles {
        std::size_t all = 0;
        std::size_t coarse = 0;  ///< in coarse pictures
        bool isSoftware = false;

        DrawnTriangles() = default;
        DrawnTriangles(const SessionTargets& targets, bool isCpu);
        bool operator==(const DrawnTriangles&) const = default;
    };
    [[nodiscard]] PictureSurface::Hooks surfaceHooks();
    void connectSession();
    void contextMade();
    void sceneMade();
    void surfaceResized();
    void paintOver(QPaintDevice& picture);
    void paintError(QPaintDevice& picture);
    [[nodiscard]] Result<Image> takePicture(const std::function<Result<Image>(SceneGpu&)>& draw);
    void followViewSize();
    void followScene();
    void followSize();
    void keepInSight(TargetId scaled);
    void followQuality();
    [[nodiscard]] SceneInSight sceneInSight() const;
    void shootAlong(const Ray& sight);
    void click(const QMouseEvent& event);
    void selectAt(const QPointF& position);
    void toggleAt(const QPointF& position);
    void recentre(const QPointF& position);

    Session& m_session;
    DisplayOptions m_options;
    PictureSurface& m_surface{makePictureSurface(*this, surfaceHooks())};
    ViewportScene m_scene{m_session, m_surface};
    Navigation m_navigation;
    PictureFlow m_pictures;
    FrameLoop m_loop{{m_session, m_scene, m_surface, m_pictures, m_navigation}, *this};
    Aiming m_aiming{m_session, m_navigation, m_options.cut};
    Trigger m_trigger{m_session.settings()};
    ViewportPicking m_picking{*this};
    SceneDecorations m_decorations{[this] { wantPicture(); }};
    ChangeValues* m_changeValues = nullptr;
    Comparison* m_comparison = nullptr;
    ChangeOverlay m_changeOverlay;
    InspectTool* m_inspect;
    BrushTool* m_brush;
    DrawnTriangles m_drawn;
    bool m_framed = false;  ///< the scene has been framed at a real size

    quint64 m_pressTime = 0;     ///< milliseconds, of the event
    QPointF m_pressedAt;         ///< logical pixels
    bool m_clickCounts = false;  ///< the press may become a click: nothing has moved
};

}  // namespace hitscope
