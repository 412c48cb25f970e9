// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/changed_parts.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

constexpr std::uint32_t kBlock = 64;  // vertices
constexpr std::uint32_t kGap = 6;     // triangles or edges: so many cost less than another run

/// The first of elements [first, end), sorted by their lowest index, whose lowest index is at least `vertex`.
std::uint32_t firstFrom(std::span<const std::uint32_t> indices, std::size_t size, std::uint32_t first,
                        std::uint32_t end, std::uint32_t vertex) {
    while (first < end) {
        const std::uint32_t middle = first + (end - first) / 2;
        const auto corners = indices.subspan(middle * size, size);
        if (*std::min_element(corners.begin(), corners.end()) < vertex) {
            first = middle + 1;
        } else {
            end = middle;
        }
    }
    return first;
}

}  // namespace

ChangedParts::ChangedParts(std::shared_ptr<const RenderMesh> mesh)
    : m_mesh(std::move(mesh)),
      m_vertices(m_mesh->vertices.size(), false),
      m_blockOf((m_mesh->vertices.size() + kBlock - 1) / kBlock) {}

void ChangedParts::mark(std::uint32_t vertex) {
    m_vertices[vertex] = true;
    const std::uint32_t place = vertex / kBlock;
    if (m_blockOf[place] == 0) {
        m_blocks.push_back({.place = place, .triangles = {}, .edges = {}});
        m_blockOf[place] = static_cast<std::uint32_t>(m_blocks.size());
    }
    const std::uint32_t index = m_blockOf[place] - 1;
    if (!m_blocks[index].isDirty) {
        m_blocks[index].isDirty = true;
        m_dirty.push_back(index);
    }
}

void ChangedParts::note(std::span<const std::uint32_t> renderVertices) {
    for (const std::uint32_t vertex : renderVertices) {
        mark(vertex);
        // Edges go between the first of the render vertices that lie at the same place.
        mark(m_mesh->renderVerticesOf(m_mesh->fileVertices[vertex]).front());
    }
}

/// Of `among`, those whose lowest vertex is in the block and all of whose vertices were noted: one that has a
/// moved vertex shares a face with it in all its corners, which were noted together.
std::vector<ChangedParts::Run> ChangedParts::changedIn(std::span<const std::uint32_t> elements,
                                                       std::size_t size, Run among,
                                                       std::uint32_t block) const {
    std::vector<Run> runs;
    const std::uint32_t first = firstFrom(elements, size, among.first, among.end, block * kBlock);
    const std::uint32_t end = firstFrom(elements, size, first, among.end, (block + 1) * kBlock);
    for (std::uint32_t element = first; element < end; ++element) {
        const auto corners = elements.subspan(element * size, size);
        if (!std::all_of(corners.begin(), corners.end(),
                         [this](std::uint32_t vertex) { return m_vertices[vertex]; })) {
            continue;
        }
        if (runs.empty() || element - runs.back().end > kGap) {
            runs.push_back({element, element});
        }
        runs.back().end = element + 1;
    }
    return runs;
}

std::vector<IndexRun> ChangedParts::joined(std::vector<Run> Block::*runs, std::size_t size) const {
    std::vector<Run> all;
    for (const Block& block : m_blocks) {
        all.insert(all.end(), (block.*runs).begin(), (block.*runs).end());
    }
    std::sort(all.begin(), all.end(), [](const Run& a, const Run& b) { return a.first < b.first; });
    const auto step = static_cast<std::uint32_t>(size);
    std::vector<IndexRun> result;
    for (std::size_t i = 0; i < all.size();) {
        Run run = all[i++];
        for (; i < all.size() && all[i].first <= run.end + kGap; ++i) {
            run.end = all[i].end;
        }
        result.push_back({run.first * step, run.end * step});
    }
    return result;
}

void ChangedParts::collect() const {
    if (m_dirty.empty()) {
        return;
    }
    for (const std::uint32_t index : std::exchange(m_dirty, {})) {
        Block& block = m_blocks[index];
        block.isDirty = false;
        block.triangles.clear();
        for (const DrawRange& draw : m_mesh->draws) {
            const Run among{draw.first / 3, (draw.first + draw.count) / 3};
            const std::vector<Run> changed = changedIn(m_mesh->triangles, 3, among, block.place);
            block.triangles.insert(block.triangles.end(), changed.begin(), changed.end());
        }
        const auto edges = static_cast<std::uint32_t>(m_mesh->edges.size() / 2);
        block.edges = changedIn(m_mesh->edges, 2, {0, edges}, block.place);
    }
    m_triangles = joined(&Block::triangles, 3);
    m_edges = joined(&Block::edges, 2);
}

std::span<const IndexRun> ChangedParts::triangles() const {
    collect();
    return m_triangles;
}

std::span<const IndexRun> ChangedParts::edges() const {
    collect();
    return m_edges;
}

}  // namespace hitscope
