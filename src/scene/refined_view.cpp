// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/refined_view.h"

#include <optional>
#include <utility>
#include <vector>

#include "render/refined/refined_picture.h"
#include "render/renderer.h"
#include "scene/frame_parts.h"

namespace hitscope {

namespace {

/// What decides about the picture's pixels.
struct RefinedKey {
    struct Item {
        TargetId target;
        const TargetBuffers* buffers;
        const MaterialSet* materials;
        glm::mat4 model;
        bool selected;
        bool operator==(const Item&) const = default;
    };
    struct Ball {
        glm::vec3 centre;
        float radius;
        bool operator==(const Ball&) const = default;
    };
    struct Projectile {
        Ball sphere;
        glm::vec3 colour;
        std::vector<glm::vec3> trail;
        bool operator==(const Projectile&) const = default;
    };
    explicit RefinedKey(const FrameParts& parts);
    bool operator==(const RefinedKey&) const = default;
    [[nodiscard]] bool isSameButForVertices(RefinedKey other) const {
        other.meshRevision = meshRevision;
        other.normalsRevision = normalsRevision;
        return other == *this;
    }

    int width;
    int height;
    float pixelRatio;
    Camera camera;
    Lights lights;
    DisplayOptions options;
    float floorHeight;
    std::optional<ShownChange> change;
    std::uint64_t meshRevision;
    std::uint64_t dataRevision;
    std::uint64_t normalsRevision;
    std::vector<Item> items;
    std::vector<Projectile> projectiles;
    std::shared_ptr<const SectionLines> section;
    std::optional<Ball> highlightedHit;
};

RefinedKey::RefinedKey(const FrameParts& parts)
    : width(parts.frame.width),
      height(parts.frame.height),
      pixelRatio(parts.frame.pixelRatio),
      camera(parts.frame.camera),
      lights(parts.frame.lights),
      options(parts.frame.options),
      floorHeight(parts.frame.floorHeight),
      change(parts.frame.change),
      meshRevision(parts.frame.meshRevision),
      dataRevision(parts.dataRevision),
      normalsRevision(parts.normalsRevision),
      section(parts.frame.section) {
    if (const std::optional<Sphere>& hit = parts.frame.highlightedHit) {
        highlightedHit = Ball{hit->centre, hit->radius};
    }
    options.crosshair = false;  // it is drawn over the picture
    for (const DrawItem& item : parts.items) {
        items.push_back({item.target, item.buffers, item.materials, item.model, item.selected});
    }
    if (parts.frame.projectilesFly) {
        return;  // they are drawn over it, too
    }
    for (const ProjectileItem& projectile : parts.projectiles) {
        projectiles.push_back({{projectile.sphere.centre, projectile.sphere.radius},
                               projectile.colour,
                               {projectile.trail.begin(), projectile.trail.end()}});
    }
}

}  // namespace

struct RefinedView::Private {
    /// What a patch depends on.
    struct Asked {
        RefinedKey key;
        std::vector<std::uint64_t> settled;  ///< of the frame's targets
        std::vector<std::uint64_t> moments;  ///< of the picture's
        PixelArea rough;
        float shadowMargin;
        bool isHurried;
        bool operator==(const Asked&) const = default;
    };
    explicit Private(RefinedPicture::Extent extent) : picture(extent) {}
    RefinedPicture picture;
    std::optional<RefinedKey> key;
    std::optional<Asked> asked;
    std::optional<PicturePatch> patch;  ///< the answer
};

RefinedView::RefinedView(Pixels pixels)
    : d(std::make_unique<Private>(pixels == Pixels::UntilSettled ? RefinedPicture::Extent::WhereItStillVaries
                                                                 : RefinedPicture::Extent::WhereItVaries)) {}
RefinedView::~RefinedView() = default;

int RefinedView::samples() const {
    return d->picture.samples();
}

bool RefinedView::hasPicture() const {
    return d->picture.hasPicture();
}

bool RefinedView::isPossible() const {
    return d->key.has_value();
}

bool RefinedView::isPlain() const {
    return d->picture.hasPicture() && !d->picture.isBegun();
}

RefinedPicture& RefinedView::picture() {
    return d->picture;
}

bool RefinedView::isRough() const {
    return !d->picture.rough().empty();
}

void RefinedView::forget() {
    d->picture.clear();
}

bool RefinedView::isPatchable(const FrameParts& parts, bool inFull) const {
    if (!d->key || !d->picture.hasPicture()) {
        return false;
    }
    const RefinedKey key(parts);
    return key == *d->key ? inFull && isRough() : d->key->isSameButForVertices(key);
}

std::optional<PicturePatch> RefinedView::patchFor(const FrameParts& parts, bool isHurried,
                                                  const std::function<std::optional<PicturePatch>()>& find) {
    const std::span<const std::uint64_t> moments = d->picture.moments();
    Private::Asked asked{.key = RefinedKey(parts),
                         .settled = {},
                         .moments = {moments.begin(), moments.end()},
                         .rough = d->picture.rough(),
                         .shadowMargin = d->picture.shadowMargin(),
                         .isHurried = isHurried};
    for (const DrawItem& item : parts.items) {
        asked.settled.push_back(item.settled);
    }
    if (d->asked != asked) {
        d->patch = find();
        d->asked = std::move(asked);
    }
    return d->patch;
}

bool RefinedView::has(const FrameParts& parts, bool inFull) const {
    const bool isEnough = hasPicture() && (isWhole() || !inFull);
    return isEnough && d->key == RefinedKey(parts);
}

void RefinedView::keptShown(bool isMoving) {
    m_shown = !isMoving;
    m_patched = !m_shown;
}

void RefinedView::plainShown() {
    m_shown = false;
    m_patched = true;
}

void RefinedView::patched(const FrameParts& parts) {
    d->key.emplace(parts);
    m_shown = false;
    m_patched = true;
}

void RefinedView::follow(const FrameParts& parts, bool isSideBySide) {
    std::optional<RefinedKey> key;
    if (!isSideBySide) {
        key.emplace(parts);
    }
    if (key == d->key) {
        return;
    }
    m_restarts += samples() > 0 ? 1 : 0;
    d->picture.clear();
    d->key = std::move(key);
}

bool RefinedView::show(const FrameParts& parts, bool isSideBySide, bool anythingIsBetter) {
    m_patched = false;
    follow(parts, isSideBySide);
    m_shown = samples() >= kFewestShown || (anythingIsBetter && hasPicture());
    return m_shown;
}

}  // namespace hitscope
