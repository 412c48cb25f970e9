// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport.h"

#include <algorithm>
#include <utility>

#include "session/frame_costs.h"
#include "session/task_list.h"
#include "viewport/brush_tool.h"
#include "viewport/inspect_tool.h"
#include "viewport/view_label.h"

namespace hitscope {

namespace {

constexpr int kCrosshairStays = 1500;   // milliseconds after the last shot with Space
constexpr int kCostsArrive = 200;       // milliseconds after the last frame of many
constexpr int kTrialPause = 250;        // milliseconds between two things that are tried, each some ten long
constexpr double kNanosecond = 1.0e-9;  // seconds

/// Where a CPU draws, events wait for more than 40 ms until so many triangles are transformed: 160 ns each,
/// with their shadows.
constexpr std::size_t kTooMany = 250'000;

/// Triangles that are drawn.
struct DrawnTriangles {
    std::size_t all = 0;
    std::size_t coarse = 0;  ///< in coarse pictures

    explicit DrawnTriangles(const SessionTargets& targets) {
        for (const std::unique_ptr<Target>& target : targets) {
            if (target->visible) {
                const RenderMesh& mesh = target->deformed.render();
                const std::size_t triangles = mesh.triangles.size() / 3;
                all += triangles;
                coarse += mesh.coarseTriangles.empty() ? triangles : mesh.coarseTriangles.size() / 3;
            }
        }
    }
    [[nodiscard]] float coarsePart() const {
        return all > 0 ? static_cast<float>(coarse) / static_cast<float>(all) : 1.0f;
    }
};

}  // namespace

Viewport::Viewport(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_inspect(new InspectTool(*this, session)),
      m_navigation(
          [this](const QPointF& position) {
              const auto met = m_aiming.met(m_navigation.rayAt(position));
              return met && met->target ? std::optional(met->point) : std::nullopt;
          },
          [this] { return sceneInSight(); }),
      m_aiming(session, m_navigation, m_options.cut) {
    m_brush = new BrushTool(*this, session);  // by the parts above
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 180);
    m_crosshairTimer.setSingleShot(true);
    m_crosshairTimer.setInterval(kCrosshairStays);
    m_costsTimer.setSingleShot(true);
    m_costsTimer.setInterval(kCostsArrive);
    connect(&m_costsTimer, &QTimer::timeout, this, &Viewport::collectCosts);
    m_trialTimer.setInterval(kTrialPause);
    connect(&m_trialTimer, &QTimer::timeout, this, &Viewport::tryNext);
    const auto followRateOfFire = [this] {
        m_repeatTimer.setInterval(qRound(1000.0f / m_session.settings().projectile().rateOfFire));
    };
    followRateOfFire();
    connect(&m_repeatTimer, &QTimer::timeout, this, &Viewport::shootAtCrosshair);
    connect(&m_crosshairTimer, &QTimer::timeout, this, &Viewport::wantPicture);
    connect(&m_navigation, &Navigation::cameraChanged, this, &Viewport::wantPicture);
    connect(&m_navigation, &Navigation::cameraChanged, &m_motion, &PictureMotion::moved);
    connect(&m_refiner, &PictureRefiner::failed, this, &Viewport::followQuality);
    connect(&m_motion, &PictureMotion::rested, this, &Viewport::wantPicture);
    connect(&session.tasks(), &TaskList::changed, this,
            [this] { m_motion.setBusy(m_session.tasks().current() != nullptr); });
    connect(&m_catchUp, &CatchUp::sliceDue, this, &Viewport::slice);
    connect(&session.settings(), &SessionSettings::projectileChanged, this, followRateOfFire);
    connect(&session, &Session::pictureChanged, this, &Viewport::followPicture);
    connect(&session, &Session::pictureChanged, this, &Viewport::startClock);
    const VertexSelection& selection = session.selection();
    connect(&selection, &VertexSelection::hoveredChanged, this, &Viewport::wantPicture);
    connect(&selection, &VertexSelection::pickedChanged, this, &Viewport::wantPicture);
    connect(&selection, &VertexSelection::selectionChanged, this, &Viewport::wantPicture);
    connect(&session, &Session::sceneReplaced, this, &Viewport::followScene);
    connect(&session.targets(), &SessionTargets::added, this, &Viewport::followSize);
    connect(&session.targets(), &SessionTargets::removed, this, &Viewport::followSize);
    connect(&session.targets(), &SessionTargets::changed, this, &Viewport::followSize);
    new ViewLabel(m_navigation, this);
    followScene();
}

Viewport::~Viewport() {
    releaseGpu();
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

SceneGpu::View Viewport::view() const {
    SceneGpu::View view;
    view.width = std::max(1, static_cast<int>(std::lround(width() * devicePixelRatioF())));
    view.height = std::max(1, static_cast<int>(std::lround(height() * devicePixelRatioF())));
    view.pixelRatio = static_cast<float>(devicePixelRatioF());
    view.camera = camera();
    view.options = m_options;
    view.ghost = m_decorations.ghost();
    view.section = m_decorations.section();
    view.otherSection = m_decorations.otherSection();
    view.showsCutPlane = m_decorations.showsCutPlane();
    view.changeValues = m_changeValues;
    view.comparison = m_comparison;
    view.projectilesFly = m_isSoftware && m_session.simulation().isMoving();
    view.options.crosshair = m_options.crosshair || m_crosshairTimer.isActive();
    return view;
}

SceneGpu::View Viewport::beginPicture() {
    m_sinceBegin.start();
    m_prepared = std::exchange(m_preparing, 0.0);
    m_follows = std::exchange(m_frameFollows, false) && m_sinceFrame.isValid();
    SceneGpu::View shown = view();
    m_motion.seenFrom(camera().distance());
    shown.detail = m_motion.beginFrame();
    // Where the CPU draws, keeping it costs a tenth of drawing it twice, and events wait meanwhile.
    shown.isAtRest = m_isSoftware && !wantsFrames() && !m_motion.isMoving();
    return shown;
}

void Viewport::pictureBegun() {
    m_motion.drawn(m_scene->wasCoarse(), static_cast<double>(m_sinceBegin.nsecsElapsed()) * kNanosecond);
    Q_EMIT pictureDrawn();
}

/// Only now is a frame there: a renderer may have put off all of the drawing until now. The window is also
/// composed, and this called, where another widget has painted itself.
void Viewport::endFrame() {
    if (!std::exchange(m_isDrawn, false)) {
        return;
    }
    const double drawing = m_prepared + static_cast<double>(m_sinceBegin.nsecsElapsed()) * kNanosecond;
    m_motion.frameShown(drawing);
    m_catchUp.pictureShown();
    m_ahead.shown();
    Q_EMIT pictureShown();
    const Painted painted = std::exchange(m_painted, Painted::Nothing);
    if (painted == Painted::Nothing) {
        return;
    }
    const bool follows = painted == Painted::Following && m_sinceFrame.isValid();
    const double seconds = follows ? static_cast<double>(m_sinceFrame.nsecsElapsed()) * kNanosecond : drawing;
    m_sinceFrame.start();
    m_session.frameCosts().endFrame(seconds, follows);
    Q_EMIT framePainted(seconds);
}

void Viewport::setChangeValues(ChangeValues* values, Comparison* comparison) {
    m_changeValues = values;
    m_comparison = comparison;
    wantPicture();
}

/// Side by side each picture has half of the width.
void Viewport::followViewSize() {
    m_navigation.setViewSize({m_options.sideBySide ? width() / 2.0 : width(), static_cast<double>(height())});
}

void Viewport::setOptions(const DisplayOptions& options) {
    m_options = options;
    m_motion.forget();
    followViewSize();
    followQuality();
    wantPicture();
    Q_EMIT optionsChanged();
}

void Viewport::setDrawsContinuously(bool on) {
    m_continuous = on;
    followQuality();
    m_navigation.setGlides(!on);  // what is measured stands still
    wantPicture();
}

void Viewport::followScene() {
    m_ahead.drop();
    followSize();
    frameAll(Navigation::Arrival::AtOnce);
    wantPicture();
}

void Viewport::followSize() {
    const DrawnTriangles drawn(m_session.targets());
    m_motion.setCoarsePart(drawn.coarsePart(), m_isSoftware && drawn.all > kTooMany);
    const float size = m_session.targets().bounds().diagonal();
    m_navigation.setSceneRadius(size > 0.0f ? size : 1.0f);
}

SceneInSight Viewport::sceneInSight() const {
    SceneInSight scene;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        if (!target->visible) {
            continue;
        }
        if (target->id == m_session.targets().selected()) {
            scene.selected = scene.targets.size();
        }
        scene.targets.push_back(target->worldBounds());
    }
    if (m_options.floor) {
        scene.floor = m_session.targets().floorHeight();
    }
    return scene;
}

void Viewport::frameAll(Navigation::Arrival arrival) {
    m_navigation.frame(m_session.targets().bounds(), arrival);
}

void Viewport::frameSelection() {
    const Target* target = m_session.targets().find(m_session.targets().selected());
    m_navigation.frame(target != nullptr ? target->worldBounds() : m_session.targets().bounds());
}

Ray Viewport::rayThrough(const QPointF& place) const {
    return m_navigation.rayAt({place.x() * width(), place.y() * height()});
}

void Viewport::shootAlong(const Ray& sight) {
    m_session.simulation().fire(m_aiming.shotAt(sight));
    Q_EMIT shot(sight);
}

void Viewport::shootAtCrosshair() {
    m_crosshairTimer.start();
    shootAlong(camera().rayThrough({0.0f, 0.0f}, m_navigation.aspect()));
    wantPicture();
}

void Viewport::lookAt(const VertexRef& vertex) {
    if (const Target* target = m_session.targets().find(vertex.target)) {
        m_navigation.recentre(target->transform.toWorld(target->deformed.positions()[vertex.vertex]));
        wantPicture();
    }
}

}  // namespace hitscope
