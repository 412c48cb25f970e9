// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/true_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <system_error>
#include <thread>
#include <tuple>

#include "core/give_up.h"
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

/// A group is what shares one normal: a file vertex and the faces that meet there at the same original
/// normal (and so the render vertices that differ in texture coordinates only). Groups are numbered vertex by
/// vertex. None of this changes.
struct TrueNormals::Groups {
    Groups(std::shared_ptr<const MeshData> ofMesh, std::shared_ptr<const RenderMesh> ofRender);

    void groupRenderVertices();
    void groupFaces();
    [[nodiscard]] const glm::vec3& original(std::uint32_t renderVertex) const {
        return render->vertices[renderVertex].normal;
    }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(renderStarts.size() - 1); }
    [[nodiscard]] std::span<const std::uint32_t> members(std::uint32_t group) const {
        return renderVertices.subspan(renderStarts[group], renderStarts[group + 1] - renderStarts[group]);
    }
    /// Sum of the area vectors of a group's faces.
    [[nodiscard]] glm::dvec3 areaOf(std::uint32_t group, std::span<const glm::vec3> positions) const;

    std::shared_ptr<const MeshData> mesh;
    std::shared_ptr<const RenderMesh> render;
    // The render mesh's own arrays where each file vertex has one render vertex, and so one group.
    std::span<const std::uint32_t> groupOf;       ///< one a render vertex
    std::span<const std::uint32_t> vertexStarts;  ///< file vertex -> first of its groups; V + 1 entries
    std::span<const std::uint32_t> renderStarts;  ///< group -> its run of renderVertices
    std::span<const std::uint32_t> renderVertices;
    std::vector<std::uint32_t> faceStarts;  ///< group -> its run of faces
    std::vector<std::uint32_t> faces;

private:
    void nameGroups();

    std::vector<std::uint32_t> m_groupOf;
    std::vector<std::uint32_t> m_vertexStarts;
    std::vector<std::uint32_t> m_renderStarts;
    std::vector<std::uint32_t> m_renderVertices;
};

TrueNormals::Groups::Groups(std::shared_ptr<const MeshData> ofMesh,
                            std::shared_ptr<const RenderMesh> ofRender)
    : mesh(std::move(ofMesh)), render(std::move(ofRender)) {
    if (render->fileVertices.size() + 1 == render->fileVertexStarts.size()) {
        groupOf = render->fileVertices;
        vertexStarts = renderStarts = render->fileVertexStarts;
        renderVertices = render->fileVertexRender;
    } else {
        groupRenderVertices();
        nameGroups();
    }
    groupFaces();
}

TrueNormals::TrueNormals(std::shared_ptr<const MeshData> mesh, std::shared_ptr<const RenderMesh> render)
    : m_groups(std::make_shared<const Groups>(std::move(mesh), render)), m_normals(std::move(render)) {}

TrueNormals::TrueNormals(const MeshData& mesh, const RenderMesh& render)
    : TrueNormals(std::make_shared<const MeshData>(mesh), std::make_shared<const RenderMesh>(render)) {}

void TrueNormals::Groups::groupRenderVertices() {
    const auto vertices = static_cast<std::uint32_t>(render->fileVertexStarts.size() - 1);
    m_renderVertices = render->fileVertexRender;
    m_renderStarts.reserve(m_renderVertices.size() + 1);
    m_vertexStarts.reserve(vertices + 1);
    m_vertexStarts.push_back(0);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        mayGiveUp(v);
        const std::uint32_t first = render->fileVertexStarts[v];
        const std::uint32_t end = render->fileVertexStarts[v + 1];
        const auto around = std::span(m_renderVertices).subspan(first, end - first);
        std::sort(around.begin(), around.end(),
                  [this](std::uint32_t a, std::uint32_t b) { return key(original(a)) < key(original(b)); });
        for (std::uint32_t i = first; i < end; ++i) {
            if (i == first || original(m_renderVertices[i]) != original(m_renderVertices[i - 1])) {
                m_renderStarts.push_back(i);
            }
        }
        m_vertexStarts.push_back(static_cast<std::uint32_t>(m_renderStarts.size()));
    }
    m_renderStarts.push_back(static_cast<std::uint32_t>(m_renderVertices.size()));
    vertexStarts = m_vertexStarts;
    renderStarts = m_renderStarts;
    renderVertices = m_renderVertices;
}

void TrueNormals::Groups::nameGroups() {
    m_groupOf.resize(renderVertices.size());
    for (std::uint32_t group = 0; group < count(); ++group) {
        for (const std::uint32_t member : members(group)) {
            m_groupOf[member] = group;
        }
    }
    groupOf = m_groupOf;
}

void TrueNormals::Groups::groupFaces() {
    // A face that comes to a group with two corners is listed twice: it counts with its area each time,
    // before and after the dent alike.
    const std::span<const std::uint32_t> corners = render->cornerRenderVertices;
    std::vector<std::uint32_t>& starts = faceStarts;
    starts.assign(std::size_t{count()} + 2, 0);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        mayGiveUp(c);
        ++starts[groupOf[corners[c]] + 2];
    }
    for (std::size_t group = 2; group < starts.size(); ++group) {
        starts[group] += starts[group - 1];
    }
    // Each start moves to the end of its run, where the next one starts.
    faces.resize(corners.size());
    for (std::size_t f = 0; f < mesh->faceCount(); ++f) {
        mayGiveUp(f);
        for (std::size_t c = mesh->faceStarts[f]; c < mesh->faceStarts[f + 1]; ++c) {
            faces[starts[groupOf[corners[c]] + 1]++] = static_cast<std::uint32_t>(f);
        }
    }
    starts.pop_back();
}

glm::dvec3 TrueNormals::Groups::areaOf(std::uint32_t group, std::span<const glm::vec3> positions) const {
    glm::dvec3 sum(0.0);
    for (std::uint32_t i = faceStarts[group]; i < faceStarts[group + 1]; ++i) {
        sum += doubleAreaVector(positions, mesh->face(faces[i]));
    }
    return sum;
}

void TrueNormals::recompute(std::uint32_t group, std::span<const glm::vec3> positions) {
    const std::span<const std::uint32_t> members = m_groups->members(group);
    const glm::vec3 original = m_groups->original(members.front());
    const glm::dvec3 before = m_groups->areaOf(group, m_groups->mesh->positions);
    const glm::dvec3 now = m_groups->areaOf(group, positions);
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
        m_normals.set(member, normal);
    }
}

void TrueNormals::update(std::span<const glm::vec3> positions,
                         std::span<const std::uint32_t> movedFileVertices,
                         std::vector<std::uint32_t>& updated) {
    m_isConcerned.resize(m_groups->count(), false);
    m_wasUpdated = true;
    m_concerned.clear();
    const auto visit = [&](std::uint32_t renderVertex) {
        const std::uint32_t group = m_groups->groupOf[renderVertex];
        if (m_isConcerned[group]) {
            return;
        }
        m_isConcerned[group] = true;
        m_concerned.push_back(group);
        const std::span<const std::uint32_t> members = m_groups->members(group);
        updated.insert(updated.end(), members.begin(), members.end());
        for (const std::uint32_t member : members) {
            m_normals.makeOwn(member);
        }
    };
    const std::vector<std::uint32_t>& faceStarts = m_groups->mesh->faceStarts;
    const auto corners = m_groups->render->cornerRenderVertices.begin();
    for (const std::uint32_t vertex : movedFileVertices) {
        const std::uint32_t firstGroup = m_groups->vertexStarts[vertex];
        const std::uint32_t endGroup = m_groups->vertexStarts[vertex + 1];
        for (std::uint32_t i = m_groups->faceStarts[firstGroup]; i < m_groups->faceStarts[endGroup]; ++i) {
            const std::uint32_t face = m_groups->faces[i];
            std::for_each(corners + faceStarts[face], corners + faceStarts[face + 1], visit);
        }
    }
    recompute(m_concerned, positions);
    for (const std::uint32_t group : m_concerned) {
        m_isConcerned[group] = false;
    }
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
    m_normals.reset();
}

}  // namespace hitscope
