// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "view/camera.h"
#include "viewport/camera_glide.h"
#include "viewport/fly_keys.h"
#include "viewport/navigation_preset.h"
#include "viewport/scene_in_sight.h"
#include "viewport/standard_view.h"

class QKeyEvent;
class QMouseEvent;
class QNativeGestureEvent;
class QWheelEvent;

namespace hitscope {

/// The hand on the camera: mouse, wheel, trackpad and keys become camera motion. Draws nothing and knows no
/// scene; what a click does is the viewport's business, which asks hasDragged() whether a press has become a
/// drag. What sets the camera somewhere else glides there, and any event of the hand stops it.
///
/// Mouse, wheel and trackpad never lose the scene: a motion after which none of it would be in the picture
/// ends where the last of it would go. Zooming never takes the eye below the floor from above it, nor past
/// what it zooms at. Looking around and flying are free.
class Navigation : public QObject {
    Q_OBJECT
public:
    /// The point (metres, world) of a target's surface under a place of the view (logical pixels); nothing if
    /// there is none.
    using SurfaceAt = std::function<std::optional<glm::vec3>(const QPointF&)>;

    /// The scene as it is now.
    using SceneNow = std::function<SceneInSight()>;

    explicit Navigation(SurfaceAt surfaceAt, SceneNow scene = {}, QObject* parent = nullptr);

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    /// Where the camera is or will be once it has arrived.
    [[nodiscard]] const Camera& goal() const { return m_glide.isRunning() ? m_glide.goal() : m_camera; }
    void setSceneRadius(float radius);
    /// Logical pixels, of one picture. hasSecond: the same view is beside it.
    void setViewSize(const QSizeF& size, bool hasSecond = false) {
        m_size = size;
        m_hasSecond = hasSecond;
    }
    [[nodiscard]] float aspect() const;
    /// Logical pixels; of the first picture, and of the second, where there is one.
    [[nodiscard]] Ray rayAt(const QPointF& position) const;
    /// As the first picture goes on beyond its edges.
    [[nodiscard]] Ray rayInFirst(const QPointF& position) const;
    /// Whether enough of some target to be seen is in the picture; true of an empty scene.
    [[nodiscard]] bool isSceneInSight() const;

    [[nodiscard]] NavigationPreset preset() const { return m_preset; }
    void setPreset(NavigationPreset preset);
    [[nodiscard]] OrbitMode orbitMode() const { return m_orbitMode; }
    void setOrbitMode(OrbitMode mode);
    void setGlides(bool on);  ///< off: the camera is there at once

    // Events. A left press waits until it has moved a little: it may be a click.
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    /// Since the last press: the mouse has moved too far for a click, or the button moves the camera at once.
    [[nodiscard]] bool hasDragged() const { return m_dragged; }
    void wheel(const QWheelEvent& event);
    bool gesture(const QNativeGestureEvent& event);  ///< false when it is none of the camera's
    /// False when the key is none of the camera's.
    bool keyPress(const QKeyEvent& event);
    bool keyRelease(const QKeyEvent& event);
    void releaseKeys() { m_flyKeys.clear(); }

    [[nodiscard]] bool isMoving() const { return m_flyKeys.any() || m_glide.isRunning(); }
    void advance(double seconds);  ///< of what moves by itself

    enum class Arrival : std::uint8_t { Glide, AtOnce };
    void setCamera(const Camera& camera, Arrival arrival = Arrival::Glide);
    void frame(const Bounds& bounds, Arrival arrival = Arrival::Glide);  ///< nothing for empty ones
    void show(StandardView view);
    /// Orbits as a drag by `delta` logical pixels from beside all surfaces does.
    void turnBy(const QPointF& delta);
    void setProjection(Projection projection);
    void recentre(const glm::vec3& point);
    void flyStep(const glm::vec3& step);  ///< right, up, forward; 1 is a fair stride

Q_SIGNALS:
    void cameraChanged();
    void fieldOfViewChanged();  ///< by hand: worth saying
    void settingsChanged();     ///< preset, orbit mode

private:
    void moveBy(CameraMotion motion, const QPointF& delta);
    void orbit(float yaw, float pitch);
    void zoom(float factor, const glm::vec3& about);
    /// Where a drag that begins there turns, and what the wheel zooms at.
    [[nodiscard]] glm::vec3 anchorAt(const QPointF& position) const;
    [[nodiscard]] glm::vec3 zoomAnchorAt(const QPointF& position) const;
    [[nodiscard]] SceneInSight scene() const { return m_scene ? m_scene() : SceneInSight{}; }
    /// Moves the camera as far as the scene stays in sight.
    void moveInSight(const std::function<void(float part)>& move);
    void fly(const glm::vec3& step);
    void turnWheel(float notches, const QPointF& at, bool fieldOfView);
    void takeHold();  ///< the hand moves the camera from where it is

    SurfaceAt m_surfaceAt;
    SceneNow m_scene;
    Camera m_camera;
    CameraGlide m_glide;
    bool m_glides = true;
    bool m_hasSecond = false;
    QSizeF m_size{1.0, 1.0};
    NavigationPreset m_preset = NavigationPreset::Hitscope;
    OrbitMode m_orbitMode = OrbitMode::Point;
    CameraMotion m_motion = CameraMotion::None;
    bool m_dragged = false;
    QPointF m_pressedAt;
    QPointF m_draggedTo;
    std::optional<glm::vec3> m_anchor;  ///< of the drag under way
    FlyKeys m_flyKeys;
    bool m_flyFast = false;
};

}  // namespace hitscope
