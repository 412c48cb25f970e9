// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/target_buffers.h"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>

#include "pipeline/vertex_bytes.h"
#include "pipeline/vertex_colours.h"

namespace hitscope {
namespace {

template <class T>
gl::Buffer makeBuffer(std::span<const T> content, GLenum usage) {
    gl::Buffer buffer = gl::Buffer::make();
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.id());
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(content.size_bytes()), content.data(), usage);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return buffer;
}

void makeRoom(GLuint buffer, std::size_t bytes, GLenum usage) {
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, usage);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

/// They come behind the triangles in that buffer.
std::vector<DrawRange> coarseDrawsOf(const RenderMesh& mesh) {
    std::vector<DrawRange> draws = mesh.coarseDraws;
    for (DrawRange& draw : draws) {
        draw.first += static_cast<std::uint32_t>(mesh.triangles.size());
    }
    return draws;
}

const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): GL's way to say it
}

/// Makes `attribute` of the bound vertex array read `components` floats at `offset` of each `stride` bytes.
void attach(Attribute attribute, const gl::Buffer& buffer, GLint components, std::size_t stride,
            std::size_t offset) {
    const auto index = static_cast<GLuint>(attribute);
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          bufferOffset(offset));
}

void attachDynamic(const gl::Buffer& dynamic) {
    attach(Attribute::Position, dynamic, 3, sizeof(DynamicVertex), offsetof(DynamicVertex, position));
    attach(Attribute::Normal, dynamic, 3, sizeof(DynamicVertex), offsetof(DynamicVertex, normal));
}

void attachOriginal(const gl::Buffer& original) {
    attach(Attribute::OriginalPosition, original, 3, sizeof(DynamicVertex),
           offsetof(DynamicVertex, position));
    attach(Attribute::OriginalNormal, original, 3, sizeof(DynamicVertex), offsetof(DynamicVertex, normal));
}

std::vector<glm::vec3> normalsOf(std::span<const DynamicVertex> vertices) {
    std::vector<glm::vec3> normals;
    normals.reserve(vertices.size());
    for (const DynamicVertex& vertex : vertices) {
        normals.push_back(vertex.normal);
    }
    return normals;
}

/// One a vertex.
template <class Number>
std::vector<Number> clusterNumbers(std::span<const Cluster> clusters) {
    std::vector<Number> numbers;
    for (const Cluster& cluster : clusters) {
        numbers.resize(cluster.first + cluster.count, static_cast<Number>(&cluster - clusters.data()));
    }
    return numbers;
}

/// From a few hundred edges, evenly spread over the list.
float usualEdgeOf(const RenderMesh& mesh) {
    constexpr std::size_t kLooks = 512;
    const std::size_t edges = mesh.edges.size() / 2;
    const std::size_t step = std::max<std::size_t>(1, edges / kLooks);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t edge = 0; edge < edges; edge += step, ++count) {
        sum += glm::distance(mesh.vertices[mesh.edges[2 * edge]].position,
                             mesh.vertices[mesh.edges[2 * edge + 1]].position);
    }
    return count == 0 ? 0.0f : static_cast<float>(sum / static_cast<double>(count));
}

/// Leaves the caller's vertex array and array buffer as they were.
class KeepBindings {
public:
    KeepBindings() {
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
        glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &m_arrayBuffer);
    }
    ~KeepBindings() {
        glBindVertexArray(static_cast<GLuint>(m_vertexArray));
        glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(m_arrayBuffer));
    }
    KeepBindings(const KeepBindings&) = delete;
    KeepBindings& operator=(const KeepBindings&) = delete;

private:
    GLint m_vertexArray = 0;
    GLint m_arrayBuffer = 0;
};

}  // namespace

TargetBuffers::TargetBuffers(const RenderMesh& mesh, std::span<const glm::vec3> colours)
    : TargetBuffers(mesh, colours, Later{}) {
    fillMore(std::numeric_limits<std::size_t>::max());
}

TargetBuffers::TargetBuffers(const RenderMesh& mesh, std::span<const glm::vec3> colours, Later /*later*/)
    : m_mesh(&mesh),
      m_vertexCount(static_cast<std::uint32_t>(mesh.vertices.size())),
      m_drawnVertexCount(mesh.drawnVertices),
      m_triangleIndexCount(static_cast<std::uint32_t>(mesh.triangles.size())),
      m_edgeIndexCount(static_cast<std::uint32_t>(mesh.edges.size())),
      m_draws(mesh.draws),
      m_coarseDraws(coarseDrawsOf(mesh)),
      m_clusters(mesh.clusters),
      m_clusterTree(mesh.clusterTree),
      m_bounds(mesh.bounds),
      m_usualEdge(usualEdgeOf(mesh)),
      m_surfaceArray(gl::VertexArray::make()),
      m_edgeArray(gl::VertexArray::make()),
      m_captureArray(gl::VertexArray::make()),
      m_originalSurfaceArray(gl::VertexArray::make()),
      m_originalEdgeArray(gl::VertexArray::make()) {
    makeBuffers();
    if (!colours.empty()) {
        m_colours = makeBuffer(std::span<const LinearColour>(linearColours(colours, mesh.fileVertices)),
                               GL_STATIC_DRAW);
    }
    makeArrays();
}

void TargetBuffers::makeBuffers() {
    const auto vertices = std::as_bytes(std::span(m_mesh->vertices));
    const auto texcoords = std::as_bytes(std::span(m_mesh->texcoords));
    const auto triangles = std::as_bytes(std::span(m_mesh->triangles));
    const auto coarse = std::as_bytes(std::span(m_mesh->coarseTriangles));
    const std::size_t normals = m_vertexCount * sizeof(glm::vec3);
    for (gl::Buffer* buffer : {&m_dynamic, &m_original, &m_texcoords, &m_shadingNormals, &m_triangles}) {
        *buffer = gl::Buffer::make();
    }
    const auto add = [this](const gl::Buffer& buffer, GLenum usage, std::size_t start, const std::byte* from,
                            std::size_t size) {
        m_missing.push_back({.buffer = buffer.id(), .start = start, .from = from, .bytes = size});
        if (usage != 0) {
            m_missing.push_back({.buffer = buffer.id(), .bytes = start + size, .usage = usage});
        }
    };
    add(m_dynamic, GL_DYNAMIC_COPY, 0, vertices.data(), vertices.size());
    add(m_original, GL_STATIC_DRAW, 0, vertices.data(), vertices.size());
    add(m_texcoords, GL_STATIC_DRAW, 0, texcoords.data(), texcoords.size());
    add(m_shadingNormals, GL_DYNAMIC_DRAW, 0, nullptr, normals);
    add(m_triangles, 0, 0, triangles.data(), triangles.size());
    add(m_triangles, GL_STATIC_DRAW, triangles.size(), coarse.data(), coarse.size());
}

bool TargetBuffers::fillMore(std::size_t bytes) {
    while (!m_missing.empty()) {
        const Part& part = m_missing.back();
        if (part.usage != 0) {
            makeRoom(part.buffer, part.bytes, part.usage);  // a software renderer clears it
            bytes -= std::min(part.bytes, bytes);
            m_missing.pop_back();
            if (bytes == 0) {
                break;
            }
            continue;
        }
        // Whole normals.
        const std::size_t left = part.bytes - m_filled;
        const std::size_t some =
            left <= bytes ? left : std::max<std::size_t>(bytes / sizeof(glm::vec3), 1) * sizeof(glm::vec3);
        if (some > 0) {
            fill(part, m_filled, std::min(some, left));
            m_filled += std::min(some, left);
        }
        if (m_filled < part.bytes) {
            return false;
        }
        bytes -= std::min(some, bytes);
        m_missing.pop_back();
        m_filled = 0;
        if (bytes == 0) {
            break;
        }
    }
    return m_missing.empty();
}

void TargetBuffers::fill(const Part& part, std::size_t start, std::size_t bytes) const {
    std::vector<glm::vec3> normals;
    const void* from = part.from + start;
    if (part.from == nullptr) {
        normals = normalsOf(
            std::span(m_mesh->vertices).subspan(start / sizeof(glm::vec3), bytes / sizeof(glm::vec3)));
        from = normals.data();
    }
    glBindBuffer(GL_COPY_WRITE_BUFFER, part.buffer);
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(part.start + start),
                    static_cast<GLsizeiptr>(bytes), from);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void TargetBuffers::makeArrays() {
    const KeepBindings keep;
    glBindVertexArray(m_surfaceArray.id());
    attachDynamic(m_dynamic);
    attach(Attribute::Texcoord, m_texcoords, 2, sizeof(glm::vec2), 0);
    attach(Attribute::ShadingNormal, m_shadingNormals, 3, sizeof(glm::vec3), 0);
    attachOriginal(m_original);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_triangles.id());

    glBindVertexArray(m_edgeArray.id());
    attachDynamic(m_dynamic);
    attachOriginal(m_original);

    glBindVertexArray(m_captureArray.id());
    attachDynamic(m_dynamic);
    attachOriginal(m_original);

    glBindVertexArray(m_originalSurfaceArray.id());
    attachDynamic(m_original);
    attach(Attribute::Texcoord, m_texcoords, 2, sizeof(glm::vec2), 0);
    attach(Attribute::ShadingNormal, m_original, 3, sizeof(DynamicVertex), offsetof(DynamicVertex, normal));
    attachOriginal(m_original);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_triangles.id());

    glBindVertexArray(m_originalEdgeArray.id());
    attachDynamic(m_original);
    attachOriginal(m_original);

    if (m_colours) {
        attachColours();
    }
}

/// Most targets are never drawn with edges, and these take a tenth of their memory.
void TargetBuffers::needEdges() const {
    if (m_edges) {
        return;
    }
    m_edges = makeBuffer(std::span<const std::uint32_t>(m_mesh->edges), GL_STATIC_DRAW);
    const KeepBindings keep;
    for (const gl::VertexArray* array : {&m_edgeArray, &m_originalEdgeArray}) {
        glBindVertexArray(array->id());
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_edges.id());
    }
}

const ClusterRuns& TargetBuffers::edgeRuns() const {
    if (!m_edgeRuns) {
        m_edgeRuns.emplace(m_mesh->vertices, m_mesh->edges, 2, std::span<const DrawRange>());
    }
    return *m_edgeRuns;
}

void TargetBuffers::attachColours() {
    const auto index = static_cast<GLuint>(Attribute::Colour);
    for (const gl::VertexArray* array : {&m_surfaceArray, &m_originalSurfaceArray}) {
        glBindVertexArray(array->id());
        glBindBuffer(GL_ARRAY_BUFFER, m_colours.id());
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, 3, GL_UNSIGNED_SHORT, GL_TRUE, sizeof(LinearColour), nullptr);
    }
}

void TargetBuffers::bringClusterNumbers() {
    if (m_clusterNumbers) {
        return;
    }
    if (areClusterNumbersShort()) {
        m_clusterNumbers = makeBuffer(
            std::span<const std::uint16_t>(clusterNumbers<std::uint16_t>(m_clusters)), GL_STATIC_DRAW);
    } else {
        m_clusterNumbers = makeBuffer(
            std::span<const std::uint32_t>(clusterNumbers<std::uint32_t>(m_clusters)), GL_STATIC_DRAW);
    }
}

/// Two bytes a vertex are enough for four million vertices.
bool TargetBuffers::areClusterNumbersShort() const {
    return m_clusters.size() <= std::numeric_limits<std::uint16_t>::max();
}

void TargetBuffers::needClusterNumbers() {
    if (m_hasClusterNumbers) {
        return;
    }
    m_hasClusterNumbers = true;
    bringClusterNumbers();
    const KeepBindings keep;
    glBindVertexArray(m_captureArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_clusterNumbers.id());
    const auto index = static_cast<GLuint>(Attribute::Cluster);
    glEnableVertexAttribArray(index);
    glVertexAttribIPointer(index, 1, areClusterNumbersShort() ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT, 0,
                           nullptr);
}

void TargetBuffers::read(const VertexRange& range, std::span<DynamicVertex> vertices) const {
    glBindBuffer(GL_COPY_READ_BUFFER, m_dynamic.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, vertexBytes(range.first),
                       static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data());
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
}

void TargetBuffers::write(std::uint32_t first, std::span<const DynamicVertex> vertices) {
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_dynamic.id());
    glBufferSubData(GL_COPY_WRITE_BUFFER, vertexBytes(first), static_cast<GLsizeiptr>(vertices.size_bytes()),
                    vertices.data());
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void TargetBuffers::restoreOriginal() {
    const VertexRange all{0, m_vertexCount};
    restoreOriginal(std::span(&all, 1));
}

void TargetBuffers::restoreOriginal(std::span<const VertexRange> ranges) {
    glBindBuffer(GL_COPY_READ_BUFFER, m_original.id());
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_dynamic.id());
    for (const VertexRange& range : ranges) {
        const GLintptr offset = vertexBytes(range.first);
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, offset, offset,
                            vertexBytes(range.count));
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void TargetBuffers::writeShadingNormals(std::uint32_t first, std::span<const glm::vec3> normals) {
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_shadingNormals.id());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first * sizeof(glm::vec3)),
                    static_cast<GLsizeiptr>(normals.size_bytes()), normals.data());
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void TargetBuffers::clearChangeValues() {
    if (m_changeValues) {
        writeChangeValues(0, std::vector<float>(m_vertexCount, 0.0f));
    }
}

void TargetBuffers::writeChangeValues(std::uint32_t first, std::span<const float> values) {
    if (!m_changeValues) {
        // glBufferData only makes room. If it brings content too, NVIDIA's driver (580.159) draws that
        // content instead of what glBufferSubData writes before the first draw.
        m_changeValues = gl::Buffer::make();
        makeRoom(m_changeValues.id(), m_vertexCount * sizeof(float), GL_DYNAMIC_DRAW);
        const KeepBindings keep;
        glBindVertexArray(m_surfaceArray.id());
        attach(Attribute::ChangeValue, m_changeValues, 1, sizeof(float), 0);
        if (values.size() < m_vertexCount) {
            clearChangeValues();
        }
    }
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_changeValues.id());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first * sizeof(float)),
                    static_cast<GLsizeiptr>(values.size_bytes()), values.data());
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

}  // namespace hitscope
