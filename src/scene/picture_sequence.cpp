// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture_sequence.h"

#include <QDir>
#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "analysis/change_values.h"
#include "analysis/hit_effects.h"
#include "analysis/scene_section.h"
#include "scene/picture_drawing.h"

namespace hitscope {

namespace {

constexpr int kDigits = 4;

/// The session's targets as they were, and its settings, in another session; which targets became which.
std::map<TargetId, TargetId> copyScene(const Session& from, Session& to) {
    ScenePlan plan{from.sceneName(), {}, from.targets().floorHeight()};
    for (const std::unique_ptr<Target>& target : from.targets()) {
        plan.targets.push_back({target->name, target->shape, target->transform,
                                target->collider ? *target->collider : Collider{}, target->sourcePath});
    }
    to.loadScene(std::move(plan));
    to.settings().restoreLights(from.settings().lights());
    to.settings().restoreCoverTexture(from.settings().coverTexture());
    to.settings().setPipeline(from.settings().pipeline());
    to.targets().select({});
    std::map<TargetId, TargetId> became;
    std::vector<TargetId> hidden;
    for (std::size_t i = 0; i < from.targets().size(); ++i) {
        const TargetId copy = to.targets()[i]->id;
        became[from.targets()[i]->id] = copy;
        if (!from.targets()[i]->visible) {
            hidden.push_back(copy);
        }
    }
    to.targets().setVisible(hidden, false);
    return became;
}

/// Of the first `count` hits, or of all that there are.
std::vector<Hit> enabledHits(const Session& session, std::size_t count,
                             const std::map<TargetId, TargetId>& became) {
    std::vector<Hit> hits;
    const std::span<const Hit> all = session.hits().history().hits();
    for (Hit hit : all.first(std::min(count, all.size()))) {
        const auto target = became.find(hit.target);
        if (hit.enabled && target != became.end()) {
            hit.target = target->second;
            hits.push_back(hit);
        }
    }
    return hits;
}

}  // namespace

struct PictureSequence::Private {
    PictureRequest request;
    int count = 0;
    int drawn = 0;
    // A replay's own.
    Session session;
    std::vector<Hit> hits;
    std::unique_ptr<ChangeValues> values;
    std::unique_ptr<HitEffects> effects;  // null: nobody asks for numbers of hits
    std::unique_ptr<SceneGpu> replayed;
    SceneGpu* scene = nullptr;
    std::optional<PictureDrawing>
        drawing;  // below the scene, so that it goes first; nothing between pictures

    [[nodiscard]] Status beginPicture();
    void ownChange();
    [[nodiscard]] Status add(const Hit& hit);
};

/// Colours by what the replay's own vertices do.
void PictureSequence::Private::ownChange() {
    request.comparison = nullptr;
    request.otherSection = nullptr;
    request.options.sideBySide = false;
    const ChangeValues* shown = std::exchange(request.changeValues, nullptr);
    ChangeMapOptions& change = request.options.change;
    if (!change.on) {
        return;
    }
    change.style().fixed = shownRange(change, shown != nullptr ? shown->summary() : Summary());
    change.style().automatic = false;
    values = std::make_unique<ChangeValues>(session);
    if (change.quantity == ChangeQuantity::HitCount) {
        effects = std::make_unique<HitEffects>(session);
        values->setHitCounts([this](TargetId target) { return effects->counts(target); });
    }
    values->setQuantity(change.quantity);
    request.changeValues = values.get();
}

Status PictureSequence::Private::add(const Hit& hit) {
    Status added = session.hits().add(hit);
    if (added && effects) {
        effects->finish();
        values->touchAll(hit.target);
    }
    return added;
}

PictureSequence::PictureSequence(std::unique_ptr<Private> parts) : d(std::move(parts)) {}
PictureSequence::PictureSequence(PictureSequence&&) noexcept = default;
PictureSequence& PictureSequence::operator=(PictureSequence&&) noexcept = default;
PictureSequence::~PictureSequence() = default;

PictureSequence PictureSequence::turntable(SceneGpu& scene, const PictureRequest& request, int count) {
    auto parts = std::make_unique<Private>();
    parts->request = request;
    parts->count = count;
    parts->scene = &scene;
    return PictureSequence(std::move(parts));
}

Result<PictureSequence> PictureSequence::replay(const Session& session, const PictureRequest& request,
                                                std::optional<std::size_t> until) {
    auto parts = std::make_unique<Private>();
    parts->request = request;
    parts->request.section = nullptr;
    const std::size_t count = until.value_or(session.hits().history().size());
    parts->hits = enabledHits(session, count, copyScene(session, parts->session));
    parts->count = static_cast<int>(parts->hits.size()) + 1;
    parts->ownChange();
    Result<std::unique_ptr<SceneGpu>> scene = SceneGpu::create(parts->session);
    if (!scene) {
        return scene.error();
    }
    parts->replayed = std::move(scene).value();
    parts->scene = parts->replayed.get();
    return PictureSequence(std::move(parts));
}

int PictureSequence::count() const {
    return d->count;
}

Status PictureSequence::Private::beginPicture() {
    const int index = drawn++;
    if (index == 0 && !replayed && request.options.cut.on) {
        // The same section in all of them.
        if (Status current = scene->sync(); !current) {
            return current;
        }
        request.section =
            sectionLines(scene->session(), request.options.cut, request.options.beforeAfter.exaggeration);
    }
    PictureRequest one = request;
    if (!replayed) {
        one.camera.orbit(glm::two_pi<float>() * static_cast<float>(index) / static_cast<float>(count), 0.0f);
    } else if (index > 0) {
        if (Status added = add(hits[static_cast<std::size_t>(index) - 1]); !added) {
            return added;
        }
    }
    drawing.emplace(*scene, one);
    return Done{};
}

Result<std::optional<Image>> PictureSequence::advance() {
    if (!d->drawing) {
        if (Status begun = d->beginPicture(); !begun) {
            return begun.error();
        }
    }
    const Result<bool> done = d->drawing->step();
    if (!done) {
        return done.error();
    }
    if (!done.value()) {
        return std::optional<Image>();
    }
    Result<Image> image = d->drawing->take();
    d->drawing.reset();
    if (!image) {
        return image.error();
    }
    return std::optional<Image>(std::move(image).value());
}

Result<Image> PictureSequence::next() {
    while (true) {
        Result<std::optional<Image>> image = advance();
        if (!image) {
            return image.error();
        }
        if (image.value()) {
            return *std::move(image).value();
        }
    }
}

QString sequencePath(const QString& folder, const QString& base, int number, int count) {
    const auto digits = std::max(kDigits, static_cast<int>(QString::number(count).size()));
    return QDir(folder).filePath(
        QStringLiteral("%1-%2.png")
            .arg(base, QString::number(number).rightJustified(digits, QLatin1Char('0'))));
}

}  // namespace hitscope
