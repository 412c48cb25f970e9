// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_topology.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

#include "core/memory.h"
#include "mesh/disjoint_sets.h"

namespace hitscope {

namespace {

std::size_t hashOf(const glm::vec3& place) {
    // -0 equals 0, so it must hash alike.
    const auto bits = [](float part) { return std::uint64_t{std::bit_cast<std::uint32_t>(part + 0.0f)}; };
    std::uint64_t hash = bits(place.x) * 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 29 ^ bits(place.y)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 32 ^ bits(place.z)) * 0x94d049bb133111ebu;
    return static_cast<std::size_t>(hash ^ hash >> 31);
}

std::vector<bool> usedVertices(const MeshData& mesh) {
    std::vector<bool> used(mesh.vertexCount(), false);
    for (const std::uint32_t vertex : mesh.cornerVertices) {
        used[vertex] = true;
    }
    return used;
}

void accumulate(std::vector<std::uint32_t>& counts) {
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

bool repeats(std::vector<std::uint32_t> places) {
    std::sort(places.begin(), places.end());
    return std::adjacent_find(places.begin(), places.end()) != places.end();
}

}  // namespace

void SurfaceStatistics::add(const SurfaceStatistics& other) {
    const bool isWatertight =
        (faces == 0 || watertight) && (other.faces == 0 || other.watertight) && faces + other.faces > 0;
    const bool hasGenus = (components == 0 || genus) && (other.components == 0 || other.genus);
    if (hasGenus && components + other.components > 0) {
        genus = genus.value_or(0) + other.genus.value_or(0);
    } else {
        genus.reset();
    }
    watertight = isWatertight;
    orientable = orientable && other.orientable;
    vertices += other.vertices;
    unreferencedVertices += other.unreferencedVertices;
    places += other.places;
    edges += other.edges;
    faces += other.faces;
    triangles += other.triangles;
    quads += other.quads;
    largerPolygons += other.largerPolygons;
    collapsedFaces += other.collapsedFaces;
    boundaryEdges += other.boundaryEdges;
    holes += other.holes;
    components += other.components;
    nonManifoldEdges += other.nonManifoldEdges;
    nonManifoldVertices += other.nonManifoldVertices;
    opposedEdges += other.opposedEdges;
    eulerCharacteristic += other.eulerCharacteristic;
}

std::vector<std::uint32_t> weldedVertices(const MeshData& mesh) {
    const std::vector<bool> used = usedVertices(mesh);
    std::vector<std::uint32_t> standsFor(mesh.vertexCount());
    // Twice as many places as vertices or more, each empty or the first vertex there; who finds his taken by
    // another place goes on to the next. A map would take ten times the memory.
    const std::size_t mask = std::bit_ceil(2 * mesh.vertexCount() + 1) - 1;
    std::vector<std::uint32_t> places(mask + 1, kNoIndex);
    for (std::uint32_t v = 0; v < standsFor.size(); ++v) {
        standsFor[v] = v;
        if (used[v]) {
            std::size_t at = hashOf(mesh.positions[v]) & mask;
            while (places[at] != kNoIndex && mesh.positions[places[at]] != mesh.positions[v]) {
                at = (at + 1) & mask;
            }
            if (places[at] == kNoIndex) {
                places[at] = v;
            }
            standsFor[v] = places[at];
        }
    }
    return standsFor;
}

/// Makes a SurfaceTopology step by step.
class SurfaceTopologyBuilder {
public:
    explicit SurfaceTopologyBuilder(const MeshData& mesh) : m_mesh(mesh) {}

    [[nodiscard]] std::shared_ptr<const SurfaceTopology> build(const std::stop_token& stop) {
        using Step = void (SurfaceTopologyBuilder::*)();
        for (const Step step : {&SurfaceTopologyBuilder::count, &SurfaceTopologyBuilder::weld,
                                &SurfaceTopologyBuilder::gatherCorners, &SurfaceTopologyBuilder::sortSides,
                                &SurfaceTopologyBuilder::joinFaces, &SurfaceTopologyBuilder::countFans,
                                &SurfaceTopologyBuilder::conclude}) {
            if (stop.stop_requested()) {
                return nullptr;
            }
            (this->*step)();
        }
        return std::make_shared<const SurfaceTopology>(std::move(m_made));
    }

private:
    /// A face's way along an edge.
    struct Side {
        std::uint32_t low = 0;   ///< place
        std::uint32_t high = 0;  ///< place
        std::uint32_t face = 0;
        std::uint32_t lowCorner = 0;   ///< the face's corner at the lower place, numbered in m_cornerPlaces
        std::uint32_t highCorner = 0;  ///< likewise at the higher
        bool isUp = false;

        [[nodiscard]] bool hasEdgeOf(const Side& other) const {
            return low == other.low && high == other.high;
        }
    };
    /// What it is worked out from: a mesh of millions of faces has many.
    struct SideStart {
        std::uint32_t corner = 0;  ///< that it starts from, in m_cornerPlaces
        std::uint32_t face = 0;
    };

    void count() {
        SurfaceStatistics& statistics = m_made.m_statistics;
        const std::vector<bool> used = usedVertices(m_mesh);
        statistics.vertices = m_mesh.vertexCount();
        statistics.unreferencedVertices =
            static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
        statistics.faces = m_mesh.faceCount();
        for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
            const std::size_t corners = m_mesh.face(f).size();
            statistics.triangles += corners == 3 ? 1 : 0;
            statistics.quads += corners == 4 ? 1 : 0;
            statistics.largerPolygons += corners > 4 ? 1 : 0;
        }
    }

    void weld() { m_standsFor = weldedVertices(m_mesh); }

    /// The corners of every face that is not collapsed. Corners in a row at one place are one.
    void gatherCorners() {
        m_cornerPlaces.reserve(m_mesh.cornerVertices.size());
        m_cornerStarts.reserve(m_mesh.faceCount() + 1);
        std::vector<std::uint32_t> places;
        for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f) {
            places.clear();
            for (const std::uint32_t vertex : m_mesh.face(f)) {
                if (places.empty() || places.back() != m_standsFor[vertex]) {
                    places.push_back(m_standsFor[vertex]);
                }
            }
            while (places.size() > 1 && places.front() == places.back()) {
                places.pop_back();
            }
            m_cornerStarts.push_back(static_cast<std::uint32_t>(m_cornerPlaces.size()));
            if (places.size() < 3 || repeats(places)) {
                ++m_made.m_statistics.collapsedFaces;
            } else {
                m_cornerPlaces.insert(m_cornerPlaces.end(), places.begin(), places.end());
            }
        }
        m_cornerStarts.push_back(static_cast<std::uint32_t>(m_cornerPlaces.size()));
        freeAll(m_standsFor);
    }

    [[nodiscard]] Side sideAt(const SideStart& start) const {
        const std::uint32_t first = m_cornerStarts[start.face];
        const std::uint32_t end = m_cornerStarts[start.face + 1];
        const std::uint32_t next = start.corner + 1 < end ? start.corner + 1 : first;
        const std::uint32_t from = m_cornerPlaces[start.corner];
        const std::uint32_t to = m_cornerPlaces[next];
        return from < to ? Side{from, to, start.face, start.corner, next, true}
                         : Side{to, from, start.face, next, start.corner, false};
    }
    [[nodiscard]] Side side(std::size_t index) const { return sideAt(m_sides[index]); }

    /// The sides of these, sorted by lower place, then by higher, then by face.
    void sortSides() {
        std::vector<std::uint32_t> starts(m_mesh.vertexCount() + 2, 0);
        const auto forEachSide = [this](const auto& act) {
            for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f) {
                for (std::uint32_t corner = m_cornerStarts[f]; corner < m_cornerStarts[f + 1]; ++corner) {
                    act(SideStart{corner, f});
                }
            }
        };
        forEachSide([&](const SideStart& start) { ++starts[sideAt(start).low + 2]; });
        accumulate(starts);
        m_sides.resize(m_cornerPlaces.size());
        forEachSide([&](const SideStart& start) { m_sides[starts[sideAt(start).low + 1]++] = start; });
        std::size_t edges = 0;
        for (std::size_t place = 0; place < m_mesh.vertexCount(); ++place) {
            const auto run = std::span(m_sides).subspan(starts[place], starts[place + 1] - starts[place]);
            std::sort(run.begin(), run.end(), [this](const SideStart& a, const SideStart& b) {
                const std::uint32_t highA = sideAt(a).high;
                const std::uint32_t highB = sideAt(b).high;
                return highA != highB ? highA < highB : a.face < b.face;
            });
            for (std::size_t i = 0; i < run.size(); ++i) {
                edges += i == 0 || sideAt(run[i]).high != sideAt(run[i - 1]).high ? 1 : 0;
            }
        }
        m_made.m_edges.reserve(edges);
    }

    /// Goes through the edges once: counts them by their faces, and joins the faces that share one, both as
    /// wholes (components) and corner by corner (fans).
    void joinFaces() {
        SurfaceStatistics& statistics = m_made.m_statistics;
        DisjointSets faces(m_mesh.faceCount());
        m_fans = std::make_unique<DisjointSets>(m_cornerPlaces.size());
        m_isEdgeEnd.assign(m_mesh.vertexCount(), false);
        std::vector<Side> sides;
        for (std::size_t begin = 0, end = 0; begin < m_sides.size(); begin = end) {
            sides.clear();
            do {
                sides.push_back(side(end++));
            } while (end < m_sides.size() && side(end).hasEdgeOf(sides[0]));
            const Side& first = sides[0];
            m_made.m_edges.push_back({first.low, first.high});
            statistics.boundaryEdges += sides.size() == 1 ? 1 : 0;
            if (sides.size() > 2) {
                ++statistics.nonManifoldEdges;
                m_isEdgeEnd[first.low] = m_isEdgeEnd[first.high] = true;
            }
            for (const Side& other : std::span(sides).subspan(1)) {
                const bool opposed = other.isUp == first.isUp;
                statistics.opposedEdges += opposed && sides.size() == 2 ? 1 : 0;
                const bool fits = faces.join(first.face, other.face, opposed && sides.size() == 2);
                statistics.orientable = statistics.orientable && (fits || sides.size() > 2);
                m_fans->join(first.lowCorner, other.lowCorner);
                m_fans->join(first.highCorner, other.highCorner);
            }
        }
        statistics.edges = m_made.m_edges.size();
        statistics.components = faces.sets() - statistics.collapsedFaces;
    }

    /// A place where more than one fan of faces meets is not manifold. Boundary edges that end in the same
    /// fan follow one another round a hole.
    void countFans() {
        SurfaceStatistics& statistics = m_made.m_statistics;
        constexpr std::uint32_t kNone = kNoIndex;
        std::vector<std::uint32_t> fanAt(m_mesh.vertexCount(), kNone);
        std::vector<bool> isSplit(m_mesh.vertexCount(), false);
        for (std::uint32_t corner = 0; corner < m_cornerPlaces.size(); ++corner) {
            const std::uint32_t place = m_cornerPlaces[corner];
            const std::uint32_t fan = m_fans->find(corner).root;
            statistics.places += fanAt[place] == kNone ? 1 : 0;
            if (fanAt[place] == kNone) {
                fanAt[place] = fan;
            } else if (fanAt[place] != fan && !isSplit[place] && !m_isEdgeEnd[place]) {
                isSplit[place] = true;
                ++statistics.nonManifoldVertices;
            }
        }
        countHoles();
    }

    void countHoles() {
        std::unordered_map<std::uint32_t, std::uint32_t> edgeAtFan;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
        std::uint32_t edges = 0;
        for (std::size_t i = 0; i < m_sides.size(); ++i) {
            const Side alone = side(i);
            const bool isShared = (i > 0 && side(i - 1).hasEdgeOf(alone)) ||
                                  (i + 1 < m_sides.size() && side(i + 1).hasEdgeOf(alone));
            if (isShared) {
                continue;
            }
            for (const std::uint32_t corner : {alone.lowCorner, alone.highCorner}) {
                const auto [known, isNew] = edgeAtFan.try_emplace(m_fans->find(corner).root, edges);
                if (!isNew) {
                    joined.emplace_back(known->second, edges);
                }
            }
            ++edges;
        }
        DisjointSets lines(edges);
        for (const auto& pair : joined) {
            lines.join(pair.first, pair.second);
        }
        m_made.m_statistics.holes = lines.sets();
    }

    void conclude() {
        SurfaceStatistics& s = m_made.m_statistics;
        const auto number = [](std::size_t count) { return static_cast<long long>(count); };
        s.eulerCharacteristic = number(s.places) - number(s.edges) + number(s.faces - s.collapsedFaces);
        s.watertight = s.isManifold() && s.boundaryEdges == 0 && s.faces > s.collapsedFaces;
        if (s.isManifold() && s.orientable && s.components > 0) {
            // chi = 2 components - 2 genus - holes
            s.genus = (2 * number(s.components) - number(s.holes) - s.eulerCharacteristic) / 2;
        }
        freeAll(m_sides);
        freeAll(m_cornerPlaces);
        freeAll(m_cornerStarts);
        m_fans.reset();
    }

    const MeshData& m_mesh;
    SurfaceTopology m_made;
    std::vector<std::uint32_t> m_standsFor;
    std::vector<std::uint32_t> m_cornerPlaces;
    std::vector<std::uint32_t> m_cornerStarts;  ///< face -> its first of these; one more
    std::vector<SideStart> m_sides;
    std::unique_ptr<DisjointSets> m_fans;  ///< of corners, joined where faces share an edge there
    std::vector<bool> m_isEdgeEnd;         ///< place is an end of a non-manifold edge
};

std::shared_ptr<const SurfaceTopology> SurfaceTopology::build(const MeshData& mesh,
                                                              const std::stop_token& stop) {
    return SurfaceTopologyBuilder(mesh).build(stop);
}

SurfaceIndex::SurfaceIndex(const MeshData& mesh, const SurfaceTopology& topology) {
    m_faceStarts.assign(mesh.vertexCount() + 1, 0);
    for (const std::uint32_t vertex : mesh.cornerVertices) {
        ++m_faceStarts[vertex + 1];
    }
    accumulate(m_faceStarts);
    m_faces.resize(mesh.cornerVertices.size());
    std::vector<std::uint32_t> next(m_faceStarts.begin(), m_faceStarts.end() - 1);
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        for (const std::uint32_t vertex : mesh.face(f)) {
            m_faces[next[vertex]++] = f;
        }
    }
    const std::span<const SurfaceTopology::Edge> edges = topology.edges();
    m_edgeStarts.assign(mesh.vertexCount() + 1, 0);
    for (const SurfaceTopology::Edge& edge : edges) {
        ++m_edgeStarts[edge.low + 1];
        ++m_edgeStarts[edge.high + 1];
    }
    accumulate(m_edgeStarts);
    m_vertexEdges.resize(2 * edges.size());
    next.assign(m_edgeStarts.begin(), m_edgeStarts.end() - 1);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        m_vertexEdges[next[edges[e].low]++] = e;
        m_vertexEdges[next[edges[e].high]++] = e;
    }
}

}  // namespace hitscope
