// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport.h"

#include <QOpenGLContext>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gl/context.h"
#include "session/frame_costs.h"
#include "viewport/surface_format.h"

namespace hitscope {

namespace {

constexpr int kCrosshairStays = 1500;   // milliseconds after the last shot with Space
constexpr int kCostsArrive = 200;       // milliseconds after the last frame of many
constexpr double kLongestStep = 0.25;   // seconds: a window that stood still does not make the scene jump
constexpr double kNanosecond = 1.0e-9;  // seconds

}  // namespace

Viewport::Viewport(Session& session, QWidget* parent) : QOpenGLWidget(parent), m_session(session) {
    setFormat(viewportFormat());
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 180);
    m_holdTimer.setSingleShot(true);
    m_holdTimer.setInterval(kDoubleClickGrace);
    m_crosshairTimer.setSingleShot(true);
    m_crosshairTimer.setInterval(kCrosshairStays);
    m_costsTimer.setSingleShot(true);
    m_costsTimer.setInterval(kCostsArrive);
    connect(&m_costsTimer, &QTimer::timeout, this, &Viewport::collectCosts);
    const auto followRateOfFire = [this] {
        m_repeatTimer.setInterval(qRound(1000.0f / m_session.projectileSettings().rateOfFire));
    };
    followRateOfFire();
    connect(&m_holdTimer, &QTimer::timeout, this, &Viewport::fireHeldShot);
    connect(&m_repeatTimer, &QTimer::timeout, this, &Viewport::shootAtCrosshair);
    connect(&m_crosshairTimer, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    connect(&m_navigation, &Navigation::cameraChanged, this, qOverload<>(&QWidget::update));
    connect(this, &QOpenGLWidget::frameSwapped, this, &Viewport::moveOn);
    connect(&session, &Session::projectileSettingsChanged, this, followRateOfFire);
    connect(&session, &Session::pictureChanged, this, qOverload<>(&QWidget::update));
    connect(&session, &Session::sceneReplaced, this, &Viewport::followScene);
    connect(&session, &Session::targetAdded, this, &Viewport::followSize);
    connect(&session, &Session::targetRemoved, this, &Viewport::followSize);
    connect(&session, &Session::targetChanged, this, &Viewport::followSize);
    followScene();
}

Viewport::~Viewport() {
    releaseGpu();
}

void Viewport::initializeGL() {
    // The context goes when the widget is moved to another window, and takes all GL objects with it.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseGpu,
            Qt::DirectConnection);
    const gl::RendererInfo info = gl::rendererInfo();
    m_rendererName = QString::fromStdString(info.renderer);
    m_rendererVersion = QString::fromStdString(info.version);
    Result<std::unique_ptr<SceneGpu>> scene = SceneGpu::create(m_session);
    if (scene) {
        m_scene = std::move(scene).value();
        m_error.clear();
        m_session.setCatchUp([this] { catchUp(); });
    } else {
        report(scene.error());
    }
    Q_EMIT rendererKnown();
}

void Viewport::releaseGpu() {
    if (context() != nullptr) {
        disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseGpu);
    }
    if (m_scene) {
        m_session.setCatchUp({});
        makeCurrent();
        m_scene.reset();
        doneCurrent();
    }
}

void Viewport::report(const Error& error) {
    if (error.message() == m_error) {
        return;
    }
    m_error = error.message();
    // Not from within a paint event: whoever listens may open a dialog.
    QMetaObject::invokeMethod(
        this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
}

void Viewport::resizeGL(int, int) {
    m_navigation.setViewSize(size());
    if (!m_framed) {
        m_framed = true;
        frameAll();
    }
}

SceneGpu::View Viewport::view() const {
    SceneGpu::View view;
    view.width = std::max(1, static_cast<int>(std::lround(width() * devicePixelRatioF())));
    view.height = std::max(1, static_cast<int>(std::lround(height() * devicePixelRatioF())));
    view.pixelRatio = static_cast<float>(devicePixelRatioF());
    view.camera = camera();
    view.options = m_options;
    view.ghost = m_ghost;
    view.options.crosshair = m_options.crosshair || m_crosshairTimer.isActive();
    return view;
}

void Viewport::paintGL() {
    if (!m_scene) {
        paintError();
        return;
    }
    QElapsedTimer drawing;
    drawing.start();
    if (Status drawn = m_scene->draw(view(), defaultFramebufferObject()); !drawn) {
        report(drawn.error());
        return;
    }
    m_error.clear();
    const QElapsedTimer& measure = m_frameFollows && m_sinceFrame.isValid() ? m_sinceFrame : drawing;
    const double seconds = static_cast<double>(measure.nsecsElapsed()) * kNanosecond;
    m_frameFollows = false;
    m_sinceFrame.start();
    m_session.frameCosts().endFrame(seconds);
    Q_EMIT framePainted(seconds);
}

void Viewport::paintError() {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     m_error.empty() ? tr("Nothing can be drawn.") : QString::fromStdString(m_error));
}

bool Viewport::wantsFrames() const {
    return isVisible() && (m_continuous || m_navigation.isMoving() || m_session.isMoving() ||
                           (m_scene && m_scene->isReadBackPending()));
}

void Viewport::moveOn() {
    if (!wantsFrames()) {
        m_costsTimer.start();
        m_clock.invalidate();
        return;
    }
    const double passed =
        m_clock.isValid() ? std::min(static_cast<double>(m_clock.nsecsElapsed()) * kNanosecond, kLongestStep)
                          : 0.0;
    m_clock.start();
    if (m_session.isMoving()) {
        m_session.advance(passed);
    }
    m_navigation.advance(passed);
    m_frameFollows = true;
    update();
}

void Viewport::collectCosts() {
    if (m_scene) {
        makeCurrent();
        m_scene->collectCosts();
        doneCurrent();
    }
}

void Viewport::setOptions(const DisplayOptions& options) {
    m_options = options;
    update();
}

void Viewport::setDrawsContinuously(bool on) {
    m_continuous = on;
    update();
}

void Viewport::followScene() {
    m_heldShot.reset();
    followSize();
    frameAll();
}

void Viewport::followSize() {
    m_navigation.setSceneRadius(std::max(m_session.sceneBounds().diagonal(), 1.0e-3f));
}

void Viewport::frameAll() {
    m_navigation.frame(m_session.sceneBounds());
}

void Viewport::frameSelection() {
    const Target* target = m_session.target(m_session.selectedTarget());
    m_navigation.frame(target != nullptr ? target->worldBounds() : m_session.sceneBounds());
}

Ray Viewport::rayThrough(const QPointF& place) const {
    return m_navigation.rayAt({place.x() * width(), place.y() * height()});
}

void Viewport::setGhost(std::shared_ptr<const std::vector<glm::vec3>> ghost) {
    if (ghost != m_ghost) {
        m_ghost = std::move(ghost);
        update();
    }
}

void Viewport::shootAtCrosshair() {
    m_crosshairTimer.start();
    shootAlong(camera().rayThrough({0.0f, 0.0f}, m_navigation.aspect()));
    update();
}

/// Trouble comes up again with the next frame, and is reported then.
void Viewport::catchUp() {
    makeCurrent();
    static_cast<void>(m_scene->sync());
    doneCurrent();
}

Status Viewport::syncNow() {
    if (!m_scene) {
        return Error{"There is no picture, so there is nothing to take the deformed mesh from.", "",
                     "Start Hitscope where OpenGL 3.3 is available."};
    }
    makeCurrent();
    Status status = m_scene->sync();
    doneCurrent();
    update();  // normals may have come with it
    return status;
}

}  // namespace hitscope
