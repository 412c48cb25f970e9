// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>
#include <optional>

#include "session/scene_gpu.h"
#include "viewport/navigation.h"

namespace hitscope {

/// The picture of a session, and the hand on it: events in, frames out. Makes no GL call itself (SceneGpu
/// does).
///
/// Draws only when something changed; while projectiles fly, keys are held or continuous drawing is on, each
/// frame moves the session on by the time the last one took and asks for the next.
///
/// Drags, the wheel and the keys W A S D E Q move the camera (Navigation). A short stationary left click
/// shoots; a second click on the same spot within kDoubleClickGrace recentres instead, and for that the shot
/// waits so long: navigating never dents a mesh. Space shoots at the crosshair, repeatedly while held, Escape
/// ends the selection.
class Viewport : public QOpenGLWidget {
    Q_OBJECT
public:
    /// `session` outlives the viewport.
    explicit Viewport(Session& session, QWidget* parent = nullptr);
    ~Viewport() override;

    [[nodiscard]] const DisplayOptions& options() const { return m_options; }
    void setOptions(const DisplayOptions& options);
    [[nodiscard]] bool drawsContinuously() const { return m_continuous; }
    /// A frame after the other even if nothing moves: for measuring.
    void setDrawsContinuously(bool on);

    [[nodiscard]] Navigation& navigation() { return m_navigation; }
    [[nodiscard]] const Camera& camera() const { return m_navigation.camera(); }
    void frameAll();
    void frameSelection();  ///< the selected target; all if none is
    void shootAtCrosshair();
    /// Through a place of the picture, in fractions of its size from the top left corner.
    [[nodiscard]] Ray rayThrough(const QPointF& place) const;
    /// `ray`, raised so that a projectile lands where the ray does.
    [[nodiscard]] Ray launched(const Ray& ray) const;
    /// A surface to draw over the picture (SceneGpu::View); null: none.
    void setGhost(std::shared_ptr<const std::vector<glm::vec3>> ghost);

    /// Brings the GPU and the read-back to the session's state now: before an export. Fails when there is no
    /// GL.
    [[nodiscard]] Status syncNow();
    /// "llvmpipe (LLVM 15.0.6, 256 bits)"; empty before the first frame.
    [[nodiscard]] QString rendererName() const { return m_rendererName; }
    [[nodiscard]] QString rendererVersion() const { return m_rendererVersion; }

    static constexpr int kDoubleClickGrace = 250;  ///< milliseconds from release to the second press
    static constexpr int kLongestClick = 500;      ///< milliseconds from press to release

Q_SIGNALS:
    /// Seconds: from the frame before while frames follow each other, else what drawing took.
    void framePainted(double seconds);
    void rendererKnown();
    void shot(const hitscope::Ray& ray);        ///< by click or key, along this line of sight
    void failed(const hitscope::Error& error);  ///< no picture can be drawn; emitted once for each reason

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void releaseGpu();
    void report(const Error& error);
    void paintError();
    void followScene();
    void followSize();
    [[nodiscard]] bool wantsFrames() const;
    void catchUp();
    void moveOn();        ///< after a frame: advances what moves by the time since the last
    void collectCosts();  ///< of the last frames, once no more follow
    [[nodiscard]] SceneGpu::View view() const;
    /// What the ray meets first: for aiming and recentring.
    [[nodiscard]] std::optional<PhysicsWorld::RayHit> aimedAt(const Ray& ray) const;
    void shootAlong(const Ray& ray);
    void click(const QPointF& position);
    void fireHeldShot();
    void recentre(const QPointF& position);

    Session& m_session;
    std::unique_ptr<SceneGpu> m_scene;
    QString m_rendererName;
    QString m_rendererVersion;
    std::string m_error;  ///< the reason there is no picture; empty: there is one

    DisplayOptions m_options;
    std::shared_ptr<const std::vector<glm::vec3>> m_ghost;
    Navigation m_navigation;
    bool m_framed = false;  ///< the scene has been framed at a real size

    bool m_continuous = false;
    QElapsedTimer m_clock;       ///< since moveOn() last ran; invalid while nothing moves
    QElapsedTimer m_sinceFrame;  ///< since the last frame ended
    QTimer m_costsTimer;
    bool m_frameFollows = false;  ///< the frame to come was asked for right after the last

    quint64 m_pressTime = 0;  ///< milliseconds, of the event
    bool m_clickCounts = false;
    std::optional<Ray> m_heldShot;
    QTimer m_holdTimer;
    QTimer m_repeatTimer;
    QTimer m_crosshairTimer;  ///< runs while the crosshair shows because Space was used
};

}  // namespace hitscope
