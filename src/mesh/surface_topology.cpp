// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_topology.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

#include "mesh/disjoint_sets.h"

namespace hitscope {

namespace {

struct PlaceHash {
    std::size_t operator()(const glm::vec3& place) const {
        // -0 equals 0, so it must hash alike.
        const auto bits = [](float part) { return std::uint64_t{std::bit_cast<std::uint32_t>(part + 0.0f)}; };
        std::uint64_t hash = bits(place.x) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ hash >> 29 ^ bits(place.y)) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ hash >> 32 ^ bits(place.z)) * 0x94d049bb133111ebu;
        return static_cast<std::size_t>(hash ^ hash >> 31);
    }
};

std::vector<bool> usedVertices(const MeshData& mesh) {
    std::vector<bool> used(mesh.vertexCount(), false);
    for (const std::uint32_t vertex : mesh.cornerVertices) {
        used[vertex] = true;
    }
    return used;
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
    std::unordered_map<glm::vec3, std::uint32_t, PlaceHash> places;
    places.reserve(mesh.vertexCount());
    for (std::uint32_t v = 0; v < standsFor.size(); ++v) {
        standsFor[v] = used[v] ? places.try_emplace(mesh.positions[v], v).first->second : v;
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
                                &SurfaceTopologyBuilder::gatherSides, &SurfaceTopologyBuilder::joinFaces,
                                &SurfaceTopologyBuilder::countFans, &SurfaceTopologyBuilder::conclude,
                                &SurfaceTopologyBuilder::indexFaces, &SurfaceTopologyBuilder::indexEdges}) {
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
        std::uint64_t edge = 0;  ///< lower place, higher place
        std::uint32_t face = 0;
        std::uint32_t lowCorner = 0;   ///< the face's corner at the lower place, numbered in m_cornerPlaces
        std::uint32_t highCorner = 0;  ///< likewise at the higher
        bool isUp = false;
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

    /// The sides of every face, sorted by edge. Corners in a row at one place are one.
    void gatherSides() {
        m_sides.reserve(m_mesh.cornerVertices.size());
        m_cornerPlaces.reserve(m_mesh.cornerVertices.size());
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
            if (places.size() < 3 || repeats(places)) {
                ++m_made.m_statistics.collapsedFaces;
            } else {
                addSides(f, places);
            }
        }
        std::sort(m_sides.begin(), m_sides.end(), [](const Side& a, const Side& b) {
            return a.edge != b.edge ? a.edge < b.edge : a.face < b.face;
        });
    }

    void addSides(std::uint32_t face, std::span<const std::uint32_t> places) {
        const auto first = static_cast<std::uint32_t>(m_cornerPlaces.size());
        const auto corners = static_cast<std::uint32_t>(places.size());
        for (std::uint32_t i = 0; i < corners; ++i) {
            const std::uint32_t next = i + 1 < corners ? i + 1 : 0;
            const bool isUp = places[i] < places[next];
            const std::uint32_t low = isUp ? i : next;
            const std::uint32_t high = isUp ? next : i;
            m_sides.push_back(
                {std::uint64_t{places[low]} << 32 | places[high], face, first + low, first + high, isUp});
        }
        m_cornerPlaces.insert(m_cornerPlaces.end(), places.begin(), places.end());
    }

    /// Goes through the edges once: counts them by their faces, and joins the faces that share one, both as
    /// wholes (components) and corner by corner (fans).
    void joinFaces() {
        SurfaceStatistics& statistics = m_made.m_statistics;
        DisjointSets faces(m_mesh.faceCount());
        m_fans = std::make_unique<DisjointSets>(m_cornerPlaces.size());
        m_isEdgeEnd.assign(m_mesh.vertexCount(), false);
        for (std::size_t begin = 0, end = 0; begin < m_sides.size(); begin = end) {
            while (end < m_sides.size() && m_sides[end].edge == m_sides[begin].edge) {
                ++end;
            }
            const std::span<const Side> sides = std::span(m_sides).subspan(begin, end - begin);
            const auto low = static_cast<std::uint32_t>(sides[0].edge >> 32);
            const auto high = static_cast<std::uint32_t>(sides[0].edge);
            m_made.m_edges.push_back({low, high});
            statistics.boundaryEdges += sides.size() == 1 ? 1 : 0;
            if (sides.size() > 2) {
                ++statistics.nonManifoldEdges;
                m_isEdgeEnd[low] = m_isEdgeEnd[high] = true;
            }
            for (const Side& side : sides.subspan(1)) {
                const bool opposed = side.isUp == sides[0].isUp;
                statistics.opposedEdges += opposed && sides.size() == 2 ? 1 : 0;
                const bool fits = faces.join(sides[0].face, side.face, opposed && sides.size() == 2);
                statistics.orientable = statistics.orientable && (fits || sides.size() > 2);
                m_fans->join(sides[0].lowCorner, side.lowCorner);
                m_fans->join(sides[0].highCorner, side.highCorner);
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
            const bool isShared = (i > 0 && m_sides[i - 1].edge == m_sides[i].edge) ||
                                  (i + 1 < m_sides.size() && m_sides[i + 1].edge == m_sides[i].edge);
            if (isShared) {
                continue;
            }
            for (const std::uint32_t corner : {m_sides[i].lowCorner, m_sides[i].highCorner}) {
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
        m_sides = {};
        m_cornerPlaces = {};
        m_fans.reset();
    }

    void indexFaces() {
        std::vector<std::uint32_t>& starts = m_made.m_faceStarts;
        starts.assign(m_mesh.vertexCount() + 1, 0);
        for (const std::uint32_t vertex : m_mesh.cornerVertices) {
            ++starts[vertex + 1];
        }
        accumulate(starts);
        m_made.m_faces.resize(m_mesh.cornerVertices.size());
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f) {
            for (const std::uint32_t vertex : m_mesh.face(f)) {
                m_made.m_faces[next[vertex]++] = f;
            }
        }
    }

    void indexEdges() {
        std::vector<std::uint32_t>& starts = m_made.m_edgeStarts;
        starts.assign(m_mesh.vertexCount() + 1, 0);
        for (const SurfaceTopology::Edge& edge : m_made.m_edges) {
            ++starts[edge.low + 1];
            ++starts[edge.high + 1];
        }
        accumulate(starts);
        m_made.m_vertexEdges.resize(2 * m_made.m_edges.size());
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        for (std::uint32_t e = 0; e < m_made.m_edges.size(); ++e) {
            m_made.m_vertexEdges[next[m_made.m_edges[e].low]++] = e;
            m_made.m_vertexEdges[next[m_made.m_edges[e].high]++] = e;
        }
    }

    static void accumulate(std::vector<std::uint32_t>& counts) {
        std::partial_sum(counts.begin(), counts.end(), counts.begin());
    }

    const MeshData& m_mesh;
    SurfaceTopology m_made;
    std::vector<std::uint32_t> m_standsFor;
    std::vector<Side> m_sides;
    std::vector<std::uint32_t> m_cornerPlaces;
    std::unique_ptr<DisjointSets> m_fans;  ///< of corners, joined where faces share an edge there
    std::vector<bool> m_isEdgeEnd;         ///< place is an end of a non-manifold edge
};

std::shared_ptr<const SurfaceTopology> SurfaceTopology::build(const MeshData& mesh,
                                                              const std::stop_token& stop) {
    return SurfaceTopologyBuilder(mesh).build(stop);
}

}  // namespace hitscope
