// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/normal_plan.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/finite.h"
#include "core/parallel.h"
#include "io/welder.h"
#include "mesh/same_bits.h"

namespace hitscope {
namespace {

constexpr std::size_t kLeastPart = 1 << 17;  // of a loop over vertices, faces or corners

/// Calls collect(first, end, list) for parts of [0, count) at once and returns the lists one after the other.
template <class Collect>
std::vector<std::uint32_t> collectInParts(std::size_t count, const Collect& collect) {
    const std::size_t parts = std::clamp<std::size_t>(count / kLeastPart, 1, usefulThreads());
    std::vector<std::vector<std::uint32_t>> lists(parts);
    forEachAtOnce(parts, [&](std::size_t part) {
        collect(count * part / parts, count * (part + 1) / parts, lists[part]);
    });
    std::vector<std::uint32_t> all = std::move(lists[0]);
    for (std::size_t part = 1; part < parts; ++part) {
        all.insert(all.end(), lists[part].begin(), lists[part].end());
    }
    return all;
}

/// Corners whose normals may have changed, rising: those at the vertices of faces of which a vertex moved.
std::vector<std::uint32_t> touchedCorners(const MeshData& mesh, std::span<const glm::vec3> positions) {
    std::vector<std::uint8_t> moved(positions.size());
    std::atomic<bool> any = false;
    inParts(positions.size(), kLeastPart, [&](std::size_t first, std::size_t end) {
        for (std::size_t v = first; v < end; ++v) {
            if (!sameBits(positions[v], mesh.positions[v])) {
                moved[v] = 1;
                any.store(true, std::memory_order_relaxed);
            }
        }
    });
    if (!any) {
        return {};
    }
    std::vector<std::uint8_t> touched(positions.size());
    inParts(mesh.faceCount(), kLeastPart, [&](std::size_t first, std::size_t end) {
        for (std::size_t f = first; f < end; ++f) {
            std::uint8_t isTouched = 0;
            for (const std::uint32_t vertex : mesh.face(f)) {
                isTouched |= moved[vertex];
            }
            if (isTouched != 0) {
                for (const std::uint32_t vertex : mesh.face(f)) {
                    // Faces of another part may have the same vertex.
                    std::atomic_ref(touched[vertex]).store(1, std::memory_order_relaxed);
                }
            }
        }
    });
    return collectInParts(mesh.cornerVertices.size(),
                          [&](std::size_t first, std::size_t end, std::vector<std::uint32_t>& list) {
                              for (std::size_t c = first; c < end; ++c) {
                                  if (touched[mesh.cornerVertices[c]] != 0) {
                                      list.push_back(static_cast<std::uint32_t>(c));
                                  }
                              }
                          });
}

class Planner {
public:
    Planner(const MeshData& mesh, const CornerNormalView& normals) : m_mesh(mesh), m_normals(normals) {}

    NormalPlan plan(const std::vector<std::uint32_t>& touched, bool all);

private:
    [[nodiscard]] std::uint32_t inFile(std::size_t corner) const {
        return m_mesh.cornerNormals.empty() ? kNoIndex : m_mesh.cornerNormals[corner];
    }
    /// Whether any of the file's normals is to change.
    bool findWanted(const std::vector<std::uint32_t>& touched);
    void findDisagreement();
    void add(std::size_t corner, Welder& added);

    const MeshData& m_mesh;
    const CornerNormalView& m_normals;
    std::vector<std::uint32_t> m_wantedBy;  // for each of the file's normals, the first corner to change it
    std::vector<bool> m_isShared;           // its corners want different ones
    NormalPlan m_plan;
};

bool Planner::findWanted(const std::vector<std::uint32_t>& touched) {
    bool any = false;
    for (const std::uint32_t c : touched) {
        const std::uint32_t normal = inFile(c);
        if (normal != kNoIndex && m_wantedBy[normal] == kNoIndex &&
            !isSameDirection(m_mesh.normals[normal], m_normals[c])) {
            m_wantedBy[normal] = c;
            any = true;
        }
    }
    return any;
}

void Planner::findDisagreement() {
    const std::vector<std::uint32_t> shared =
        collectInParts(m_mesh.cornerNormals.size(),
                       [this](std::size_t first, std::size_t end, std::vector<std::uint32_t>& list) {
                           for (std::size_t c = first; c < end; ++c) {
                               const std::uint32_t normal = inFile(c);
                               if (normal != kNoIndex && m_wantedBy[normal] != kNoIndex &&
                                   !sameBits(m_normals[c], m_normals[m_wantedBy[normal]])) {
                                   list.push_back(normal);
                               }
                           }
                       });
    for (const std::uint32_t normal : shared) {
        m_isShared[normal] = true;
    }
}

void Planner::add(std::size_t corner, Welder& added) {
    const glm::vec3& normal = m_normals[corner];
    m_plan.corners.push_back(static_cast<std::uint32_t>(corner));
    m_plan.cornerNormals.push_back(static_cast<std::uint32_t>(m_mesh.normals.size()) +
                                   added.index(isFinite(normal) ? normal : glm::vec3(0.0f)));
}

NormalPlan Planner::plan(const std::vector<std::uint32_t>& touched, bool all) {
    m_wantedBy.assign(m_mesh.normals.size(), kNoIndex);
    m_isShared.assign(m_mesh.normals.size(), false);
    if (findWanted(touched)) {
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
    const auto isSplit = [this](std::uint32_t c) {
        const std::uint32_t normal = inFile(c);
        return normal != kNoIndex && m_isShared[normal] &&
               !isSameDirection(m_mesh.normals[normal], m_normals[c]);
    };
    if (!all) {
        for (const std::uint32_t c : touched) {
            if (isSplit(c)) {
                add(c, added);
            }
        }
        return std::move(m_plan);
    }
    auto next = touched.begin();
    for (std::uint32_t c = 0; c < m_mesh.cornerVertices.size(); ++c) {
        const bool isTouched = next != touched.end() && *next == c;
        next += isTouched ? 1 : 0;
        if (inFile(c) == kNoIndex || (isTouched && isSplit(c))) {
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
    return concerns ? Planner(mesh, normals).plan(touchedCorners(mesh, positions), all) : NormalPlan();
}

}  // namespace hitscope
