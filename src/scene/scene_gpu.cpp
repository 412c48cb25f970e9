// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_gpu.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "analysis/change_values.h"
#include "analysis/comparison.h"
#include "pipeline/measure_exactness.h"
#include "pipeline/pipeline_trial.h"
#include "render/original_shape.h"
#include "render/pick_pass.h"
#include "render/picking_trial.h"
#include "scene/picture_part.h"
#include "scene/refined_view.h"
#include "scene/scene_gpu_private.h"

namespace hitscope {

namespace {

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
    ReadBack& readBack = session.readBack(ReadBackAccess());
    readBack.setExactness(exactness.value());
    readBack.setUnavailablePipelines(unavailablePipelines());
    readBack.setVerdict({});
    std::unique_ptr<SceneGpu> scene(new SceneGpu(session));
    scene->d->deformDefines = definesOf(exactness.value());
    scene->d->renderer = std::move(renderer).value();
    scene->d->tryDefault();
    return scene;
}

PipelineOptions SceneGpu::Private::options() const {
    PipelineOptions options;
    options.deformDefines = deformDefines;
    return options;
}

void SceneGpu::Private::tryOut(PipelineKind kind) {
    if (session.readBack().verdict().of(kind) == nullptr) {
        RendererVerdict verdict = session.readBack().verdict();
        verdict.pipelines[kind] = tryPipeline(kind, options());
        readBack.setVerdict(std::move(verdict));
    }
}

/// The session's pipeline, and where it fails, others until one is known that can stand in for it.
void SceneGpu::Private::tryDefault() {
    tryOut(session.settings().pipeline());
    for (const PipelineTraits& traits : allPipelines()) {
        if (session.readBack().verdict().of(session.settings().pipeline())->isExact() ||
            session.readBack().verdict().insteadOf(session.settings().pipeline())) {
            return;
        }
        tryOut(traits.kind);
    }
}

const PickingVerdict& SceneGpu::Private::pickingVerdict() {
    if (!session.readBack().verdict().picking) {
        RendererVerdict verdict = session.readBack().verdict();
        verdict.picking = tryPicking();
        readBack.setVerdict(std::move(verdict));
    }
    return *session.readBack().verdict().picking;
}

bool SceneGpu::tryNext() {
    for (const PipelineTraits& traits : allPipelines()) {
        if (d->session.readBack().verdict().of(traits.kind) == nullptr) {
            d->tryOut(traits.kind);
            return true;
        }
    }
    static_cast<void>(d->pickingVerdict());
    return false;
}

/// The visible targets that are on the GPU.
std::vector<DrawItem> SceneGpu::Private::drawItems() const {
    std::vector<DrawItem> items;
    items.reserve(session.targets().size());
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const auto gpu = targets.find(target->id);
        if (target->visible && gpu != targets.end()) {
            items.push_back({target->id, gpu->second.buffers.get(), materialsToDraw(*target),
                             target->transform.matrix(),
                             session.targets().isSelected(target->id) && session.targets().size() > 1,
                             &gpu->second.changed});
            items.back().settled = gpu->second.settled;
            items.back().vertices = target->deformed.vertices();
        }
    }
    return items;
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

bool SceneGpu::isBehind() const {
    return d->reapplication || d->appending || (d->pipeline && d->pipeline->isReadBackPending());
}

bool SceneGpu::isFarBehind() const {
    return d->isFarBehind();
}

Status SceneGpu::applyMore() {
    d->meter.begin();
    Status status = d->follow(Private::Delivery::WhatHasArrived);
    d->meter.end();
    return status;
}

void SceneGpu::setAppliesBetweenPictures(bool on) {
    d->appliesBetweenPictures = on;
}

bool SceneGpu::isReadBackPending() const {
    return isBehind() || d->second.isReadBackPending();
}

Status SceneGpu::drawElements(const View& view, PickPass& pass, const PixelArea& area,
                              PickElements elements) {
    if (!d->pipeline) {
        return Done{};
    }
    const PickingVerdict& verdict = d->pickingVerdict();
    if (!verdict.isRight()) {
        return Error{"What lies under the cursor cannot be told with this graphics driver: picking was " +
                         describe(verdict) + ".",
                     "", "Another driver, or LIBGL_ALWAYS_SOFTWARE=1, may do better."};
    }
    pass.setWay(verdict.byGeometry);
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

}  // namespace hitscope
