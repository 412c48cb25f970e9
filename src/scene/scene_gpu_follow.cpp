// SPDX-License-Identifier: GPL-3.0-or-later
// What brings the GPU to the session's state: the pipeline, the history's edits, what comes back.
#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/scene_gpu_private.h"
#include "scene/shading_normals.h"

namespace hitscope {

namespace {

constexpr std::size_t kWorthSlicingNew = 256;  // hits; fewer are applied in one frame without a pause
constexpr std::size_t kFewestAtOnce = 2;       // hits between two looks at the clock: first as few,
constexpr std::size_t kMostAtOnce = 16;        // then twice as many each time, since hits may be large
constexpr std::size_t kMostNewAFrame = 512;    // hits; the GPU may be behind, which the clock does not tell
constexpr qint64 kNewShare = 12;               // milliseconds of a frame

}  // namespace

/// Lends the words to be translated their context.
struct SceneGpuText {
    Q_DECLARE_TR_FUNCTIONS(hitscope::SceneGpu)
};

/// Nothing is shown or saved of a pipeline that has not been tried.
Result<std::unique_ptr<DeformationPipeline>> SceneGpu::Private::newPipeline() {
    tryOut(session.settings().pipeline());
    return makePipeline(session.settings().pipeline(), options());
}

/// The history keeps its large edits for a short while only: they are taken as they come.
void SceneGpu::Private::seeHistory() {
    const HitHistory& history = session.hits().history();
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
    if (!pipeline ||
        !Reapplication::isWorthSlicing(session.settings().pipeline(), session.hits().shown().size())) {
        return false;
    }
    if (pipeline->traits().kind != session.settings().pipeline() || !unapplied) {
        return true;
    }
    return std::any_of(unapplied->begin(), unapplied->end(), [](const HistoryEdit& edit) {
        return edit.before.size() + edit.after.size() > Reapplication::kWorthSlicing && !edit.before.empty();
    });
}

/// Begins, carries on, ends or gives up what is applied in slices.
Status SceneGpu::Private::followReapplication(Delivery delivery) {
    if (reapplication && (!hasToStartOver() || reapplication->kind() != session.settings().pipeline() ||
                          !reapplication->isOfTheseTargets())) {
        reapplication.reset();
    }
    if (!reapplication && delivery == Delivery::WhatHasArrived && hasToStartOver()) {
        Result<std::unique_ptr<DeformationPipeline>> made = newPipeline();
        if (!made) {
            return made.error();
        }
        const PipelineKind before = pipeline->traits().kind;
        const bool isSwitch = before != session.settings().pipeline();
        const auto cancel = [&followed = session, isSwitch, before,
                             edited = session.hits().history().revision()] {
            if (isSwitch) {
                followed.settings().setPipeline(before);
            } else if (followed.hits().history().revision() == edited) {
                followed.undo();
            }
        };
        reapplication =
            std::make_unique<Reapplication>(session, std::move(made).value(), cancel,
                                            isSwitch ? SceneGpuText::tr("Return to the previous pipeline")
                                                     : SceneGpuText::tr("Undo the change"));
    }
    if (!reapplication) {
        return Done{};
    }
    if (delivery != Delivery::WhatHasArrived) {
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
    applied.reset(session.hits().shown().size());
    ++meshRevision;
    Reapplication::Buffers buffers = done->takeBuffers();
    pipeline = done->takePipeline();
    isWarm = false;
    changeUpload.forget();
    for (auto& [id, target] : targets) {
        target.buffers = std::move(buffers.at(id));
        if (const TrueNormals& normals = session.targets().find(id)->trueNormals; !normals.areOriginal()) {
            target.buffers->writeShadingNormals(0, normals.normals().all());
        }
    }
    readBack.restart();
    readBack.setCapacity(pipeline->capacity());
    done->deliver([this](TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
        readBack.take(target, first, vertices);
    });
    fetch(Delivery::All);
}

Status SceneGpu::Private::followPipeline(bool& startOver) {
    startOver = !pipeline || pipeline->traits().kind != session.settings().pipeline();
    if (!startOver) {
        return Done{};
    }
    Result<std::unique_ptr<DeformationPipeline>> made = newPipeline();
    if (!made) {
        return made.error();
    }
    pipeline = std::move(made).value();
    isWarm = false;
    for (auto& [id, target] : targets) {
        target.buffers->restoreOriginal();
        pipeline->addTarget(id, *target.buffers);
    }
    readBack.restart();
    return Done{};
}

/// Whether there is a long row of new hits that nobody waits for: it is applied some hits a frame.
bool SceneGpu::Private::isWorthSlicing(Delivery delivery) const {
    const std::size_t all = session.hits().shown().size();
    return delivery == Delivery::WhatHasArrived && pipeline->traits().keepsAll &&
           (appending || all > applied.size() + kWorthSlicingNew);
}

/// The rest comes with the next frames.
void SceneGpu::Private::applySlice() {
    const std::span<const Hit> history = session.hits().history().hits();
    const std::size_t all = session.hits().shown().size();
    const std::size_t before = applied.size();
    std::span<const HistoryEdit> edits(*unapplied);
    QElapsedTimer clock;
    clock.start();
    std::size_t atOnce = kFewestAtOnce;
    do {
        const std::size_t wanted = std::min(applied.size() + atOnce, all);
        atOnce = std::min(2 * atOnce, kMostAtOnce);
        for (const HistoryEdit& edit : applied.follow(std::exchange(edits, {}), history, wanted)) {
            pipeline->edit(edit);
        }
    } while (applied.size() < std::min(all, before + kMostNewAFrame) && clock.elapsed() < kNewShare);
    if (applied.size() > before) {
        meter.applying(before, applied.size() - before, true);
    }
    if (applied.size() == all) {
        appending.reset();
        return;
    }
    if (!appending) {
        const auto cancel = [&followed = session, made = session.hits().history().revision()] {
            if (followed.hits().history().revision() == made) {
                followed.undo();
            }
        };
        appending = std::make_unique<TaskProgress>(session.tasks(), SceneGpuText::tr("Applying new hits"),
                                                   cancel, SceneGpuText::tr("Undo the change"));
    }
    appending->report(static_cast<double>(applied.size()) / static_cast<double>(all));
}

bool SceneGpu::Private::followHistory(bool startOver, Delivery delivery) {
    const HitHistory& history = session.hits().history();
    const std::span<const Hit> shown = session.hits().shown();
    if (!startOver && unapplied && unapplied->empty() && applied.size() == shown.size()) {
        return false;
    }
    startOver = startOver || !unapplied;
    if (!startOver && isWorthSlicing(delivery)) {
        applySlice();
    } else if (startOver) {
        appending.reset();
        meter.applying(0, shown.size(), false);
        pipeline->reset(shown);
        applied.reset(shown.size());
    } else {
        appending.reset();
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
    readBack.setCapacity(pipeline->capacity());
    return startOver;
}

void SceneGpu::Private::fetch(Delivery delivery) {
    const auto take = [this](TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
        readBack.take(target, first, vertices);
    };
    if (delivery == Delivery::WhatHasArrived) {
        pipeline->pollReadBack(take);
    } else {
        pipeline->readBack(take);
    }
    for (const ReadBack::ChangedNormals& change : readBack.finish()) {
        const Target* target = session.targets().find(change.target);
        if (target != nullptr) {
            ++normalsRevision;
            GpuTarget& gpu = targets.at(change.target);
            gpu.changed.note(change.renderVertices);
            writeShadingNormals(*gpu.buffers, change.renderVertices, target->trueNormals.normals());
        }
    }
}

void SceneGpu::Private::noteSettled() {
    for (auto& [id, target] : targets) {
        const ClusterReach* reach = pipeline->reach(id);
        target.settled = reach != nullptr ? reach->moment() : 0;
    }
}

bool SceneGpu::Private::isFarBehind() const {
    const std::size_t shown = session.hits().shown().size();
    const std::size_t known = applied.size();
    return pipeline && std::max(shown, known) - std::min(shown, known) > kWorthSlicingNew;
}

bool SceneGpu::Private::isBehindSession() const {
    return pipeline->traits().kind != session.settings().pipeline() ||
           seenRevision != session.hits().history().revision() ||
           applied.size() != session.hits().shown().size();
}

bool SceneGpu::Private::hasToFollow() const {
    if (appending || reapplication || isFarBehind() || hasToStartOver()) {
        return false;
    }
    return isBehindSession() || pipeline->isReadBackPending();
}

Status SceneGpu::Private::followForPicture() {
    // What has been moved is read back for the next picture: this one need not wait for it.
    const bool wasFollowed = std::exchange(isFollowed, false) && !isBehindSession();
    if (!wasFollowed && (!appliesBetweenPictures || (!appending && !reapplication && !isFarBehind()))) {
        return follow(Delivery::WhatHasArrived);
    }
    followTargets();
    followCover();
    return Done{};
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
        fetch(Delivery::WhatHasArrived);
        return Done{};
    }
    bool startOver = false;
    if (Status status = followPipeline(startOver); !status) {
        return status;
    }
    meter.endOf(FrameMeter::Part::Preparation);
    // Between pictures, one slice applies hits and the next reads back what they moved: the two take about
    // as long as one another, and an event waits for one of them.
    const bool isTakenInTurn = appliesBetweenPictures && delivery == Delivery::WhatHasArrived && !startOver;
    const bool isFetch = std::exchange(isFetchNext, false) && isTakenInTurn && appending;
    // Started over, the CPU copy is at the originals: it must not be seen like that for a frame or two.
    if (!isFetch && followHistory(startOver, delivery)) {
        delivery = Delivery::All;
    }
    meter.endOf(FrameMeter::Part::Deformation);
    isFetchNext = isTakenInTurn && appending && !isFetch && delivery == Delivery::WhatHasArrived;
    if (isFetchNext) {
        return Done{};
    }
    fetch(delivery);
    meter.endOf(FrameMeter::Part::ReadBack);
    if (!appending && !pipeline->isReadBackPending()) {
        readBack.setUpToDate();
        noteSettled();
    }
    return Done{};
}

}  // namespace hitscope
