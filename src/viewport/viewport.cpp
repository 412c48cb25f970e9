// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport.h"

#include "scene/scene_picker.h"
#include "session/task_list.h"
#include "viewport/brush_tool.h"
#include "viewport/inspect_tool.h"
#include "viewport/view_label.h"

namespace hitscope {

namespace {

/// Where a CPU draws, events wait for more than 40 ms until so many triangles are transformed: 160 ns each,
/// with their shadows.
constexpr std::size_t kTooMany = 250'000;

}  // namespace

Viewport::DrawnTriangles::DrawnTriangles(const SessionTargets& targets, bool isCpu) : isSoftware(isCpu) {
    for (const std::unique_ptr<Target>& target : targets) {
        if (target->visible) {
            const RenderMesh& mesh = target->deformed.render();
            const std::size_t triangles = mesh.triangles.size() / 3;
            all += triangles;
            coarse += mesh.coarseTriangles.empty() ? triangles : mesh.coarseTriangles.size() / 3;
        }
    }
}

Viewport::Viewport(Session& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_navigation(
          [this](const QPointF& position) {
              const auto met = m_aiming.met(m_navigation.rayAt(position));
              return met && met->target ? std::optional(met->point) : std::nullopt;
          },
          [this] { return sceneInSight(); }),
      m_pictures(m_scene, m_surface, session.frameCosts(),
                 {.view = [this] { return view(); }, .followsOn = [this] { return m_loop.followsOn(); }}),
      m_inspect(new InspectTool(*this, session)),
      m_brush(new BrushTool(*this, session)) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 180);
    PictureMotion& motion = m_pictures.motion();
    connect(&m_scene, &ViewportScene::made, this, &Viewport::sceneMade);
    connect(&m_scene, &ViewportScene::aboutToRelease, this, [this] {
        m_pictures.releaseGpu();
        m_picking.setPicker(nullptr);
    });
    connect(&m_pictures, &PictureFlow::failed, this, &Viewport::failed);
    connect(&m_pictures.refiner(), &PictureRefiner::failed, this, &Viewport::followQuality);
    connect(&m_trigger, &Trigger::fired, this, [this] {
        shootAlong(camera().rayThrough({0.0f, 0.0f}, m_navigation.aspect()));
        wantPicture();
    });
    connect(&m_trigger, &Trigger::crosshairGone, this, &Viewport::wantPicture);
    connect(&m_navigation, &Navigation::cameraChanged, this, &Viewport::wantPicture);
    connect(&m_navigation, &Navigation::cameraChanged, &motion, &PictureMotion::moved);
    connect(&session.tasks(), &TaskList::changed, &motion,
            [&session, &motion] { motion.setBusy(session.tasks().current() != nullptr); });
    connectSession();
    new ViewLabel(m_navigation, this);
    followScene();
}

void Viewport::connectSession() {
    const VertexSelection& selection = m_session.selection();
    connect(&selection, &VertexSelection::hoveredChanged, this, &Viewport::wantPicture);
    connect(&selection, &VertexSelection::pickedChanged, this, &Viewport::wantPicture);
    connect(&selection, &VertexSelection::selectionChanged, this, &Viewport::wantPicture);
    connect(&m_session, &Session::sceneReplaced, this, &Viewport::followScene);
    connect(&m_session.targets(), &SessionTargets::added, this, &Viewport::followSize);
    connect(&m_session.targets(), &SessionTargets::removed, this, &Viewport::followSize);
    connect(&m_session.targets(), &SessionTargets::changed, this, &Viewport::followSize);
    connect(&m_session.targets(), &SessionTargets::scaled, this, &Viewport::keepInSight);
}

Viewport::~Viewport() {
    m_scene.release();
}

PictureSurface::Hooks Viewport::surfaceHooks() {
    return {.made = [this] { contextMade(); },
            .resized = [this] { surfaceResized(); },
            .draw = [this](unsigned framebuffer) { m_pictures.draw(framebuffer); },
            .kept = [this](bool byWindow) { return m_pictures.kept(byWindow); },
            .paintOver = [this](QPaintDevice& picture) { paintOver(picture); },
            .shown =
                [this] {
                    m_pictures.windowPainted();
                    Q_EMIT windowPainted();
                    m_loop.windowPainted();
                }};
}

void Viewport::contextMade() {
    if (const Status made = m_scene.make(); !made) {
        m_pictures.report(made.error());
    }
}

void Viewport::sceneMade() {
    m_pictures.motion().setLongestFrame(m_scene.isSoftware() ? MotionDetail::kLongestSoftwareFrame
                                                             : MotionDetail::kLongestFrame);
    followSize();
    static_cast<void>(m_scene.with([this](SceneGpu& scene) -> Status {
        m_picking.setPicker(std::make_unique<ScenePicker>(m_session, scene));
        followQuality();
        return Done{};
    }));
}

void Viewport::resizeEvent(QResizeEvent*) {
    m_surface.widget().setGeometry(rect());
}

void Viewport::surfaceResized() {
    followViewSize();
    m_pictures.motion().forget();
    if (!m_framed) {
        m_framed = true;
        frameAll(Navigation::Arrival::AtOnce);
    }
}

void Viewport::setChangeValues(ChangeValues* values, Comparison* comparison) {
    m_changeValues = values;
    m_comparison = comparison;
    wantPicture();
}

/// Side by side each picture has half of the width.
void Viewport::followViewSize() {
    const bool isTwice = m_options.sideBySide;
    m_navigation.setViewSize({isTwice ? width() / 2.0 : width(), static_cast<double>(height())}, isTwice);
}

void Viewport::setOptions(const DisplayOptions& options) {
    m_options = options;
    m_pictures.motion().forget();
    followViewSize();
    followQuality();
    wantPicture();
    Q_EMIT optionsChanged();
}

void Viewport::setDrawsContinuously(bool on) {
    m_loop.setContinuous(on);
    followQuality();
    m_navigation.setGlides(!on);  // what is measured stands still
    wantPicture();
}

void Viewport::followQuality() {
    m_pictures.setQuality(m_options, m_loop.isContinuous());
}

void Viewport::followScene() {
    m_pictures.drop();
    followSize();
    frameAll(Navigation::Arrival::AtOnce);
    wantPicture();
}

void Viewport::followSize() {
    const DrawnTriangles drawn(m_session.targets(), m_scene.isSoftware());
    if (drawn != m_drawn) {  // what only moves takes as long
        m_drawn = drawn;
        const float part =
            drawn.all > 0 ? static_cast<float>(drawn.coarse) / static_cast<float>(drawn.all) : 1.0f;
        m_pictures.motion().setCoarsePart(part, drawn.isSoftware && drawn.all > kTooMany);
    }
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

/// The lens stays, as it does from one window to the next.
void Viewport::frameAsAtFirst() {
    Camera camera;
    camera.setProjection(m_navigation.goal().projectionKind());
    camera.setFieldOfView(m_navigation.goal().fieldOfView());
    m_navigation.setCamera(camera, Navigation::Arrival::AtOnce);
    frameAll(Navigation::Arrival::AtOnce);
}

void Viewport::frameSelection() {
    Bounds bounds;
    for (const TargetId id : m_session.targets().allSelected()) {
        bounds.add(m_session.targets().find(id)->worldBounds());
    }
    m_navigation.frame(bounds.empty() ? m_session.targets().bounds() : bounds);
}

void Viewport::bringSelectionIntoSight() {
    constexpr float kInside = 0.9f;  // of the picture: more than a sliver at its edge
    const Target* target = m_session.targets().find(m_session.targets().selected());
    if (target != nullptr &&
        !isInPicture(coreOf(target->worldBounds()), m_navigation.goal(), m_navigation.aspect(), kInside)) {
        frameAll();
    }
}

/// Where its middle is out of the picture now, or the eye within it, all targets are framed.
void Viewport::keepInSight(TargetId scaled) {
    const Target* target = m_session.targets().find(scaled);
    if (target == nullptr || !target->visible) {
        return;
    }
    const Camera& camera = m_navigation.goal();
    const Bounds bounds = target->worldBounds();
    Bounds withEye = bounds;
    withEye.add(camera.eye());
    const bool isWithin = !camera.isOrthographic() && withEye.min == bounds.min && withEye.max == bounds.max;
    Bounds middle;
    middle.add(bounds.centre());
    if (isWithin || !isInPicture(middle, camera, m_navigation.aspect(), 1.0f)) {
        frameAll();
    }
}

Ray Viewport::rayThrough(const QPointF& place) const {
    return m_navigation.rayAt({place.x() * width(), place.y() * height()});
}

void Viewport::shootAlong(const Ray& sight) {
    m_session.simulation().fire(m_aiming.shotAt(sight));
    Q_EMIT shot(sight);
}

void Viewport::lookAt(const VertexRef& vertex) {
    if (const Target* target = m_session.targets().find(vertex.target)) {
        m_navigation.recentre(target->transform.toWorld(target->deformed.positions()[vertex.vertex]));
        wantPicture();
    }
}

}  // namespace hitscope
