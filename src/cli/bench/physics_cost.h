// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "cli/bench/bench_room.h"
#include "session/prepared_mesh.h"

namespace hitscope::bench {

/// Projectiles alive at once in all that is measured here.
inline constexpr int kProjectiles = 2000;
/// Vertices that a hit moves, about.
inline constexpr double kDentVertices = 80.0;

/// A sphere of about so many triangles, ready to be hit; makes the mesh, which takes a while for millions.
[[nodiscard]] PreparedMesh physicsSphere(int triangles);

/// Seconds.
struct PhysicsFigure {
    qulonglong triangles = 0;
    Samples flying;        ///< a physics step with all projectiles in flight beside the target
    Samples striking;      ///< a step in which all of them strike it
    Samples dented;        ///< a static target's collider takes on a hit
    Samples dentedMoving;  ///< likewise a dynamic target's, which has a hull as well, and the step after it
};

/// Measured together, in the order of `meshes`. The error says what went wrong.
[[nodiscard]] Result<std::vector<PhysicsFigure>> measurePhysics(const BenchRoom& room,
                                                                const std::vector<PreparedMesh>& meshes,
                                                                const Plan& plan);
/// Only `dented` and `dentedMoving`.
[[nodiscard]] Result<std::vector<PhysicsFigure>> measureColliders(const BenchRoom& room,
                                                                  const std::vector<PreparedMesh>& meshes,
                                                                  const Plan& plan);

/// A frame of the paper's second row, and with all projectiles in it, with trails: seconds, in this
/// order.
[[nodiscard]] Result<std::vector<Samples>> measureProjectileDrawing(const BenchRoom& room, const Plan& plan);

}  // namespace hitscope::bench
