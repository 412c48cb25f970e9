// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/refined/moved_area.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "render/refined/refined_picture.h"
#include "render/refined/varying_area.h"
#include "render/seen/seen_area.h"
#include "render/seen/visible_runs.h"
#include "render/shadow_map.h"

namespace hitscope::render {

namespace {

constexpr float kLineReach = 4.0f;        // logical pixels that lines are wide, and more
constexpr std::size_t kMostBoxes = 2048;  // that are looked at one by one: some milliseconds
/// Pixels: how far the light at the floor is smoothed.
constexpr int kFloorOpenReach = 2 * RefinedPicture::kFloorOpenStep + 2;

/// Whether anything but surfaces, their edges and shadows depends on where vertices are, or surfaces are
/// drawn elsewhere.
bool mayChangeElsewhere(const Frame& frame) {
    const DisplayOptions& options = frame.options;
    return frame.coarse || frame.change || frame.section != nullptr || options.cut.on || options.needles ||
           options.dots || options.transparent || options.wireframe == WireframeMode::Only ||
           options.beforeAfter.wipe || options.beforeAfter.ghost != GhostMode::Off ||
           options.beforeAfter.exaggeration != 1.0f;
}

bool meet(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.min, b.max)) && glm::all(glm::lessThanEqual(b.min, a.max));
}

Bounds around(std::span<const Bounds> boxes) {
    Bounds all;
    for (const Bounds& box : boxes) {
        all.add(box);
    }
    return all;
}

/// Of triangles with a corner in the place.
Bounds trianglesAt(const Bounds& place, const DrawItem& item, const ClusterRuns::Run& run) {
    constexpr std::uint32_t kCorners = 3;
    const std::span<const std::uint32_t> indices = item.buffers->triangles();
    Bounds found;
    for (std::uint32_t i = run.first; i + kCorners <= run.end; i += kCorners) {
        Bounds triangle;
        bool isThere = false;
        for (const std::uint32_t vertex : indices.subspan(i, kCorners)) {
            const glm::vec3& corner = item.vertices[vertex].position;
            triangle.add(corner);
            isThere = isThere || meet({corner, corner}, place);
        }
        if (isThere) {
            found.add(triangle);
        }
    }
    return found;
}

/// Boxes of all triangles that have a corner in one of these places. Where clusters are few, they are large,
/// and their triangles are looked at; where places are many, all between them is one.
///
/// boxes: of these runs.
std::vector<Bounds> trianglesAt(std::span<const Bounds> places, const DrawItem& item,
                                std::span<const Bounds> boxes, const ClusterRuns& runs) {
    constexpr std::size_t kFew = 200;
    constexpr std::size_t kManyPlaces = 64;
    const Bounds all = around(places);
    std::vector<Bounds> found;
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Bounds& run = boxes[i];
        if (meet(run, all) && (places.size() >= kManyPlaces ||
                               std::any_of(places.begin(), places.end(),
                                           [&run](const Bounds& place) { return meet(run, place); }))) {
            found.push_back(run);
            there.push_back(i);
        }
    }
    const bool areTrianglesKnown = &runs == &item.buffers->triangleRuns();
    if (found.size() > kFew || !areTrianglesKnown || item.vertices.size() != item.buffers->vertexCount()) {
        return found;
    }
    found.clear();
    for (const std::size_t i : there) {
        if (const Bounds box = trianglesAt(all, item, runs.runs()[i]); !box.empty()) {
            found.push_back(box);
        }
    }
    return found;
}

/// A target's, as it is and was, in its own frame.
struct MovedBoxes {
    std::vector<Bounds> shape;  ///< of triangles with a moved corner
    std::vector<Bounds> looks;  ///< of all whose normals may change with it
};

std::optional<std::span<const Bounds>> placesMoved(const DrawItem& item, const DeformationPipeline& pipeline,
                                                   std::uint64_t moment) {
    const ClusterReach* reach = pipeline.reach(item.target);
    // Those that have moved since are in these places in item.vertices, too.
    return reach != nullptr ? reach->movedSince(std::min(moment, item.settled)) : std::nullopt;
}

/// Of the triangles that the frame draws.
const ClusterRuns& runsOf(const DrawItem& item, const Frame& frame) {
    const bool isCoarse = drawsOf(item, frame.coarse).data() != item.buffers->draws().data();
    return isCoarse ? item.buffers->coarseRuns() : item.buffers->triangleRuns();
}

std::optional<std::vector<Bounds>> runBoxesOf(const DrawItem& item, const Frame& frame,
                                              const DeformationPipeline& pipeline) {
    const std::optional<ClusterBoxes> boxes = clusterBoxesOf(item, frame, pipeline);
    const ClusterRuns& runs = runsOf(item, frame);
    if (!boxes || runs.runs().empty()) {
        return std::nullopt;
    }
    std::vector<Bounds> runBoxes;
    runBoxes.reserve(runs.runs().size());
    for (std::size_t i = 0; i < runs.runs().size(); ++i) {
        runBoxes.push_back(boxOf(*boxes, runs, i));
    }
    return runBoxes;
}

std::vector<Bounds> trianglesMoved(std::span<const Bounds> places, const DrawItem& item,
                                   std::span<const Bounds> boxes, const ClusterRuns& runs) {
    std::vector<Bounds> found = trianglesAt(places, item, boxes, runs);
    found.insert(found.end(), places.begin(), places.end());
    return found;
}

std::optional<MovedBoxes> movedBoxes(const DrawItem& item, const Frame& frame,
                                     const DeformationPipeline& pipeline, std::uint64_t moment) {
    const auto moved = placesMoved(item, pipeline, moment);
    if (!moved || moved->size() > kMostBoxes) {
        return std::nullopt;
    }
    MovedBoxes all;
    if (moved->empty()) {
        return all;
    }
    const std::optional<std::vector<Bounds>> boxes = runBoxesOf(item, frame, pipeline);
    if (!boxes) {
        return std::nullopt;
    }
    const ClusterRuns& runs = runsOf(item, frame);
    all.shape = trianglesMoved(*moved, item, *boxes, runs);
    all.looks = trianglesAt(all.shape, item, *boxes, runs);
    return all;
}

/// Where boxes of the world are seen in a picture, one by one.
class SeenParts {
public:
    SeenParts(const glm::mat4& toClip, const glm::ivec2& picture) : m_toClip(toClip), m_picture(picture) {}

    /// False: part of the box is behind the eye.
    bool add(const Bounds& box) { return addBetween(box, box, 0.0f, 0.0f); }
    /// All between one box and another, which takes more parts the longer the way is.
    bool addWay(const Bounds& from, const Bounds& to);

    [[nodiscard]] std::vector<PixelArea> take() { return std::move(m_parts); }

private:
    bool addBetween(const Bounds& from, const Bounds& to, float begin, float end);

    glm::mat4 m_toClip;
    glm::ivec2 m_picture;
    std::vector<PixelArea> m_parts;
};

bool SeenParts::addBetween(const Bounds& from, const Bounds& to, float begin, float end) {
    SeenArea seen(m_toClip);
    for (const float share : {begin, end}) {
        if (!seen.add({glm::mix(from.min, to.min, share), glm::mix(from.max, to.max, share)})) {
            return false;
        }
    }
    if (const PixelArea part = seen.in(m_picture); !part.empty()) {
        m_parts.push_back(part);
    }
    return true;
}

bool SeenParts::addWay(const Bounds& from, const Bounds& to) {
    constexpr int kMostSteps = 32;
    constexpr int kStep = 16;  // pixels
    SeenArea both(m_toClip);
    if (!both.add(from) || !both.add(to)) {
        return false;
    }
    const PixelArea all = both.in(m_picture);
    const int steps = std::clamp(std::max(all.width, all.height) / kStep, 1, kMostSteps);
    for (int step = 0; step < steps; ++step) {
        const auto share = [steps](int at) { return static_cast<float>(at) / static_cast<float>(steps); };
        if (!addBetween(from, to, share(step), share(step + 1))) {
            return false;
        }
    }
    return true;
}

template <class Seen>
bool addAll(Seen& seen, std::span<const Bounds> boxes, const DrawItem& item) {
    return std::all_of(boxes.begin(), boxes.end(),
                       [&](const Bounds& box) { return seen.add(inWorld(box, item)); });
}

/// The directional light: its radius, a metre away, and shadowTexel().
struct Caster {
    float lightRadius = 0.0f;
    float texel = 0.0f;
};

/// With all that they may shade, each of them.
bool addShadows(SeenParts& seen, std::span<const Bounds> casters, const DrawItem& item, const Frame& frame,
                const Caster& light) {
    constexpr std::size_t kMany = 1024;
    if (!ShadowMap::isWanted(frame)) {
        return true;
    }
    const auto add = [&](const Bounds& box) {
        const Bounds caster = grown(inWorld(box, item), kShadowTexels * light.texel);
        const std::optional<Bounds> shadow = floorShadowOf(caster, frame, light.lightRadius, light.texel);
        return shadow && seen.addWay(caster, *shadow);
    };
    return casters.size() > kMany ? add(around(casters)) : std::all_of(casters.begin(), casters.end(), add);
}

/// With all that it may shade.
bool addShadow(SeenArea& seen, std::span<const Bounds> casters, const DrawItem& item, const Frame& frame,
               const Caster& light) {
    if (!ShadowMap::isWanted(frame) || casters.empty()) {
        return true;
    }
    const Bounds caster = grown(inWorld(around(casters), item), kShadowTexels * light.texel);
    const std::optional<Bounds> shadow = floorShadowOf(caster, frame, light.lightRadius, light.texel);
    return shadow && seen.add(caster) && seen.add(*shadow);
}

/// Where it keeps light away from what is near, and where its soft shadows fall.
bool addRefined(SeenArea& seen, const MovedBoxes& moved, const DrawItem& item, const Frame& frame,
                float texel) {
    const float reach = occlusionReach(frame);
    return std::all_of(moved.shape.begin(), moved.shape.end(),
                       [&](const Bounds& box) { return seen.add(grown(inWorld(box, item), reach)); }) &&
           addAll(seen, moved.looks, item) && addShadow(seen, moved.shape, item, frame, {kLightSize, texel});
}

}  // namespace

std::vector<std::uint64_t> momentsOf(const Frame& frame) {
    std::vector<std::uint64_t> moments;
    for (const DrawItem& item : frame.targets) {
        moments.push_back(item.settled);
    }
    return moments;
}

std::optional<std::vector<Bounds>> movedTriangles(const DrawItem& item, const Frame& frame,
                                                  const DeformationPipeline& pipeline, std::uint64_t moment) {
    const auto moved = placesMoved(item, pipeline, moment);
    if (!moved || moved->empty()) {
        return moved ? std::optional(std::vector<Bounds>()) : std::nullopt;
    }
    const std::optional<std::vector<Bounds>> boxes = runBoxesOf(item, frame, pipeline);
    return boxes ? std::optional(trianglesMoved(*moved, item, *boxes, runsOf(item, frame))) : std::nullopt;
}

std::optional<MovedArea> movedArea(const FrameContext& context, const DeformationPipeline& pipeline,
                                   std::span<const std::uint64_t> moments) {
    const Frame& frame = context.frame;
    if (mayChangeElsewhere(frame) || moments.size() != frame.targets.size()) {
        return std::nullopt;
    }
    const glm::ivec2 picture(frame.width, frame.height);
    SeenParts seen(context.viewProjection, picture);
    SeenArea refined(context.viewProjection);
    bool isRefinedKnown = true;
    const float texel = ShadowMap::isWanted(frame) ? shadowTexel(frame, pipeline) : 0.0f;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const DrawItem& item = frame.targets[i];
        const std::optional<MovedBoxes> moved = movedBoxes(item, frame, pipeline, moments[i]);
        if (!moved || !addAll(seen, moved->shape, item) || !addAll(seen, moved->looks, item) ||
            !addShadows(seen, moved->shape, item, frame, {0.0f, texel})) {
            return std::nullopt;
        }
        isRefinedKnown = isRefinedKnown && addRefined(refined, *moved, item, frame, texel);
    }
    MovedArea area{seen.take(), std::nullopt};
    if (isRefinedKnown) {
        const PixelArea moved = refined.in(picture);
        area.refined = moved.empty() ? moved : widened(moved, kFloorOpenReach);
    }
    return area;
}

PictureWindow windowAround(const PixelArea& area, const Frame& frame) {
    const float lines = frame.options.wireframe == WireframeMode::Off ? 0.0f : kLineReach * frame.pixelRatio;
    const int reach = static_cast<int>(std::ceil(lines)) + 1;  // samples are off by half a pixel
    return windowOf({area.x - reach, area.y - reach, area.width + 2 * reach, area.height + 2 * reach},
                    {frame.width, frame.height});
}

std::size_t trianglesOf(const Frame& frame) {
    std::size_t indices = 0;
    for (const DrawItem& item : frame.targets) {
        indices += item.buffers->triangleIndexCount();
    }
    return indices / 3;
}

std::size_t trianglesWithin(const FrameContext& context, const DeformationPipeline& pipeline,
                            const glm::mat4& viewProjection, const PictureWindow& window,
                            const TilesOfPicture& tiles) {
    std::size_t triangles = 0;
    for (const DrawItem& item : context.frame.targets) {
        const std::uint32_t all = item.buffers->triangleIndexCount();
        Sight sight(viewProjection * item.model, window);
        sight.limitTo(tiles);
        const auto seen =
            visibleRuns(item, context.frame, pipeline, sight, item.buffers->triangleRuns(), {0, all});
        triangles += (seen ? countOf(*seen) : all) / 3;
    }
    return triangles;
}

}  // namespace hitscope::render
