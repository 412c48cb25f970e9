// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_measurer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>

#include "mesh/surface/face_measure.h"
#include "mesh/triangulate.h"

namespace hitscope {

namespace {

constexpr std::size_t kBlock = BlockIndex::kBlock;  // faces, edges or vertices summed together

std::uint32_t blockOf(std::uint32_t index) {
    return index / static_cast<std::uint32_t>(kBlock);
}

void sortUnique(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

double distance(const glm::vec3& from, const glm::vec3& to) {
    return glm::length(glm::dvec3(to) - glm::dvec3(from));
}

bool isDegenerate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> face,
                  FaceMeasurer& measurer) {
    return measurer.measure(positions, face, glm::dvec3(positions[face[0]])).isDegenerate;
}

Box boxOf(std::span<const glm::vec3> positions, const glm::dmat3& rotation, const glm::dvec3& shift) {
    Box box;
    for (const glm::vec3& position : positions) {
        box.add(rotation * glm::dvec3(position) + shift);
    }
    return box;
}

}  // namespace

float stretchOf(std::span<const std::uint32_t> face, std::span<const glm::vec3> originals,
                std::span<const glm::vec3> positions) {
    double most = 0.0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t from = face[i];
        const std::uint32_t to = face[i + 1 < face.size() ? i + 1 : 0];
        const double now = distance(positions[from], positions[to]);
        const double before = distance(originals[from], originals[to]);
        if (before > 0.0) {
            most = std::max(most, now / before);
        } else if (now > 0.0) {
            most = std::numeric_limits<double>::infinity();
        }
    }
    return static_cast<float>(most);
}

bool isFlipped(std::span<const std::uint32_t> face, std::span<const glm::vec3> originals,
               std::span<const glm::vec3> positions) {
    return glm::dot(doubleAreaVector(originals, face), doubleAreaVector(positions, face)) < 0.0;
}

SurfaceMeasurer::SurfaceMeasurer(std::shared_ptr<const MeshData> mesh,
                                 std::shared_ptr<const SurfaceTopology> topology, const std::stop_token& stop)
    : m_mesh(std::move(mesh)),
      m_topology(std::move(topology)),
      m_isListed(m_mesh->vertexCount(), false),
      m_faces(BlockIndex::blocksOf(m_mesh->faceCount())),
      m_edges(BlockIndex::blocksOf(m_topology->edges().size())),
      m_boxes(BlockIndex::blocksOf(m_mesh->vertexCount())) {
    Box box;
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        m_boxes[i] = measureBox(i);
        box.add(m_boxes[i]);
    }
    m_reference = box.empty() ? glm::dvec3(0.0) : 0.5 * (box.min + box.max);
    for (std::size_t i = 0; i < m_faces.size() && !stop.stop_requested(); ++i) {
        m_faces[i] = measureFaces(i);
    }
    for (std::size_t i = 0; i < m_edges.size() && !stop.stop_requested(); ++i) {
        m_edges[i] = measureEdges(i);
    }
    m_original = measures();
}

void SurfaceMeasurer::makeIndex() {
    const std::span<const SurfaceTopology::Edge> edges = m_topology->edges();
    m_index.emplace(Index{BlockIndex(m_mesh->vertexCount(), m_mesh->faceCount(),
                                     [this](std::size_t f) { return m_mesh->face(f); }),
                          BlockIndex(m_mesh->vertexCount(), edges.size(), [edges](std::size_t e) {
                              return std::array{edges[e].low, edges[e].high};
                          })});
}

void SurfaceMeasurer::move(std::span<const MovedVertex> moved) {
    m_dirtyFaces.clear();
    m_dirtyEdges.clear();
    m_dirtyBoxes.clear();
    if (!m_index && !moved.empty()) {
        makeIndex();
        m_positions = PageCopy(m_mesh->positions);
    }
    std::uint32_t lastRun = kNoIndex;
    for (const MovedVertex& vertex : moved) {
        if (m_positions[vertex.vertex] == vertex.position) {
            continue;
        }
        m_positions[vertex.vertex] = vertex.position;
        if (!m_isListed[vertex.vertex]) {
            m_isListed[vertex.vertex] = true;
            m_listed.push_back(vertex.vertex);
        }
        m_dirtyBoxes.push_back(blockOf(vertex.vertex));
        if (const std::uint32_t run = BlockIndex::runOf(vertex.vertex); run != lastRun) {
            lastRun = run;
            for (const std::uint32_t block : m_index->faces.blocksOfRun(run)) {
                m_dirtyFaces.push_back(block);
            }
            for (const std::uint32_t block : m_index->edges.blocksOfRun(run)) {
                m_dirtyEdges.push_back(block);
            }
        }
    }
    sortUnique(m_dirtyFaces);
    sortUnique(m_dirtyEdges);
    sortUnique(m_dirtyBoxes);
    for (const std::uint32_t block : m_dirtyFaces) {
        m_faces[block] = measureFaces(block);
    }
    for (const std::uint32_t block : m_dirtyEdges) {
        m_edges[block] = measureEdges(block);
    }
    for (const std::uint32_t block : m_dirtyBoxes) {
        m_boxes[block] = measureBox(block);
    }
}

SurfaceMeasurer::FaceBlock SurfaceMeasurer::measureFaces(std::size_t block) const {
    FaceBlock sums;
    FaceMeasurer measurer(m_mesh->positions);
    const std::size_t end = std::min((block + 1) * kBlock, m_mesh->faceCount());
    for (std::size_t f = block * kBlock; f < end; ++f) {
        const std::span<const std::uint32_t> face = m_mesh->face(f);
        const FaceMeasure measure = measurer.measure(positions(), face, m_reference);
        sums.area.add(measure.area);
        sums.volume += measure.volume;
        sums.moment += measure.moment;
        sums.degenerate += measure.isDegenerate ? 1 : 0;
        if (!measure.isDegenerate) {
            sums.aspect.add(measure.aspect);
        }
        const bool isMoved = std::any_of(face.begin(), face.end(), [this](std::uint32_t vertex) {
            return positions()[vertex] != m_mesh->positions[vertex];
        });
        if (isMoved) {
            sums.flipped += isFlipped(face, m_mesh->positions, positions()) ? 1 : 0;
            sums.degenerated +=
                measure.isDegenerate && !isDegenerate(m_mesh->positions, face, measurer) ? 1 : 0;
            sums.stretch = std::max(sums.stretch, stretchOf(face, m_mesh->positions, positions()));
        }
    }
    return sums;
}

Spread SurfaceMeasurer::measureEdges(std::size_t block) const {
    Spread lengths;
    const std::span<const SurfaceTopology::Edge> edges = m_topology->edges();
    for (std::size_t e = block * kBlock; e < std::min((block + 1) * kBlock, edges.size()); ++e) {
        lengths.add(distance(positions()[edges[e].low], positions()[edges[e].high]));
    }
    return lengths;
}

Box SurfaceMeasurer::measureBox(std::size_t block) const {
    Box box;
    for (std::size_t v = block * kBlock; v < std::min((block + 1) * kBlock, positions().size()); ++v) {
        box.add(glm::dvec3(positions()[v]));
    }
    return box;
}

SurfaceMeasures SurfaceMeasurer::measures() const {
    SurfaceMeasures sums;
    for (const Box& box : m_boxes) {
        sums.box.add(box);
    }
    for (const Spread& lengths : m_edges) {
        sums.edgeLength.add(lengths);
    }
    for (const FaceBlock& block : m_faces) {
        sums.faceArea.add(block.area);
        sums.aspect.add(block.aspect);
        sums.signedVolume += block.volume;
        sums.volumeMoment += block.moment;
        sums.degenerateFaces += block.degenerate;
        sums.flippedFaces += block.flipped;
    }
    sums.volumeMoment += sums.signedVolume * m_reference;
    return sums;
}

Displacements SurfaceMeasurer::displacements() const {
    struct Length {
        float length;
        std::uint32_t vertex;
    };
    std::vector<Length> found;
    found.reserve(m_listed.size());
    for (const std::uint32_t vertex : m_listed) {
        if (positions()[vertex] != m_mesh->positions[vertex]) {
            found.push_back(
                {static_cast<float>(distance(m_mesh->positions[vertex], positions()[vertex])), vertex});
        }
    }
    std::sort(found.begin(), found.end(), [](const Length& a, const Length& b) {
        return a.length != b.length ? a.length < b.length : a.vertex < b.vertex;
    });
    Displacements displacements;
    displacements.lengths.reserve(found.size());
    displacements.vertices.reserve(found.size());
    for (const Length& length : found) {
        displacements.lengths.push_back(length.length);
        displacements.vertices.push_back(length.vertex);
    }
    return displacements;
}

std::vector<FaceHarm> SurfaceMeasurer::harms(float stretchLimit, std::size_t most, std::size_t& found) const {
    std::vector<FaceHarm> harms;
    found = 0;
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
        const FaceBlock& block = m_faces[i];
        if (block.flipped > 0 || block.degenerated > 0 || block.stretch > stretchLimit) {
            listHarms(i, stretchLimit, most, harms, found);
        }
    }
    return harms;
}

void SurfaceMeasurer::listHarms(std::size_t block, float stretchLimit, std::size_t most,
                                std::vector<FaceHarm>& harms, std::size_t& found) const {
    FaceMeasurer measurer(m_mesh->positions);
    const std::size_t end = std::min((block + 1) * kBlock, m_mesh->faceCount());
    for (std::size_t f = block * kBlock; f < end; ++f) {
        const std::span<const std::uint32_t> face = m_mesh->face(f);
        const float stretch = stretchOf(face, m_mesh->positions, positions());
        const auto note = [&](FaceHarm::Kind kind) {
            if (++found <= most) {
                harms.push_back({static_cast<std::uint32_t>(f), kind, stretch});
            }
        };
        if (isFlipped(face, m_mesh->positions, positions())) {
            note(FaceHarm::Kind::Flipped);
        }
        if (isDegenerate(positions(), face, measurer) && !isDegenerate(m_mesh->positions, face, measurer)) {
            note(FaceHarm::Kind::Degenerated);
        }
        if (stretch > stretchLimit) {
            note(FaceHarm::Kind::Stretched);
        }
    }
}

Box SurfaceMeasurer::boxThrough(const glm::dmat3& rotation, const glm::dvec3& shift) const {
    return boxOf(positions(), rotation, shift);
}

Box SurfaceMeasurer::originalBoxThrough(const glm::dmat3& rotation, const glm::dvec3& shift) const {
    return boxOf(m_mesh->positions, rotation, shift);
}

}  // namespace hitscope
