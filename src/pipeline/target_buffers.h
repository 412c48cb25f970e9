// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "deform/vertex_range.h"
#include "gl/objects.h"
#include "mesh/render_mesh.h"

namespace hitscope {

/// Vertex attributes of every program that draws or deforms a target.
enum class Attribute : GLuint {
    Position = 0,
    Normal = 1,
    Texcoord = 2,
    ShadingNormal = 3,
    OriginalPosition = 4,
    OriginalNormal = 5,
    ChangeValue = 6,
    Cluster = 7,
    Colour = 8
};

/// One target's buffers on the GPU. The dynamic buffer (DynamicVertex, position and normal) is the pipeline's
/// to write; all else is fixed, but for the shading normals. A context is current for every call and the
/// destructor.
class TargetBuffers {
public:
    /// `mesh` outlives this. colours: MeshData::colours; they go where surfaces are drawn from
    /// (Attribute::Colour), linear.
    explicit TargetBuffers(const RenderMesh& mesh, std::span<const glm::vec3> colours = {});
    struct Later {};
    /// Likewise, but empty until fillMore() has brought everything; nothing else is to be called before.
    TargetBuffers(const RenderMesh& mesh, std::span<const glm::vec3> colours, Later later);
    /// Brings so many bytes at most; returns whether everything is there. Touches no vertex array: a context
    /// that shares the buffers may be current instead.
    bool fillMore(std::size_t bytes);

    /// All attributes and the triangles' index buffer: for glDrawElements(GL_TRIANGLES) over mesh.draws.
    [[nodiscard]] GLuint surfaceArray() const { return m_surfaceArray.id(); }
    /// Position, normal and original position, with the edges' index buffer: for glDrawElements(GL_LINES).
    /// That buffer is made when this is first asked for.
    [[nodiscard]] GLuint edgeArray() const {
        needEdges();
        return m_edgeArray.id();
    }
    /// The same two of the target as it was: positions and all normals are the original ones.
    [[nodiscard]] GLuint originalSurfaceArray() const { return m_originalSurfaceArray.id(); }
    [[nodiscard]] GLuint originalEdgeArray() const {
        needEdges();
        return m_originalEdgeArray.id();
    }
    /// Position and normal from the dynamic buffer and the original, no indices: for capturing and for
    /// points.
    [[nodiscard]] GLuint captureArray() const { return m_captureArray.id(); }
    /// Has the capture array tell each vertex the number of its cluster as well (Attribute::Cluster). Not by
    /// gl_VertexID: Mesa's softpipe counts it from the draw's first vertex again after each 4,096.
    void needClusterNumbers();
    /// Brings these numbers before they are needed; like fillMore(), touches no vertex array.
    void bringClusterNumbers();
    /// One vec3 a vertex: the true normals.
    [[nodiscard]] GLuint shadingNormalBuffer() const { return m_shadingNormals.id(); }
    [[nodiscard]] GLuint dynamicBuffer() const { return m_dynamic.id(); }
    /// DynamicVertex, the original state, never written again.
    [[nodiscard]] GLuint originalBuffer() const { return m_original.id(); }

    [[nodiscard]] std::uint32_t vertexCount() const { return m_vertexCount; }
    /// The first of them; no face uses the others.
    [[nodiscard]] std::uint32_t drawnVertexCount() const { return m_drawnVertexCount; }
    /// Whether the surface arrays have Attribute::Colour.
    [[nodiscard]] bool hasColours() const { return static_cast<bool>(m_colours); }
    [[nodiscard]] std::uint32_t triangleIndexCount() const { return m_triangleIndexCount; }
    [[nodiscard]] std::uint32_t edgeIndexCount() const { return m_edgeIndexCount; }
    [[nodiscard]] std::span<const DrawRange> draws() const { return m_draws; }
    /// The same of RenderMesh::coarseTriangles, behind the others in the index buffer; none of a mesh that
    /// has none.
    [[nodiscard]] std::span<const DrawRange> coarseDraws() const { return m_coarseDraws; }
    /// How many indices those have.
    [[nodiscard]] std::size_t coarseIndexCount() const { return m_mesh->coarseTriangles.size(); }
    [[nodiscard]] std::span<const Cluster> clusters() const { return m_clusters; }
    [[nodiscard]] const std::shared_ptr<const ClusterTree>& clusterTree() const { return m_clusterTree; }
    [[nodiscard]] const ClusterRuns& triangleRuns() const { return m_mesh->triangleRuns; }
    /// Of what coarseDraws() cover.
    [[nodiscard]] const ClusterRuns& coarseRuns() const { return m_mesh->coarseRuns; }
    /// The index buffer's, without the coarse ones.
    [[nodiscard]] std::span<const std::uint32_t> triangles() const { return m_mesh->triangles; }
    [[nodiscard]] const ClusterRuns& edgeRuns() const;  ///< made when first asked for
    [[nodiscard]] const Bounds& originalBounds() const { return m_bounds; }
    /// About the length of an edge of the original, in metres.
    [[nodiscard]] float usualEdge() const { return m_usualEdge; }

    /// Vertices of the dynamic buffer; vertices.size() == range.count. Waits for the GPU.
    void read(const VertexRange& range, std::span<DynamicVertex> vertices) const;
    /// Replaces vertices [first, first + vertices.size()) of the dynamic buffer.
    void write(std::uint32_t first, std::span<const DynamicVertex> vertices);
    /// The dynamic buffer back to the original, on the GPU.
    void restoreOriginal();
    /// Likewise, only these vertices.
    void restoreOriginal(std::span<const VertexRange> ranges);
    /// Replaces shading normals [first, first + normals.size()).
    void writeShadingNormals(std::uint32_t first, std::span<const glm::vec3> normals);
    /// Replaces what colour maps of change show where the vertex alone does not tell
    /// (Attribute::ChangeValue); 0 before.
    void writeChangeValues(std::uint32_t first, std::span<const float> values);
    void clearChangeValues();  ///< all 0 again

private:
    /// A part of what buffers are to hold.
    struct Part {
        GLuint buffer = 0;
        std::size_t start = 0;            ///< bytes, in the buffer
        const std::byte* from = nullptr;  ///< null: the mesh's normals
        std::size_t bytes = 0;
        GLenum usage = 0;  ///< not 0: the buffer gets room for so many bytes, and nothing is filled in
    };
    void makeBuffers();
    void makeArrays();
    void fill(const Part& part, std::size_t start, std::size_t bytes) const;
    void attachColours();
    void needEdges() const;
    [[nodiscard]] bool areClusterNumbersShort() const;

    const RenderMesh* m_mesh;
    std::uint32_t m_vertexCount = 0;
    std::uint32_t m_drawnVertexCount = 0;
    std::uint32_t m_triangleIndexCount = 0;
    std::uint32_t m_edgeIndexCount = 0;
    std::vector<DrawRange> m_draws;
    std::vector<DrawRange> m_coarseDraws;
    std::vector<Cluster> m_clusters;
    std::shared_ptr<const ClusterTree> m_clusterTree;
    mutable std::optional<ClusterRuns> m_edgeRuns;
    Bounds m_bounds;
    float m_usualEdge = 0.0f;
    gl::Buffer m_dynamic;
    gl::Buffer m_original;
    gl::Buffer m_texcoords;
    gl::Buffer m_colours;  ///< without name where the mesh has none
    gl::Buffer m_shadingNormals;
    gl::Buffer m_changeValues;         ///< made when first written
    gl::Buffer m_clusterNumbers;       ///< made when first needed
    bool m_hasClusterNumbers = false;  ///< the capture array
    gl::Buffer m_triangles;
    mutable gl::Buffer m_edges;  ///< made when first needed
    gl::VertexArray m_surfaceArray;
    gl::VertexArray m_edgeArray;
    gl::VertexArray m_captureArray;
    gl::VertexArray m_originalSurfaceArray;
    gl::VertexArray m_originalEdgeArray;
    std::vector<Part> m_missing;  ///< of the buffers' content
    std::size_t m_filled = 0;     ///< bytes, of the last of these
};

}  // namespace hitscope
