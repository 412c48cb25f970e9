// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/true_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <system_error>
#include <thread>
#include <tuple>

#include "mesh/triangulate.h"

namespace hitscope {
namespace {

auto key(const glm::vec3& v) {
    return std::tuple(v.x, v.y, v.z);
}

/// Any unit vector at right angles to the unit vector v, the same one each time.
glm::dvec3 perpendicularTo(const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    glm::dvec3 axis(0.0, 0.0, 1.0);
    if (size.x <= size.y && size.x <= size.z) {
        axis = {1.0, 0.0, 0.0};
    } else if (size.y <= size.z) {
        axis = {0.0, 1.0, 0.0};
    }
    return glm::normalize(glm::cross(v, axis));
}

/// v turned by the shortest rotation that takes the unit vector `from` to the unit vector `to`.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& from, const glm::dvec3& to) {
    const double cosine = glm::dot(from, to);
    const glm::dvec3 axis = glm::cross(from, to);
    if (1.0 + cosine < 1e-9) {
        // Half a turn: there is no one shortest way, and the axis above is lost in rounding.
        const glm::dvec3 about = perpendicularTo(from);
        return 2.0 * glm::dot(about, v) * about - v;
    }
    return cosine * v + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + cosine));
}

/// Fewer are done sooner than a thread is started and waited for.
constexpr std::size_t kGroupsPerThread = 8192;

}  // namespace

TrueNormals::TrueNormals(const MeshData& mesh, const RenderMesh& render)
    : m_faceStarts(mesh.faceStarts), m_cornerVertices(mesh.cornerVertices) {
    m_originals.reserve(render.vertices.size());
    for (const DynamicVertex& vertex : render.vertices) {
        m_originals.push_back(vertex.normal);
    }
    m_normals = m_originals;
    groupRenderVertices(render);
    groupFaces(render);
    const auto groups = static_cast<std::uint32_t>(m_renderStarts.size() - 1);
    m_visited.assign(groups, 0);
    m_originalAreas.reserve(groups);
    for (std::uint32_t group = 0; group < groups; ++group) {
        m_originalAreas.push_back(areaOf(group, mesh.positions));
    }
}

void TrueNormals::groupRenderVertices(const RenderMesh& render) {
    const auto vertices = static_cast<std::uint32_t>(render.fileVertexStarts.size() - 1);
    m_renderVertices = render.fileVertexRender;
    m_vertexStarts.push_back(0);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const std::uint32_t first = render.fileVertexStarts[v];
        const std::uint32_t end = render.fileVertexStarts[v + 1];
        const auto members = std::span(m_renderVertices).subspan(first, end - first);
        std::sort(members.begin(), members.end(), [this](std::uint32_t a, std::uint32_t b) {
            return key(m_originals[a]) < key(m_originals[b]);
        });
        for (std::uint32_t i = first; i < end; ++i) {
            if (i == first || m_originals[m_renderVertices[i]] != m_originals[m_renderVertices[i - 1]]) {
                m_renderStarts.push_back(i);
            }
        }
        m_vertexStarts.push_back(static_cast<std::uint32_t>(m_renderStarts.size()));
    }
    m_renderStarts.push_back(static_cast<std::uint32_t>(m_renderVertices.size()));
}

void TrueNormals::groupFaces(const RenderMesh& render) {
    const std::size_t groups = m_renderStarts.size() - 1;
    std::vector<std::uint32_t> groupOf(m_renderVertices.size());
    for (std::size_t group = 0; group < groups; ++group) {
        for (std::uint32_t i = m_renderStarts[group]; i < m_renderStarts[group + 1]; ++i) {
            groupOf[m_renderVertices[i]] = static_cast<std::uint32_t>(group);
        }
    }
    m_cornerGroups.reserve(render.cornerRenderVertices.size());
    for (const std::uint32_t renderVertex : render.cornerRenderVertices) {
        m_cornerGroups.push_back(groupOf[renderVertex]);
    }

    // A face that comes to a group with two corners is listed twice: it counts with its area each time,
    // before and after the dent alike.
    m_groupFaceStarts.assign(groups + 1, 0);
    for (const std::uint32_t group : m_cornerGroups) {
        ++m_groupFaceStarts[group + 1];
    }
    for (std::size_t group = 0; group < groups; ++group) {
        m_groupFaceStarts[group + 1] += m_groupFaceStarts[group];
    }
    m_groupFaces.resize(m_cornerGroups.size());
    std::vector<std::uint32_t> next(m_groupFaceStarts.begin(), m_groupFaceStarts.end() - 1);
    for (std::size_t f = 0; f + 1 < m_faceStarts.size(); ++f) {
        for (std::size_t c = m_faceStarts[f]; c < m_faceStarts[f + 1]; ++c) {
            m_groupFaces[next[m_cornerGroups[c]]++] = static_cast<std::uint32_t>(f);
        }
    }
}

glm::dvec3 TrueNormals::areaOf(std::uint32_t group, std::span<const glm::vec3> positions) const {
    glm::dvec3 sum(0.0);
    for (std::uint32_t i = m_groupFaceStarts[group]; i < m_groupFaceStarts[group + 1]; ++i) {
        const std::uint32_t face = m_groupFaces[i];
        sum += doubleAreaVector(
            positions, std::span(m_cornerVertices)
                           .subspan(m_faceStarts[face], m_faceStarts[face + 1] - m_faceStarts[face]));
    }
    return sum;
}

void TrueNormals::recompute(std::uint32_t group, std::span<const glm::vec3> positions) {
    const auto members =
        std::span(m_renderVertices)
            .subspan(m_renderStarts[group], m_renderStarts[group + 1] - m_renderStarts[group]);
    const glm::vec3 original = m_originals[members.front()];
    const glm::dvec3 before = m_originalAreas[group];
    const glm::dvec3 now = areaOf(group, positions);
    const double sizeBefore = glm::length(before);
    const double sizeNow = glm::length(now);
    const double sizes = sizeBefore * sizeNow;
    glm::vec3 normal = original;
    // Faces without area, before or now, have no normal to follow: the original stays. A turn keeps its
    // length.
    if (now != before && sizes > 0.0 && std::isfinite(sizes)) {
        normal = glm::vec3(turned(glm::dvec3(original), before / sizeBefore, now / sizeNow));
    }
    for (const std::uint32_t member : members) {
        m_normals[member] = normal;
    }
}

void TrueNormals::update(std::span<const glm::vec3> positions,
                         std::span<const std::uint32_t> movedFileVertices,
                         std::vector<std::uint32_t>& updated) {
    if (++m_pass == 0) {  // after 2^32 updates the marks of the first would count as new
        std::fill(m_visited.begin(), m_visited.end(), 0);
        m_pass = 1;
    }
    m_concerned.clear();
    const auto visit = [&](std::uint32_t group) {
        if (m_visited[group] == m_pass) {
            return;
        }
        m_visited[group] = m_pass;
        m_concerned.push_back(group);
        updated.insert(updated.end(), m_renderVertices.begin() + m_renderStarts[group],
                       m_renderVertices.begin() + m_renderStarts[group + 1]);
    };
    for (const std::uint32_t vertex : movedFileVertices) {
        const std::uint32_t firstGroup = m_vertexStarts[vertex];
        const std::uint32_t endGroup = m_vertexStarts[vertex + 1];
        for (std::uint32_t i = m_groupFaceStarts[firstGroup]; i < m_groupFaceStarts[endGroup]; ++i) {
            const std::uint32_t face = m_groupFaces[i];
            std::for_each(m_cornerGroups.begin() + m_faceStarts[face],
                          m_cornerGroups.begin() + m_faceStarts[face + 1], visit);
        }
    }
    recompute(m_concerned, positions);
}

/// Groups write different normals: many are shared among the processors.
void TrueNormals::recompute(std::span<const std::uint32_t> groups, std::span<const glm::vec3> positions) {
    const std::size_t processors = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
    const std::size_t parts = std::clamp<std::size_t>(groups.size() / kGroupsPerThread, 1, processors);
    const std::size_t size = (groups.size() + parts - 1) / parts;
    const auto work = [this, positions](std::span<const std::uint32_t> part) {
        for (const std::uint32_t group : part) {
            recompute(group, positions);
        }
    };
    std::vector<std::jthread> helpers;
    for (std::size_t first = size; first < groups.size(); first += size) {
        const std::span<const std::uint32_t> part =
            groups.subspan(first, std::min(size, groups.size() - first));
        try {
            helpers.emplace_back(work, part);
        } catch (const std::system_error&) {  // no more threads to be had
            work(part);
        }
    }
    work(groups.first(std::min(size, groups.size())));
}

void TrueNormals::reset() {
    m_normals = m_originals;
}

}  // namespace hitscope
