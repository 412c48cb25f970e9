// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/reference.h"

#include "deform/deform.h"

namespace hitscope {

ReferenceDeformation::ReferenceDeformation(const RenderMesh& mesh)
    : m_vertices(mesh.vertices), m_reach(mesh.clusters) {}

std::vector<VertexRange> ReferenceDeformation::apply(std::span<const Hit> hits) {
    std::vector<VertexRange> touched;
    for (const Hit& hit : hits) {
        const std::vector<VertexRange> ranges = m_reach.advance(hit);
        for (const VertexRange& range : ranges) {
            for (DynamicVertex& vertex : std::span(m_vertices).subspan(range.first, range.count)) {
                deform(vertex.position, vertex.normal, hit);
            }
        }
        touched.insert(touched.end(), ranges.begin(), ranges.end());
    }
    return merged(std::move(touched));
}

}  // namespace hitscope
