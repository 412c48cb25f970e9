// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/ids.h"
#include "physics/physics_world.h"
#include "session/mesh_steps/mesh_step.h"
#include "session/prepared_mesh.h"
#include "session/target_source.h"

namespace hitscope {

/// A target apart from its hits: enough to make it anew. Cheap to copy, since all that is large is shared.
struct TargetState {
    TargetId id;
    QString name;
    RigidTransform transform;
    bool visible = true;                   ///< hidden, it is neither drawn nor hit; its hits stay
    QString sourcePath;                    ///< the file it came from; empty: made by us
    TargetSource source;                   ///< what its mesh can be made from again
    MeshSteps steps;                       ///< that made `shape` of it
    std::vector<LocatedTexture> textures;  ///< pictures of its mesh that are not where the file says
    TargetPhysics physics;                 ///< whether it stays where it is put
    PreparedMesh shape;
    std::shared_ptr<const Collider> collider;
};

/// Where a dynamic target is.
struct TargetPlace {
    TargetId id;
    RigidTransform transform;
};

/// One change of a session's targets: the one at `index` was `before` and became `after`. Without `before` it
/// was added there, without `after` it was removed from there; its inverse is the same with both exchanged.
struct TargetEdit {
    std::size_t index = 0;
    std::optional<TargetState> before;
    std::optional<TargetState> after;
};

}  // namespace hitscope
