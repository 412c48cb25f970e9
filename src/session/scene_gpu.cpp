// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_gpu.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "render/pick_pass.h"
#include "render/renderer.h"
#include "session/frame_meter.h"

namespace hitscope {

namespace {

glm::mat4 modelMatrix(const RigidTransform& transform) {
    glm::mat4 model = glm::mat4_cast(transform.rotation);
    model[3] = glm::vec4(transform.position, 1.0f);
    return model;
}

/// Uploads the new normals in runs; short gaps are filled, since a call costs more than a few vertices.
void writeShadingNormals(TargetBuffers& buffers, std::span<const std::uint32_t> vertices,
                         std::span<const glm::vec3> normals) {
    constexpr std::uint32_t kLargestGap = 32;
    std::size_t begin = 0;
    while (begin < vertices.size()) {
        std::size_t end = begin + 1;
        while (end < vertices.size() && vertices[end] - vertices[end - 1] <= kLargestGap) {
            ++end;
        }
        const std::uint32_t first = vertices[begin];
        buffers.writeShadingNormals(first, normals.subspan(first, vertices[end - 1] + 1 - first));
        begin = end;
    }
}

/// Hits that came one by one are applied in one pass all the same.
std::vector<HistoryEdit> withAppendsJoined(std::vector<HistoryEdit> edits) {
    std::vector<HistoryEdit> joined;
    for (HistoryEdit& edit : edits) {
        HistoryEdit* last = joined.empty() ? nullptr : &joined.back();
        if (last != nullptr && last->before.empty() && edit.before.empty() &&
            last->first + last->after.size() == edit.first) {
            last->after.insert(last->after.end(), edit.after.begin(), edit.after.end());
        } else {
            joined.push_back(std::move(edit));
        }
    }
    return joined;
}

bool isAppend(const HistoryEdit& edit, const HitHistory& history) {
    return edit.before.empty() && edit.first + edit.after.size() == history.size();
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

struct SceneGpu::Private {
    explicit Private(Session& followed) : session(followed), meter(followed.frameCosts()) {}

    struct GpuTarget {
        std::unique_ptr<TargetBuffers> buffers;
        std::shared_ptr<const MaterialSet> materials;
    };

    Session& session;
    FrameMeter meter;
    std::unique_ptr<Renderer> renderer;
    std::unordered_map<TargetId, GpuTarget> targets;
    std::unique_ptr<DeformationPipeline> pipeline;  // below the buffers it is given, so that it goes first
    std::unordered_map<const MeshData*, std::weak_ptr<const MaterialSet>> materials;
    std::shared_ptr<const Image> coverImage;  // what `cover` was made of
    std::shared_ptr<const MaterialSet> cover;
    std::uint64_t appliedRevision = 0;
    gl::Defines deformDefines;

    void followTargets();
    void followCover();
    [[nodiscard]] const MaterialSet* materialsToDraw(const Target& target) const;
    [[nodiscard]] std::vector<DrawItem> drawItems() const;
    Status followPipeline(bool& startOver);
    /// Returns whether the pipeline started over.
    bool followHistory(bool startOver);
    enum class Delivery { WhatHasArrived, All };
    void readBack(Delivery delivery);
    Status follow(Delivery delivery);
    std::shared_ptr<const MaterialSet> materialsOf(const DeformedMesh& mesh);
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
        GpuTarget& made = targets[target->id];
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
                             target->id == session.selectedTarget() && session.targets().size() > 1});
        }
    }
    return items;
}

Status SceneGpu::Private::followPipeline(bool& startOver) {
    startOver = !pipeline || pipeline->traits().kind != session.pipeline();
    if (!startOver) {
        return Done{};
    }
    Result<std::unique_ptr<DeformationPipeline>> made =
        makePipeline(session.pipeline(), {.vertexUniformComponents = {}, .deformDefines = deformDefines});
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
    if (!startOver && appliedRevision == history.revision()) {
        return false;
    }
    auto edits = history.editsSince(appliedRevision);
    startOver = startOver || !edits;
    if (startOver) {
        meter.applying(0, history.size(), false);
        pipeline->reset(history.hits());
    } else {
        const std::vector<HistoryEdit> joined = withAppendsJoined(*std::move(edits));
        if (joined.size() == 1 && isAppend(joined.front(), history)) {
            meter.applying(joined.front().first, joined.front().after.size(), true);
        }
        for (const HistoryEdit& edit : joined) {
            pipeline->edit(edit);
        }
    }
    appliedRevision = history.revision();
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
            writeShadingNormals(*targets.at(change.target).buffers, change.renderVertices,
                                target->trueNormals.normals());
        }
    }
}

Status SceneGpu::Private::follow(Delivery delivery) {
    followTargets();
    followCover();
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

bool SceneGpu::isReadBackPending() const {
    return d->pipeline && d->pipeline->isReadBackPending();
}

Status SceneGpu::drawElements(const View& view, PickPass& pass, const PixelArea& area,
                              PickElements elements) {
    if (!d->pipeline) {
        return Done{};
    }
    const std::vector<DrawItem> items = d->drawItems();
    Frame frame;
    frame.width = view.width;
    frame.height = view.height;
    frame.camera = view.camera;
    frame.options = view.options;
    frame.targets = items;
    return pass.draw(frame, *d->pipeline, area, elements);
}

Status SceneGpu::draw(const View& view, unsigned framebuffer) {
    d->meter.begin();
    if (Status status = d->follow(Private::Delivery::WhatHasArrived); !status) {
        d->meter.end();
        return status;
    }
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
    frame.floorHeight = session.floorHeight();
    frame.targets = items;
    frame.projectiles = projectiles;
    frame.ghost = view.ghost;
    if (session.selectedHit()) {
        const Hit& hit = session.history().hits()[*session.selectedHit()];
        if (const Target* target = session.target(hit.target)) {
            frame.highlightedHit = Sphere{target->transform.toWorld(hit.point), hit.constants.maxDistance};
        }
    }
    Status status = d->renderer->draw(frame, *d->pipeline, framebuffer);
    d->meter.endOf(FrameMeter::Part::Drawing);
    d->meter.end();
    return status;
}

}  // namespace hitscope
