// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/histogram.h"
#include "core/ids.h"
#include "deform/hit.h"
#include "mesh/surface/surface_measurer.h"
#include "physics/physics_world.h"

namespace hitscope {

/// A face that hits have harmed, and which of them did.
struct HarmRow {
    TargetId target;
    FaceHarm harm;
    std::optional<std::size_t> hit;  ///< row of the history; nothing: not known
    bool operator==(const HarmRow&) const = default;
};

/// What one target, or all of them together, measure: original and as they are.
struct MeshMeasurement {
    std::vector<TargetId> targets;  ///< whose these numbers are
    SurfaceStatistics topology;
    std::size_t refusedFaces = 0;  ///< that half-edges cannot hold (connect())
    /// Of one target: local frame. Of all: world, and volumes are positive whichever way the faces look.
    SurfaceMeasures original;
    SurfaceMeasures deformed;
    Displacements::Summary displacement;
    Histogram histogram;  ///< of the changed vertices, over [0, greatest displacement]
    std::vector<std::pair<TargetId, std::shared_ptr<const Displacements>>> displacements;
    std::vector<HarmRow> harms;  ///< at most kMostHarms of them
    std::size_t harmsFound = 0;

    static constexpr std::size_t kMostHarms = 500;
    static constexpr std::size_t kBins = 48;
};

/// One target as the measuring thread knows it: its own copy of the positions. Used by one thread at a time.
class MeasuredTarget {
public:
    MeasuredTarget(TargetId id, std::shared_ptr<const MeshData> mesh) : m_id(id), m_mesh(std::move(mesh)) {}

    /// Takes over where vertices have moved to, and measures; nothing is left half done once `stop` is
    /// requested, but not everything is done.
    void follow(std::span<const MovedVertex> moved, const std::stop_token& stop);
    [[nodiscard]] bool isReady() const { return m_measurer != nullptr; }
    /// Finds harmed faces and what hit did it. `history`: the hits of the session in order, those
    /// disabled that are not applied to what is shown.
    void findHarms(float stretchLimit, std::span<const Hit> history, const std::stop_token& stop);

    /// Counts this target in. `alone`: in its own frame, without the transform.
    void addTo(MeshMeasurement& sum, const RigidTransform& transform, bool alone) const;

private:
    TargetId m_id;
    std::shared_ptr<const MeshData> m_mesh;
    std::shared_ptr<const SurfaceTopology> m_topology;
    std::size_t m_refusedFaces = 0;
    std::unique_ptr<SurfaceMeasurer> m_measurer;
    SurfaceMeasures m_deformed;
    std::shared_ptr<const Displacements> m_displacements;
    std::vector<HarmRow> m_harms;
    std::size_t m_harmsFound = 0;
};

/// What a mesh measures that no hit has changed: what the mesh statistics show of it, and `hitscope-cli
/// info`.
[[nodiscard]] MeshMeasurement measure(std::shared_ptr<const MeshData> mesh);

/// Summary and histogram over what was added.
void conclude(MeshMeasurement& measurement);

/// The last hit on `target` that brought the face into this state and left it there; nothing where no hit of
/// the history explains it. `history` as above; takes time in proportion to it.
[[nodiscard]] std::optional<std::size_t> causeOf(const FaceHarm& harm, float stretchLimit, TargetId target,
                                                 const MeshData& mesh, std::span<const Hit> history);

}  // namespace hitscope
