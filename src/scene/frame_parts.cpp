// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/frame_parts.h"

#include "analysis/change_values.h"
#include "deform/dent_shape.h"
#include "scene/scene_gpu_private.h"

namespace hitscope {

std::unique_ptr<FrameParts> SceneGpu::Private::frameOf(const View& view) {
    auto parts = std::make_unique<FrameParts>();
    parts->items = drawItems();
    for (DrawItem& item : parts->items) {
        item.selected = item.selected && view.selectionMarks;
    }
    parts->projectiles.reserve(session.simulation().physics().projectileCount());
    for (const ProjectileState& projectile : session.simulation().physics().projectiles()) {
        parts->projectiles.push_back(
            {{projectile.drawn, projectile.radius}, projectile.colour, projectile.trail});
    }
    Frame& frame = parts->frame;
    frame.width = view.width;
    frame.height = view.height;
    frame.pixelRatio = view.pixelRatio;
    frame.camera = view.camera;
    frame.lights = session.settings().lights();
    frame.options = view.options;
    frame.meshRevision = meshRevision;
    frame.floorHeight = session.targets().floorHeight();
    frame.targets = parts->items;
    frame.coarse = view.detail.coarse;
    if (view.options.change.on) {
        frame.change =
            shownChange(view.options.change, view.changeValues ? view.changeValues->summary() : Summary());
        changeUpload.follow(view.changeValues);
        for (const DrawItem& item : parts->items) {
            if (changeUpload.upload(item.target, *targets.at(item.target).buffers)) {
                ++dataRevision;
            }
        }
    }
    marks.follow(session);
    parts->marks = view.selectionMarks ? marks.on(parts->items) : std::vector<VertexMarks>();
    frame.marks = parts->marks;
    frame.projectiles = parts->projectiles;
    frame.projectilesFly = view.projectilesFly;
    frame.ghost = view.ghost;
    frame.section = view.section;
    frame.showsCutPlane = view.showsCutPlane;
    if (view.selectionMarks && session.hits().selected()) {
        const Hit& hit = session.hits().history().hits()[*session.hits().selected()];
        if (const Target* target = session.targets().find(hit.target)) {
            const HitReach reach = reachOf(hit);
            frame.highlightedHit = Sphere{target->transform.toWorld(reach.centre),
                                          hit.form.presses() ? hit.form.radius : reach.radius};
        }
    }
    parts->dataRevision = dataRevision;
    parts->normalsRevision = normalsRevision;
    return parts;
}

}  // namespace hitscope
