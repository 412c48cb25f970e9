// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measured_target.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <utility>

#include "core/memory.h"
#include "deform/deform.h"
#include "mesh/surface/connectivity.h"
#include "mesh/surface/face_measure.h"

namespace hitscope {

namespace {

constexpr std::size_t kLarge = 100'000;  // vertices of a mesh whose measuring takes much memory for a while

/// One face's corners, taken through hits on their own: vertices do not influence one another.
class LoneFace {
public:
    LoneFace(const MeshData& mesh, std::uint32_t face) : m_corners(mesh.face(face).size()) {
        for (const std::uint32_t vertex : mesh.face(face)) {
            m_originals.push_back(mesh.positions[vertex]);
        }
        std::iota(m_corners.begin(), m_corners.end(), 0u);
        m_positions = m_originals;
    }

    /// Returns whether the hit moved a corner.
    bool apply(const Hit& hit) {
        bool isMoved = false;
        const DentShape dent = dentShapeOf(hit);
        for (glm::vec3& position : m_positions) {
            glm::vec3 normal(0.0f, 0.0f, 1.0f);  // has no part in where the vertex goes
            isMoved = deform(position, normal, dent) || isMoved;
        }
        return isMoved;
    }

    [[nodiscard]] bool is(FaceHarm::Kind kind, float stretchLimit) const {
        switch (kind) {
            case FaceHarm::Kind::Flipped:
                return isFlipped(m_corners, m_originals, m_positions);
            case FaceHarm::Kind::Degenerated:
                return FaceMeasurer(m_originals)
                    .measure(m_positions, m_corners, glm::dvec3(m_positions[0]))
                    .isDegenerate;
            case FaceHarm::Kind::Stretched:
                return stretchOf(m_corners, m_originals, m_positions) > stretchLimit;
        }
        return false;
    }

private:
    std::vector<std::uint32_t> m_corners;
    std::vector<glm::vec3> m_originals;
    std::vector<glm::vec3> m_positions;
};

/// Positive volume, whichever way the faces look.
SurfaceMeasures outwards(SurfaceMeasures measures) {
    if (measures.signedVolume < 0.0) {
        measures.signedVolume = -measures.signedVolume;
        measures.volumeMoment = -measures.volumeMoment;
    }
    return measures;
}

}  // namespace

std::optional<std::size_t> causeOf(const FaceHarm& harm, float stretchLimit, TargetId target,
                                   const MeshData& mesh, std::span<const Hit> history) {
    LoneFace face(mesh, harm.face);
    std::optional<std::size_t> cause;
    for (std::size_t i = 0; i < history.size(); ++i) {
        const Hit& hit = history[i];
        if (hit.target != target || !hit.enabled || !face.apply(hit)) {
            continue;
        }
        if (!face.is(harm.kind, stretchLimit)) {
            cause.reset();
        } else if (!cause) {
            cause = i;
        }
    }
    return cause;
}

void MeasuredTarget::follow(std::span<const MovedVertex> moved, const std::stop_token& stop) {
    if (!m_topology) {
        m_topology = SurfaceTopology::build(*m_mesh, stop);
        if (!m_topology) {
            return;
        }
        m_refusedFaces = refusedFaces(*m_mesh, *m_topology);
    }
    if (!m_measurer) {
        auto measurer = std::make_unique<SurfaceMeasurer>(m_mesh, m_topology, stop);
        if (stop.stop_requested()) {
            return;
        }
        m_measurer = std::move(measurer);
        if (m_mesh->vertexCount() > kLarge) {
            giveBackFreedMemory();
        }
        m_deformed = m_measurer->original();
        m_displacements = std::make_shared<const Displacements>();
    }
    if (!moved.empty()) {
        m_measurer->move(moved);
        m_deformed = m_measurer->measures();
        m_displacements = std::make_shared<const Displacements>(m_measurer->displacements());
    }
}

void MeasuredTarget::findHarms(float stretchLimit, std::span<const Hit> history,
                               const std::stop_token& stop) {
    const std::vector<FaceHarm> harms =
        m_measurer->harms(stretchLimit, MeshMeasurement::kMostHarms, m_harmsFound);
    m_harms.clear();
    for (const FaceHarm& harm : harms) {
        if (stop.stop_requested()) {
            return;
        }
        m_harms.push_back({m_id, harm, causeOf(harm, stretchLimit, m_id, *m_mesh, history)});
    }
}

void MeasuredTarget::addTo(MeshMeasurement& sum, const RigidTransform& transform, bool alone) const {
    sum.targets.push_back(m_id);
    sum.topology.add(m_topology->statistics());
    sum.refusedFaces += m_refusedFaces;
    sum.displacements.emplace_back(m_id, m_displacements);
    sum.harmsFound += m_harmsFound;
    for (const HarmRow& harm : m_harms) {
        if (sum.harms.size() < MeshMeasurement::kMostHarms) {
            sum.harms.push_back(harm);
        }
    }
    SurfaceMeasures original = outwards(m_measurer->original());
    SurfaceMeasures deformed = outwards(m_deformed);
    if (!alone) {
        const glm::dmat3 rotation(glm::mat3_cast(glm::dquat(transform.rotation)));
        const glm::dvec3 shift(transform.position);
        const auto place = [&](SurfaceMeasures& measures) {
            measures.volumeMoment = rotation * measures.volumeMoment + measures.signedVolume * shift;
        };
        place(original);
        place(deformed);
        original.box = m_measurer->originalBoxThrough(rotation, shift);
        deformed.box = m_measurer->boxThrough(rotation, shift);
    }
    sum.original.add(original);
    sum.deformed.add(deformed);
}

MeshMeasurement measure(std::shared_ptr<const MeshData> mesh) {
    MeasuredTarget target({}, std::move(mesh));
    target.follow({}, {});
    MeshMeasurement measurement;
    target.addTo(measurement, {}, true);
    conclude(measurement);
    return measurement;
}

void conclude(MeshMeasurement& measurement) {
    std::vector<const Displacements*> lists;
    for (const auto& entry : measurement.displacements) {
        lists.push_back(entry.second.get());
    }
    measurement.displacement = summarise(lists);
    const Spread& length = measurement.displacement.length;
    measurement.histogram =
        histogramOf(lists, length.count > 0 ? length.greatest : 0.0, MeshMeasurement::kBins);
}

}  // namespace hitscope
