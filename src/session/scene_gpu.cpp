// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_gpu.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "deform/history_prefix.h"
#include "render/original_shape.h"
#include "render/pick_pass.h"
#include "render/renderer.h"
#include "session/change_upload.h"
#include "session/change_values.h"
#include "session/comparison.h"
#include "session/frame_meter.h"
#include "session/history_edits.h"
#include "session/picture_part.h"
#include "session/reapplication.h"
#include "session/scene_marks.h"
#include "session/second_scene.h"
#include "session/shading_normals.h"

namespace hitscope {

namespace {

glm::mat4 modelMatrix(const RigidTransform& transform) {
    glm::mat4 model = glm::mat4_cast(transform.rotation);
    model[3] = glm::vec4(transform.position, 1.0f);
    return model;
}

std::map<PipelineKind, QString> unavailablePipelines() {
    std::map<PipelineKind, QString> reasons;
    for (const PipelineTraits& traits : allPipelines()) {
        if (const std::optional<std::string> reason = whyUnavailable(traits.kind)) {
            reasons[traits.kind] = QString::fromStdString(*reason);
        }
    }
    return reasons;
}

}  // namespace

/// Lends the words to be translated their context.
struct SceneGpuText {
    Q_DECLARE_TR_FUNCTIONS(hitscope::SceneGpu)
};

struct SceneGpu::Private {
    explicit Private(Session& followed) : session(followed), meter(followed.frameCosts()), second(followed) {}

    struct GpuTarget {
        std::unique_ptr<TargetBuffers> buffers;
        std::shared_ptr<const MaterialSet> materials;
        ChangedParts changed;
    };

    Session& session;
    FrameMeter meter;
    std::unique_ptr<Renderer> renderer;
    std::unordered_map<TargetId, GpuTarget> targets;
    std::unique_ptr<DeformationPipeline> pipeline;  // below the buffers it is given, so that it goes first
    std::unordered_map<const MeshData*, std::weak_ptr<const MaterialSet>> materials;
    std::shared_ptr<const Image> coverImage;  // what `cover` was made of
    std::shared_ptr<const MaterialSet> cover;
    SceneMarks marks;
    std::uint64_t seenRevision = 0;  // of the history
    /// The edits until then that the pipeline has not got; nothing: they are not known.
    std::optional<std::vector<HistoryEdit>> unapplied = std::vector<HistoryEdit>();
    HistoryPrefix applied;  // of the history before those edits
    std::uint64_t meshRevision = 1;
    gl::Defines deformDefines;
    ChangeUpload changeUpload;
    SecondScene second;
    ChangeUpload secondUpload;
    std::unique_ptr<Reapplication> reapplication;  // null: nothing is applied again in slices

    enum class Delivery { WhatHasArrived, All };
    void followTargets();
    void followCover();
    [[nodiscard]] const MaterialSet* materialsToDraw(const Target& target) const;
    [[nodiscard]] std::vector<DrawItem> drawItems() const;
    [[nodiscard]] Result<std::unique_ptr<DeformationPipeline>> newPipeline() const;
    Status followPipeline(bool& startOver);
    void seeHistory();
    [[nodiscard]] bool hasToStartOver() const;
    Status followReapplication(Delivery delivery);
    void takeReapplied();
    /// Returns whether the pipeline started over.
    bool followHistory(bool startOver);
    void readBack(Delivery delivery);
    Status follow(Delivery delivery);
    std::shared_ptr<const MaterialSet> materialsOf(const DeformedMesh& mesh);
    void followComparison(Comparison* comparison);
    [[nodiscard]] bool isSideBySide(const View& view) const {
        return second.isReady() && view.options.sideBySide;
    }
    /// The picture, or two of them side by side.
    Status drawAll(Frame& frame, const View& view, unsigned framebuffer);
};

SceneGpu::SceneGpu(Session& session) : d(std::make_unique<Private>(session)) {}

SceneGpu::~SceneGpu() = default;

Result<std::unique_ptr<SceneGpu>> SceneGpu::create(Session& session) {
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create();
    if (!renderer) {
        return renderer.error();
    }
    const Result<Exactness> exactness = measureExactness();
    if (!exactness) {
        return exactness.error();
    }
    session.setExactness(exactness.value());
    session.setUnavailablePipelines(unavailablePipelines());
    std::unique_ptr<SceneGpu> scene(new SceneGpu(session));
    scene->d->deformDefines = exactness.value().defines();
    scene->d->renderer = std::move(renderer).value();
    return scene;
}

std::shared_ptr<const MaterialSet> SceneGpu::Private::materialsOf(const DeformedMesh& mesh) {
    std::weak_ptr<const MaterialSet>& known = materials[&mesh.original()];
    std::shared_ptr<const MaterialSet> set = known.lock();
    if (!set) {
        set = renderer->makeMaterials(mesh.original());
        known = set;
    }
    return set;
}

void SceneGpu::Private::followTargets() {
    for (auto it = targets.begin(); it != targets.end();) {
        if (session.target(it->first) == nullptr) {
            if (pipeline) {
                pipeline->removeTarget(it->first);
            }
            it = targets.erase(it);
        } else {
            ++it;
        }
    }
    std::erase_if(materials, [](const auto& entry) { return entry.second.expired(); });
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (targets.contains(target->id)) {
            continue;
        }
        GpuTarget& made =
            targets
                .try_emplace(target->id,
                             GpuTarget{nullptr, nullptr, ChangedParts(target->deformed.sharedRender())})
                .first->second;
        made.buffers = std::make_unique<TargetBuffers>(target->deformed.render());
        made.buffers->writeShadingNormals(0, target->trueNormals.normals());
        made.materials = materialsOf(target->deformed);
        if (pipeline) {
            pipeline->addTarget(target->id, *made.buffers);
        }
    }
}

void SceneGpu::Private::followCover() {
    if (coverImage != session.coverTexture()) {
        coverImage = session.coverTexture();
        cover = coverImage ? renderer->makeCover(*coverImage) : nullptr;
    }
}

const MaterialSet* SceneGpu::Private::materialsToDraw(const Target& target) const {
    const bool covered = cover && !target.deformed.original().cornerTexcoords.empty();
    return covered ? cover.get() : targets.at(target.id).materials.get();
}

/// The visible targets that are on the GPU.
std::vector<DrawItem> SceneGpu::Private::drawItems() const {
    std::vector<DrawItem> items;
    items.reserve(session.targets().size());
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const auto gpu = targets.find(target->id);
        if (target->visible && gpu != targets.end()) {
            items.push_back({target->id, gpu->second.buffers.get(), materialsToDraw(*target),
                             modelMatrix(target->transform),
                             target->id == session.selectedTarget() && session.targets().size() > 1,
                             &gpu->second.changed});
        }
    }
    return items;
}

Result<std::unique_ptr<DeformationPipeline>> SceneGpu::Private::newPipeline() const {
    return makePipeline(session.pipeline(), {.vertexUniformComponents = {}, .deformDefines = deformDefines});
}

/// The history keeps its large edits for a short while only: they are taken as they come.
void SceneGpu::Private::seeHistory() {
    const HitHistory& history = session.history();
    if (seenRevision == history.revision()) {
        return;
    }
    std::optional<std::vector<HistoryEdit>> more = history.editsSince(seenRevision);
    seenRevision = history.revision();
    if (!unapplied || !more) {
        unapplied.reset();
        return;
    }
    std::move(more->begin(), more->end(), std::back_inserter(*unapplied));
    unapplied = withoutUndone(*std::move(unapplied));
}

/// Whether bringing the pipeline up to date means to apply most of a long history.
bool SceneGpu::Private::hasToStartOver() const {
    if (!pipeline || !Reapplication::isWorthSlicing(session.pipeline(), session.shownHits().size())) {
        return false;
    }
    if (pipeline->traits().kind != session.pipeline() || !unapplied) {
        return true;
    }
    return std::any_of(unapplied->begin(), unapplied->end(), [](const HistoryEdit& edit) {
        return edit.before.size() + edit.after.size() > Reapplication::kWorthSlicing && !edit.before.empty();
    });
}

/// Begins, carries on, ends or gives up what is applied in slices.
Status SceneGpu::Private::followReapplication(Delivery delivery) {
    if (reapplication && (!hasToStartOver() || reapplication->kind() != session.pipeline() ||
                          !reapplication->isOfTheseTargets())) {
        reapplication.reset();
    }
    if (!reapplication && delivery == Delivery::WhatHasArrived && hasToStartOver()) {
        Result<std::unique_ptr<DeformationPipeline>> made = newPipeline();
        if (!made) {
            return made.error();
        }
        const PipelineKind before = pipeline->traits().kind;
        const bool isSwitch = before != session.pipeline();
        const auto cancel = [&followed = session, isSwitch, before, edited = session.history().revision()] {
            if (isSwitch) {
                followed.setPipeline(before);
            } else if (followed.history().revision() == edited) {
                followed.undo();
            }
        };
        reapplication =
            std::make_unique<Reapplication>(session, std::move(made).value(), cancel,
                                            isSwitch ? SceneGpuText::tr("Go back to the pipeline before")
                                                     : SceneGpuText::tr("Undo the change"));
    }
    if (!reapplication) {
        return Done{};
    }
    if (delivery == Delivery::All) {
        reapplication->finish();
        takeReapplied();
    } else if (reapplication->advance()) {
        takeReapplied();
    }
    return Done{};
}

/// Everything is applied: from now on this is what is shown.
void SceneGpu::Private::takeReapplied() {
    const std::unique_ptr<Reapplication> done = std::move(reapplication);
    unapplied.emplace();
    applied.reset(session.shownHits().size());
    ++meshRevision;
    Reapplication::Buffers buffers = done->takeBuffers();
    pipeline = done->takePipeline();
    for (auto& [id, target] : targets) {
        target.buffers = std::move(buffers.at(id));
        target.buffers->writeShadingNormals(0, session.target(id)->trueNormals.normals());
    }
    session.restartReadBack();
    session.setCapacity(pipeline->capacity());
    done->deliver([this](TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
        session.takeReadBack(target, first, vertices);
    });
    readBack(Delivery::All);
}

Status SceneGpu::Private::followPipeline(bool& startOver) {
    startOver = !pipeline || pipeline->traits().kind != session.pipeline();
    if (!startOver) {
        return Done{};
    }
    Result<std::unique_ptr<DeformationPipeline>> made = newPipeline();
    if (!made) {
        return made.error();
    }
    pipeline = std::move(made).value();
    for (auto& [id, target] : targets) {
        target.buffers->restoreOriginal();
        pipeline->addTarget(id, *target.buffers);
    }
    session.restartReadBack();
    return Done{};
}

bool SceneGpu::Private::followHistory(bool startOver) {
    const HitHistory& history = session.history();
    const std::span<const Hit> shown = session.shownHits();
    if (!startOver && unapplied && unapplied->empty() && applied.size() == shown.size()) {
        return false;
    }
    startOver = startOver || !unapplied;
    if (startOver) {
        meter.applying(0, shown.size(), false);
        pipeline->reset(shown);
        applied.reset(shown.size());
    } else {
        const std::vector<HistoryEdit> made =
            withAppendsJoined(applied.follow(*unapplied, history.hits(), shown.size()));
        if (made.size() == 1 && isAppend(made.front(), shown.size())) {
            meter.applying(made.front().first, made.front().after.size(), true);
        }
        for (const HistoryEdit& edit : made) {
            pipeline->edit(edit);
        }
    }
    unapplied.emplace();
    ++meshRevision;
    session.setCapacity(pipeline->capacity());
    return startOver;
}

void SceneGpu::Private::readBack(Delivery delivery) {
    const auto take = [this](TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
        session.takeReadBack(target, first, vertices);
    };
    if (delivery == Delivery::All) {
        pipeline->readBack(take);
    } else {
        pipeline->pollReadBack(take);
    }
    for (const Session::ChangedNormals& change : session.finishReadBack()) {
        const Target* target = session.target(change.target);
        if (target != nullptr) {
            GpuTarget& gpu = targets.at(change.target);
            gpu.changed.note(change.renderVertices);
            writeShadingNormals(*gpu.buffers, change.renderVertices, target->trueNormals.normals());
        }
    }
}

Status SceneGpu::Private::follow(Delivery delivery) {
    followTargets();
    followCover();
    seeHistory();
    if (Status status = followReapplication(delivery); !status) {
        return status;
    }
    if (reapplication) {
        // Until it is done everything stays as it was, also where the session is already further.
        readBack(Delivery::WhatHasArrived);
        return Done{};
    }
    bool startOver = false;
    if (Status status = followPipeline(startOver); !status) {
        return status;
    }
    meter.endOf(FrameMeter::Part::Preparation);
    // Started over, the CPU copy is at the originals: it must not be seen like that for a frame or two.
    if (followHistory(startOver)) {
        delivery = Delivery::All;
    }
    meter.endOf(FrameMeter::Part::Deformation);
    readBack(delivery);
    meter.endOf(FrameMeter::Part::ReadBack);
    if (!pipeline->isReadBackPending()) {
        session.setUpToDate();
    }
    return Done{};
}

Status SceneGpu::sync() {
    d->meter.begin();
    Status status = d->follow(Private::Delivery::All);
    d->meter.end();
    return status;
}

void SceneGpu::collectCosts() {
    d->meter.collect();
}

const Session& SceneGpu::session() const {
    return d->session;
}

bool SceneGpu::isReadBackPending() const {
    return d->reapplication || (d->pipeline && d->pipeline->isReadBackPending()) ||
           d->second.isReadBackPending();
}

Status SceneGpu::drawElements(const View& view, PickPass& pass, const PixelArea& area,
                              PickElements elements) {
    if (!d->pipeline) {
        return Done{};
    }
    std::vector<DrawItem> items = d->drawItems();
    Frame frame;
    frame.width = view.width;
    frame.height = view.height;
    frame.camera = view.camera;
    frame.options = view.options;
    frame.targets = items;
    if (!showsOriginals(view)) {
        return pass.draw(frame, *d->pipeline, area, elements);
    }
    for (DrawItem& item : items) {
        item.original = true;
    }
    render::OriginalShape shape;
    return pass.draw(frame, shape, area, elements);
}

void SceneGpu::Private::followComparison(Comparison* comparison) {
    second.follow(comparison, deformDefines, SecondScene::Delivery::WhatHasArrived);
    if (second.isReady() && !second.isReadBackPending() && !pipeline->isReadBackPending()) {
        comparison->settle(second.pipeline().capacity().dropped.size());
    }
}

Status SceneGpu::Private::drawAll(Frame& frame, const View& view, unsigned framebuffer) {
    if (!isSideBySide(view)) {
        return renderer->draw(frame, *pipeline, framebuffer);
    }
    frame.width = view.width / 2;
    if (Status status = renderer->draw(frame, *pipeline, framebuffer); !status) {
        return status;
    }
    const std::vector<DrawItem> items = second.itemsFor(frame.targets);
    if (frame.change) {
        secondUpload.follow(view.changeValues);
        for (const DrawItem& item : items) {
            secondUpload.upload(item.target, second.buffersOf(item.target));
        }
    }
    frame.targets = items;
    frame.section = nullptr;  // it is that of the active pipeline
    frame.left = frame.width;
    frame.width = view.width - frame.left;
    return renderer->draw(frame, second.pipeline(), framebuffer);
}

Status SceneGpu::draw(const View& view, unsigned framebuffer) {
    d->meter.begin();
    if (Status status = d->follow(Private::Delivery::WhatHasArrived); !status) {
        d->meter.end();
        return status;
    }
    d->followComparison(view.comparison);
    const Session& session = d->session;
    const std::vector<DrawItem> items = d->drawItems();
    std::vector<ProjectileItem> projectiles;
    projectiles.reserve(session.physics().projectileCount());
    for (const ProjectileState& projectile : session.physics().projectiles()) {
        projectiles.push_back({{projectile.drawn, projectile.radius}, projectile.colour, projectile.trail});
    }

    Frame frame;
    frame.width = view.width;
    frame.height = view.height;
    frame.pixelRatio = view.pixelRatio;
    frame.camera = view.camera;
    frame.lights = session.lights();
    frame.options = view.options;
    frame.meshRevision = d->meshRevision;
    frame.floorHeight = session.floorHeight();
    frame.targets = items;
    if (view.options.change.on) {
        frame.change =
            shownChange(view.options.change, view.changeValues ? view.changeValues->summary() : Summary());
        d->changeUpload.follow(view.changeValues);
        for (const DrawItem& item : items) {
            d->changeUpload.upload(item.target, *d->targets.at(item.target).buffers);
        }
    }
    d->marks.follow(session);
    const std::vector<VertexMarks> marks = d->marks.on(items);
    frame.marks = marks;
    frame.projectiles = projectiles;
    frame.ghost = view.ghost;
    frame.section = view.section;
    frame.showsCutPlane = view.showsCutPlane;
    if (session.selectedHit()) {
        const Hit& hit = session.history().hits()[*session.selectedHit()];
        if (const Target* target = session.target(hit.target)) {
            frame.highlightedHit = Sphere{target->transform.toWorld(hit.point), hit.constants.maxDistance};
        }
    }
    Status status = d->drawAll(frame, view, framebuffer);
    d->meter.endOf(FrameMeter::Part::Drawing);
    d->meter.end();
    return status;
}

}  // namespace hitscope
