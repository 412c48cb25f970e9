// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/reference.h"

#include "deform/deform.h"

namespace hitscope {

void deformEverywhere(std::span<DynamicVertex> vertices, std::span<const Hit> hits) {
    for (DynamicVertex& vertex : vertices) {
        for (const Hit& hit : hits) {
            deform(vertex.position, vertex.normal, hit);
        }
    }
}

ReferenceDeformation::ReferenceDeformation(const RenderMesh& mesh)
    : m_vertices(mesh.vertices), m_reach(mesh.clusters) {}

std::vector<VertexRange> ReferenceDeformation::apply(std::span<const Hit> hits) {
    ChangedRanges touched;
    std::vector<std::uint32_t> reached;
    for (const Hit& hit : hits) {
        reached.clear();
        m_reach.advance(hit, reached);
        const std::vector<VertexRange> ranges = m_reach.rangesOf(reached);
        for (const VertexRange& range : ranges) {
            const auto vertices = std::span(m_vertices).subspan(range.first, range.count);
            for (DynamicVertex& vertex : vertices) {
                deform(vertex.position, vertex.normal, hit);
            }
            m_reach.place(range.first, vertices);
        }
        touched.add(ranges);
    }
    return touched.take();
}

}  // namespace hitscope
