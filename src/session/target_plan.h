// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/bounds.h"
#include "physics/physics_world.h"
#include "session/prepared_mesh.h"
#include "session/target_source.h"
#include "session/target_state.h"

namespace hitscope {

/// A target to be: what it is called, its shape, where it stands and how it collides. Has all that takes time
/// to work out, so that it may be made on any thread.
struct TargetPlan {
    QString name;
    PreparedMesh shape;
    RigidTransform transform;
    Collider collider;
    QString sourcePath = {};                    ///< the file it comes from; empty: made by us
    TargetSource source = {};                   ///< what its mesh can be made from again
    MeshSteps steps = {};                       ///< that made `shape` of it
    std::vector<LocatedTexture> textures = {};  ///< that are not where the mesh file says
};

/// A scene to be.
struct ScenePlan {
    QString name;  ///< for the window's title
    std::vector<TargetPlan> targets;
    std::optional<float> floorHeight = {};  ///< metres, world y; nothing: floorUnder() the lowest target
};

/// A file as it is now. Reads all of it: on any thread. What cannot be read has no size and no hash.
[[nodiscard]] MeshFile meshFileAt(const QString& path);

/// A target at the mesh's own coordinates, which collides with its triangles. `mesh` has passed validate().
[[nodiscard]] TargetPlan planMesh(MeshData mesh, const QString& sourcePath = {});
[[nodiscard]] TargetPlan planMesh(const PreparedMesh& mesh, const QString& sourcePath = {});
/// Likewise, of something that is known, to which the steps were done.
[[nodiscard]] TargetPlan planMesh(const PreparedMesh& mesh, const TargetSource& source, MeshSteps steps = {});

/// The target that is to have that id.
[[nodiscard]] TargetState stateOf(TargetPlan plan, TargetId id);

/// Of the original shape, world. Empty for a mesh without vertices.
[[nodiscard]] Bounds worldBounds(const RenderMesh& mesh, const RigidTransform& transform);

/// How high a floor is that such a target (world) stands on, metres; one as flat as a sheet or a tile hovers
/// over it, as high as a quarter of its width: else the floor would hide its dents, and be in the way of
/// shots into them.
[[nodiscard]] float floorUnder(const Bounds& target);

/// Puts a plan on the scene's floor, at that height (metres), and where the scene is (world, not empty) if it
/// is farther from that than both are large together: a shape of our own has no place that matters.
void bringNear(TargetPlan& plan, const Bounds& scene, float floor);

/// Moves each plan along x past what it would overlap, the ones before it and `taken` (world), leaving a gap;
/// and, if `floor` is given, up until the floor at that height (metres) is no higher than floorUnder() it.
/// Plans that are clear stay.
void makeRoom(std::vector<TargetPlan>& plans, std::vector<Bounds> taken, std::optional<float> floor = {});

}  // namespace hitscope
