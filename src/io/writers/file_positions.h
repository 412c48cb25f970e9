// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/writers/file_coordinate.h"
#include "io/writers/mesh_export.h"
#include "mesh/same_bits.h"

namespace hitscope {

/// The coordinates of an export in its file's frame.
class FilePositions {
public:
    /// `what` outlives this.
    explicit FilePositions(const MeshExport& what) : FilePositions(*what.mesh, what.positions) {}
    /// `now`: deformed, local frame, one a vertex. Both outlive this.
    FilePositions(const MeshData& mesh, std::span<const glm::vec3> now) : m_mesh(mesh), m_now(now) {}

    [[nodiscard]] bool isMoved(std::size_t v) const { return !sameBits(m_now[v], m_mesh.positions[v]); }
    [[nodiscard]] glm::dvec3 original(std::size_t v) const {
        return m_mesh.filePositions.empty() ? m_mesh.placement.toFile(m_mesh.positions[v])
                                            : m_mesh.filePositions[v];
    }
    [[nodiscard]] glm::dvec3 now(std::size_t v) const {
        return {fileCoordinate(m_mesh, v, m_now[v], 0), fileCoordinate(m_mesh, v, m_now[v], 1),
                fileCoordinate(m_mesh, v, m_now[v], 2)};
    }
    [[nodiscard]] glm::dvec3 displacement(std::size_t v) const {
        return (glm::dvec3(m_now[v]) - glm::dvec3(m_mesh.positions[v])) / m_mesh.placement.scale;
    }
    [[nodiscard]] glm::dvec3 toFile(const glm::vec3& local) const {
        const Placement& placement = m_mesh.placement;
        return placement.isIdentity() ? glm::dvec3(local) : placement.toFile(local);
    }
    /// Floats hold the original's coordinates.
    [[nodiscard]] bool fitFloats() const {
        for (const glm::dvec3& position : m_mesh.filePositions) {
            if (glm::dvec3(glm::vec3(position)) != position) {
                return false;
            }
        }
        return !m_mesh.filePositions.empty() || m_mesh.placement.isIdentity();
    }
    /// And those of what moved: far from the file's origin a dent is less than a float's last digit.
    [[nodiscard]] bool fitFloatsMoved() const { return m_mesh.placement.isIdentity() && fitFloats(); }

private:
    const MeshData& m_mesh;
    std::span<const glm::vec3> m_now;
};

}  // namespace hitscope
