// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <glm/vec3.hpp>

#include "render/camera.h"
#include "viewport/fly_keys.h"
#include "viewport/navigation_preset.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace hitscope {

/// The hand on the camera: mouse, wheel and keys become camera motion. Draws nothing and knows no scene; what
/// a click does is the viewport's business, which asks hasDragged() whether a press has become a drag.
class Navigation : public QObject {
    Q_OBJECT
public:
    explicit Navigation(QObject* parent = nullptr);

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    void setSceneRadius(float radius) { m_camera.setSceneRadius(radius); }
    void setViewSize(const QSizeF& size) { m_size = size; }  ///< logical pixels
    [[nodiscard]] float aspect() const;
    [[nodiscard]] Ray rayAt(const QPointF& position) const;  ///< logical pixels

    [[nodiscard]] NavigationPreset preset() const { return m_preset; }
    void setPreset(NavigationPreset preset) { m_preset = preset; }

    // Events. A left press waits until it has moved a little: it may be a click.
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    /// Since the last press: the mouse has moved too far for a click, or the button moves the camera at once.
    [[nodiscard]] bool hasDragged() const { return m_dragged; }
    void wheel(const QWheelEvent& event);
    /// False when the key is none of the camera's.
    bool keyPress(const QKeyEvent& event);
    bool keyRelease(const QKeyEvent& event);
    void releaseKeys() { m_flyKeys.clear(); }

    [[nodiscard]] bool isMoving() const { return m_flyKeys.any(); }
    void advance(double seconds);  ///< of what moves by itself

    void frame(const Bounds& bounds);  ///< nothing for empty ones
    void recentre(const glm::vec3& point);
    void flyStep(const glm::vec3& step);  ///< right, up, forward; 1 is a fair stride

Q_SIGNALS:
    void cameraChanged();

private:
    void drag(const QPointF& delta);

    Camera m_camera;
    QSizeF m_size{1.0, 1.0};
    NavigationPreset m_preset = NavigationPreset::Hitscope;
    CameraMotion m_motion = CameraMotion::None;
    bool m_dragged = false;
    QPointF m_pressedAt;
    QPointF m_draggedTo;
    FlyKeys m_flyKeys;
    bool m_flyFast = false;
};

}  // namespace hitscope
