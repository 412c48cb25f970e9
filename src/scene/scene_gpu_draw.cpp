// SPDX-License-Identifier: GPL-3.0-or-later
// How SceneGpu draws: into the caller's framebuffer, ahead into its own, and refined.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/change_values.h"
#include "analysis/comparison.h"
#include "scene/refined_view.h"
#include "scene/scene_gpu_private.h"

namespace hitscope {

void SceneGpu::Private::followComparison(const View& view) {
    Comparison* comparison = view.comparison;
    second.follow(comparison, deformDefines, SecondScene::Delivery::WhatHasArrived);
    if (comparison != nullptr) {
        comparison->setShownQuantity(isSideBySide(view) && view.options.change.on
                                         ? std::optional(view.options.change.quantity)
                                         : std::nullopt);
    }
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
        const ChangeValues* own = view.comparison->values();
        second.uploadChange(own != nullptr ? own : view.changeValues, items);
    }
    const std::vector<VertexMarks> secondMarks =
        view.selectionMarks ? marks.on(items) : std::vector<VertexMarks>();
    frame.targets = items;
    frame.marks = secondMarks;
    frame.section = view.otherSection;
    frame.left = frame.width;
    frame.width = view.width - frame.left;
    return renderer->draw(frame, second.pipeline(), framebuffer);
}

SceneGpu::View SceneGpu::Private::drawnView(const View& shown) {
    const auto smaller = [&shown](int side) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(side) * shown.detail.scale)));
    };
    View drawn = shown;
    if (shown.detail.scale < 1.0f) {
        drawn.width = smaller(shown.width);
        drawn.height = smaller(shown.height);
        drawn.pixelRatio *= shown.detail.scale;
    }
    return drawn;
}

bool SceneGpu::Private::hasOwn(const View& drawn) const {
    return ownTarget && ownTarget->width() == drawn.width && ownTarget->height() == drawn.height;
}

bool SceneGpu::Private::makeOwn(const View& drawn) {
    if (!hasOwn(drawn)) {
        ownTarget = std::make_unique<gl::RenderTarget>(drawn.width, drawn.height);
    }
    if (!ownTarget->isComplete()) {
        ownTarget.reset();
    }
    return ownTarget != nullptr;
}

Result<bool> SceneGpu::prepare(const View& shown, RefinedView* refined) {
    if (!d->pipeline) {
        return true;
    }
    if (d->hasNewTargets()) {
        d->followTargets();
        return false;
    }
    if (!d->isFollowed && d->hasToFollow()) {
        d->isFollowed = true;
        if (const Status applied = applyMore(); !applied) {
            return applied.error();
        }
        return false;
    }
    d->followTargets();
    d->followCover();
    const View view = d->choose(shown, refined).view;
    if (const View drawn = d->drawnView(view); !d->hasOwn(drawn) && d->makeOwn(drawn)) {
        return false;
    }
    const std::unique_ptr<FrameParts> parts = d->frameOf(view);
    if (!d->isWarm && d->ownTarget) {
        d->isWarm = d->renderer->warmUp(parts->frame, *d->pipeline, d->ownTarget->framebuffer());
        return false;
    }
    if (d->renderer->isPrepared(parts->frame, *d->pipeline)) {
        return true;
    }
    if (const Status drawn = d->renderer->prepare(parts->frame, *d->pipeline); !drawn) {
        return drawn.error();
    }
    glFlush();
    return false;
}

bool SceneGpu::wasCoarse() const {
    return d->renderer->wasCoarse();
}

bool SceneGpu::Private::hasPlain(const FrameParts& parts, const View& view, RefinedView& refined) {
    if (!view.isAtRest || !view.detail.isFull()) {
        return false;
    }
    refined.follow(parts, isSideBySide(view));
    if (!refined.isPossible() || (refined.hasPicture() && !refined.isPlain())) {
        return false;
    }
    return (refined.isPlain() && refined.isWhole()) ||
           (renderer->drawPlain(parts.frame, *pipeline, refined.picture()) && refined.isPlain());
}

SceneGpu::Private::Choice SceneGpu::Private::choose(const View& shown, RefinedView* refined) {
    Choice choice{shown, std::nullopt};
    if (refined == nullptr || isSideBySide(shown)) {
        return choice;
    }
    View full = shown;
    full.detail = {};
    const std::unique_ptr<FrameParts> parts = frameOf(full);
    const bool inFull = shown.detail.isFull();
    if (!inFull && refined->has(*parts, inFull)) {
        choice.view = full;
        choice.isKept = true;
        return choice;
    }
    if (!refined->isPatchable(*parts, inFull)) {
        return choice;
    }
    choice.patch = refined->patchFor(*parts, !inFull, [&] {
        return renderer->patchFor(parts->frame, *pipeline, refined->picture(), !inFull);
    });
    if (choice.patch) {
        choice.view = full;
        choice.view.detail.coarse = choice.patch->isCoarse;
    }
    return choice;
}

Result<SceneGpu::Private::Choice> SceneGpu::Private::beginPicture(const View& shown, RefinedView* refined) {
    meter.begin();
    if (Status status = followForPicture(); !status) {
        meter.end();
        return status.error();
    }
    followComparison(shown);
    if (second.isReady()) {
        meter.comparing();
    }
    return choose(shown, refined);
}

/// Without samples of which the noise would be seen.
Status SceneGpu::Private::showRefined(const Choice& choice, const FrameParts& parts, RefinedView& refined,
                                      unsigned framebuffer) {
    if (choice.isAhead) {
        const Result<bool> isThere =
            renderer->isPlainShown(parts.frame, refined.picture(), RefinedView::kFewestShown);
        if (!isThere) {
            return isThere.error();
        }
        if (isThere.value()) {
            aheadIn = &refined;
            return Done{};
        }
    }
    return renderer->drawRefined(parts.frame, *pipeline, refined.picture(), framebuffer,
                                 RefinedView::kFewestShown);
}

Status SceneGpu::Private::drawPatched(const Choice& choice, unsigned framebuffer, RefinedView& refined) {
    const std::unique_ptr<FrameParts> parts = frameOf(choice.view);
    if (Status status = renderer->patch(parts->frame, *pipeline, refined.picture(), *choice.patch); !status) {
        refined.forget();
        return status;
    }
    refined.patched(*parts);
    return showRefined(choice, *parts, refined, framebuffer);
}

Status SceneGpu::Private::drawScene(const Choice& choice, unsigned framebuffer, RefinedView* refined) {
    if (choice.patch) {
        Status status = drawPatched(choice, framebuffer, *refined);
        meter.endOf(FrameMeter::Part::Drawing);
        return status;
    }
    const View& view = choice.view;
    const std::unique_ptr<FrameParts> parts = frameOf(view);
    if (choice.isKept) {
        refined->keptShown(view.projectilesFly);
        Status status = showRefined(choice, *parts, *refined, framebuffer);
        meter.endOf(FrameMeter::Part::Drawing);
        return status;
    }
    if (refined != nullptr && refined->show(*parts, isSideBySide(view), view.detail.coarse)) {
        return showRefined(choice, *parts, *refined, framebuffer);
    }
    if (refined != nullptr && !isSideBySide(view) && !refined->isPlain() &&
        refined->has(*parts, view.detail.isFull())) {
        refined->plainShown();  // until there are samples enough
        Status status = showRefined(choice, *parts, *refined, framebuffer);
        meter.endOf(FrameMeter::Part::Drawing);
        return status;
    }
    Status status = refined != nullptr && hasPlain(*parts, view, *refined)
                        ? showRefined(choice, *parts, *refined, framebuffer)
                        : drawAll(parts->frame, view, framebuffer);
    meter.endOf(FrameMeter::Part::Drawing);
    return status;
}

Status SceneGpu::Private::drawPicture(const Choice& choice, unsigned framebuffer, RefinedView* refined) {
    Status status = drawScene(choice, framebuffer, refined);
    meter.end();
    return status;
}

Status SceneGpu::draw(const View& shown, unsigned framebuffer, RefinedView* refined) {
    Result<Private::Choice> begun = d->beginPicture(shown, refined);
    if (!begun) {
        return begun.error();
    }
    Private::Choice choice = std::move(begun).value();
    const View smaller = d->drawnView(choice.view);
    if (choice.view.detail.scale >= 1.0f || !d->makeOwn(smaller)) {
        return d->drawPicture(choice, framebuffer, refined);
    }
    d->ahead.reset();
    choice.view = smaller;
    Status status = d->drawPicture(choice, d->ownTarget->framebuffer(), refined);
    if (status) {
        d->ownTarget->enlargeInto(framebuffer, shown.width, shown.height);
    }
    return status;
}

Result<bool> SceneGpu::drawAhead(const View& shown, RefinedView* refined) {
    d->ahead.reset();
    Result<Private::Choice> begun = d->beginPicture(shown, refined);
    if (!begun) {
        return begun.error();
    }
    Private::Choice choice = std::move(begun).value();
    choice.view = d->drawnView(choice.view);
    choice.isAhead = true;
    d->aheadIn = nullptr;
    if (!d->makeOwn(choice.view)) {
        d->meter.end();
        return false;
    }
    if (const Status status = d->drawPicture(choice, d->ownTarget->framebuffer(), refined); !status) {
        return status.error();
    }
    d->ahead.emplace();
    return true;
}

bool SceneGpu::isDrawnAhead() const {
    return !d->ahead || d->ahead->isPassed();
}

std::pair<int, int> SceneGpu::aheadSize() const {
    return d->ownTarget ? std::pair(d->ownTarget->width(), d->ownTarget->height()) : std::pair(0, 0);
}

bool SceneGpu::readAhead(std::uint8_t* pixels, RefinedView* refined) {
    d->ahead.reset();
    if (d->aheadIn != refined && d->aheadIn != nullptr) {
        return false;
    }
    const unsigned framebuffer = d->aheadIn != nullptr ? refined->picture().plainFramebuffer()
                                 : d->ownTarget        ? d->ownTarget->framebuffer()
                                                       : 0;
    if (framebuffer != 0) {
        gl::readBlueFirst(framebuffer, d->ownTarget->width(), d->ownTarget->height(), pixels);
    }
    return framebuffer != 0;
}

Status SceneGpu::refine(const View& view, RefinedView& refined) {
    if (!d->pipeline) {
        return Done{};
    }
    const std::unique_ptr<FrameParts> parts = d->frameOf(view);
    refined.follow(*parts, d->isSideBySide(view));
    return refined.isPossible() ? d->renderer->refine(parts->frame, *d->pipeline, refined.picture())
                                : Status(Done{});
}

bool SceneGpu::isBehindRefining(RefinedView& refined) const {
    return d->renderer->isBehindRefining(refined.picture());
}

bool SceneGpu::isRefined(const View& view, RefinedView& refined) const {
    if (!d->pipeline) {
        return false;
    }
    refined.follow(*d->frameOf(view), d->isSideBySide(view));
    return refined.isPossible() && refined.samples() >= RefinedView::kFewestShown;
}

Status SceneGpu::drawRefined(const View& view, RefinedView& refined, unsigned framebuffer) {
    const std::unique_ptr<FrameParts> parts = d->frameOf(view);
    return d->renderer->drawRefined(parts->frame, *d->pipeline, refined.picture(), framebuffer);
}

}  // namespace hitscope
