// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deform/deformed_mesh.h"
#include "mesh/true_normals.h"
#include "session/target_plan.h"
#include "session/target_state.h"

namespace hitscope {

/// A mesh in the scene that can be hit, and what hits have made of it.
struct Target : TargetState {
    explicit Target(TargetState state);

    DeformedMesh deformed;
    TrueNormals trueNormals;

    [[nodiscard]] float extent() const { return m_extent; }  ///< of the original: its largest, metres
    [[nodiscard]] Bounds worldBounds() const;                ///< of the original shape

private:
    float m_extent = 0.0f;
};

}  // namespace hitscope
