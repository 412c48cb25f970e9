// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/normal_plan.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/finite.h"
#include "io/welder.h"
#include "mesh/same_bits.h"

namespace hitscope {
namespace {

/// Vertices whose normals may have changed: those of faces of which a vertex moved.
std::vector<std::uint8_t> touchedVertices(const MeshData& mesh, std::span<const glm::vec3> positions) {
    std::vector<std::uint8_t> moved(positions.size());
    bool any = false;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        if (!sameBits(positions[v], mesh.positions[v])) {
            moved[v] = 1;
            any = true;
        }
    }
    if (!any) {
        return {};
    }
    std::vector<std::uint8_t> touched(positions.size());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        std::uint8_t isTouched = 0;
        for (const std::uint32_t vertex : mesh.face(f)) {
            isTouched |= moved[vertex];
        }
        if (isTouched != 0) {
            for (const std::uint32_t vertex : mesh.face(f)) {
                touched[vertex] = 1;
            }
        }
    }
    return touched;
}

class Planner {
public:
    Planner(const MeshData& mesh, const CornerNormalView& normals) : m_mesh(mesh), m_normals(normals) {}

    NormalPlan plan(const std::vector<std::uint8_t>& touched, bool all);

private:
    [[nodiscard]] std::uint32_t inFile(std::size_t corner) const {
        return m_mesh.cornerNormals.empty() ? kNoIndex : m_mesh.cornerNormals[corner];
    }
    void findWanted(const std::vector<std::uint8_t>& touched);
    void findDisagreement();
    void add(std::size_t corner, Welder& added);

    const MeshData& m_mesh;
    const CornerNormalView& m_normals;
    std::vector<std::uint32_t> m_wantedBy;  // for each of the file's normals, the first corner to change it
    std::vector<bool> m_isShared;           // its corners want different ones
    bool m_isAnyShared = false;
    NormalPlan m_plan;
};

void Planner::findWanted(const std::vector<std::uint8_t>& touched) {
    for (std::size_t c = 0; c < m_mesh.cornerVertices.size(); ++c) {
        if (touched[m_mesh.cornerVertices[c]] == 0) {
            continue;
        }
        const std::uint32_t normal = inFile(c);
        if (normal != kNoIndex && m_wantedBy[normal] == kNoIndex &&
            !isSameDirection(m_mesh.normals[normal], m_normals[c])) {
            m_wantedBy[normal] = static_cast<std::uint32_t>(c);
        }
    }
}

void Planner::findDisagreement() {
    for (std::size_t c = 0; c < m_mesh.cornerVertices.size(); ++c) {
        const std::uint32_t normal = inFile(c);
        if (normal != kNoIndex && m_wantedBy[normal] != kNoIndex &&
            !sameBits(m_normals[c], m_normals[m_wantedBy[normal]])) {
            m_isShared[normal] = true;
            m_isAnyShared = true;
        }
    }
}

void Planner::add(std::size_t corner, Welder& added) {
    const glm::vec3& normal = m_normals[corner];
    m_plan.corners.push_back(static_cast<std::uint32_t>(corner));
    m_plan.cornerNormals.push_back(static_cast<std::uint32_t>(m_mesh.normals.size()) +
                                   added.index(isFinite(normal) ? normal : glm::vec3(0.0f)));
}

NormalPlan Planner::plan(const std::vector<std::uint8_t>& touched, bool all) {
    m_wantedBy.assign(m_mesh.normals.size(), kNoIndex);
    m_isShared.assign(m_mesh.normals.size(), false);
    if (!touched.empty()) {
        findWanted(touched);
        findDisagreement();
    }
    for (std::size_t n = 0; n < m_wantedBy.size(); ++n) {
        if (m_wantedBy[n] != kNoIndex && !m_isShared[n]) {
            const glm::vec3& value = m_normals[m_wantedBy[n]];
            m_plan.replaced.push_back(static_cast<std::uint32_t>(n));
            m_plan.values.push_back(isFinite(value) ? value : glm::vec3(0.0f));
        }
    }
    Welder added(m_plan.added);
    for (std::size_t c = 0; c < m_mesh.cornerVertices.size(); ++c) {
        const std::uint32_t normal = inFile(c);
        const bool isSplit = normal != kNoIndex && m_isShared[normal] && touched[m_mesh.cornerVertices[c]] &&
                             !isSameDirection(m_mesh.normals[normal], m_normals[c]);
        if (isSplit || (all && normal == kNoIndex)) {
            add(c, added);
        }
    }
    return std::move(m_plan);
}

}  // namespace

bool isSameDirection(const glm::vec3& original, const glm::vec3& now) {
    constexpr float kRounding = 1e-6f;
    if (sameBits(original, now)) {
        return true;
    }
    const float length = glm::length(original);
    if (!(length > 0.0f) || !std::isfinite(length)) {
        return false;
    }
    const glm::vec3 gap = glm::abs(original / length - now);
    return gap.x <= kRounding && gap.y <= kRounding && gap.z <= kRounding;
}

NormalPlan planNormals(const MeshData& mesh, std::span<const glm::vec3> positions,
                       const CornerNormalView& normals, bool all) {
    const bool concerns = !normals.empty() && (all || !mesh.cornerNormals.empty());
    return concerns ? Planner(mesh, normals).plan(touchedVertices(mesh, positions), all) : NormalPlan();
}

}  // namespace hitscope
