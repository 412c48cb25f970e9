// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_topology.h"

#include <algorithm>
#include <numeric>

#include "mesh/surface/disjoint_sets.h"
#include "mesh/surface/welded_vertices.h"

namespace hitscope {

namespace {

void accumulate(std::vector<std::uint32_t>& counts) {
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

bool repeats(std::span<const std::uint32_t> places) {
    constexpr std::size_t kFew = 8;
    if (places.size() > kFew) {
        std::vector<std::uint32_t> sorted(places.begin(), places.end());
        std::sort(sorted.begin(), sorted.end());
        return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    }
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (std::find(places.begin(), places.begin() + i, places[i]) != places.begin() + i) {
            return true;
        }
    }
    return false;
}

/// Whether the way round a face turns back at a corner; no two in a row are at one place. Where it comes to a
/// place again without that, it does so along the bridge to a hole in the face.
bool turnsBack(std::span<const std::uint32_t> places) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] == places[(i + 2) % places.size()]) {
            return true;
        }
    }
    return false;
}

/// Of few that are joined, each pointing at another one of its set or at itself.
std::uint32_t rootOf(std::span<std::uint32_t> joined, std::uint32_t member) {
    while (joined[member] != member) {
        joined[member] = joined[joined[member]];
        member = joined[member];
    }
    return member;
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

/// Makes a SurfaceTopology step by step. What it holds meanwhile is bounded: the faces at the vertices, from
/// which edges and fans follow, are gathered for a part of the vertices at a time.
class SurfaceTopologyBuilder {
public:
    explicit SurfaceTopologyBuilder(const MeshData& mesh) : m_mesh(mesh), m_faces(mesh.faceCount()) {}

    [[nodiscard]] std::shared_ptr<const SurfaceTopology> build(const std::stop_token& stop) {
        constexpr std::size_t kParts = 8;
        constexpr std::size_t kFewest = 1 << 16;  // places in a part
        count();
        gatherCorners();
        const std::size_t places = m_mesh.vertexCount();
        const std::size_t step = std::max(kFewest, (places + kParts - 1) / kParts);
        // Nearly all edges have two faces.
        m_made.m_edges.reserve(m_cornerPlaces.size() / 2 + m_cornerPlaces.size() / 32);
        for (std::size_t begin = 0; begin < places; begin += step) {
            if (stop.stop_requested()) {
                return nullptr;
            }
            takePlaces(begin, std::min(begin + step, places));
        }
        conclude();
        return std::make_shared<const SurfaceTopology>(std::move(m_made));
    }

private:
    /// A face's corner at a place.
    struct Corner {
        std::uint32_t index = 0;  ///< in m_cornerPlaces
        std::uint32_t face = 0;
    };
    /// A face's side at the place that is looked at.
    struct Side {
        std::uint32_t other = 0;  ///< the place at its other end
        std::uint32_t corner =
            0;               ///< of the face, numbered among those at the place, which go by their faces
        bool isOut = false;  ///< the face's way is from here to there
    };

    void count();
    void gatherCorners();
    void countPlaces(std::span<const std::uint32_t> standsFor);
    [[nodiscard]] bool isPlain(std::span<const std::uint32_t> standsFor) const;
    void takePlaces(std::size_t begin, std::size_t end);
    void takePlace(std::uint32_t place, std::span<const Corner> corners);
    void listSides(std::span<const Corner> corners);
    void takeEdge(std::uint32_t place, std::span<const Corner> corners, std::span<const Side> sides);
    void takeBoundary(const SurfaceTopology::Edge& edge, std::uint32_t corner);
    void countFans(std::size_t corners);
    void conclude();

    const MeshData& m_mesh;
    SurfaceTopology m_made;
    /// The corners of every face that is not collapsed; the mesh's own, where nothing is welded.
    std::span<const std::uint32_t> m_cornerPlaces;
    std::span<const std::uint32_t> m_cornerStarts;  ///< face -> its first of these; one more
    std::vector<std::uint32_t> m_ownPlaces;
    std::vector<std::uint32_t> m_ownStarts;
    std::size_t m_places = 0;               ///< that these are at
    DisjointSets m_faces;                   ///< joined where they share an edge
    std::vector<std::uint32_t> m_boundary;  ///< numbers of edges of one face, ascending
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_neighbours;  ///< of m_boundary, round a hole
    // Of the place that is looked at.
    std::vector<Side> m_sides;
    std::vector<std::uint32_t> m_fans;      ///< a corner -> one of the same fan, or itself
    std::vector<std::uint32_t> m_fanEdges;  ///< a corner that stands for a fan -> an index into m_boundary
    bool m_isEdgeEnd = false;               ///< of an edge of three faces or more
};

void SurfaceTopologyBuilder::count() {
    SurfaceStatistics& statistics = m_made.m_statistics;
    const std::vector<bool> used = usedVertices(m_mesh);
    statistics.vertices = m_mesh.vertexCount();
    statistics.unreferencedVertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
    statistics.faces = m_mesh.faceCount();
    for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
        const std::size_t corners = m_mesh.face(f).size();
        statistics.triangles += corners == 3 ? 1 : 0;
        statistics.quads += corners == 4 ? 1 : 0;
        statistics.largerPolygons += corners > 4 ? 1 : 0;
    }
}

/// Nothing is welded, and no face collapsed.
bool SurfaceTopologyBuilder::isPlain(std::span<const std::uint32_t> standsFor) const {
    for (std::uint32_t v = 0; v < standsFor.size(); ++v) {
        if (standsFor[v] != v) {
            return false;
        }
    }
    for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
        if (repeats(m_mesh.face(f))) {
            return false;
        }
    }
    return true;
}

/// Vertices that no face uses stand for themselves.
void SurfaceTopologyBuilder::countPlaces(std::span<const std::uint32_t> standsFor) {
    SurfaceStatistics& statistics = m_made.m_statistics;
    for (std::uint32_t v = 0; v < standsFor.size(); ++v) {
        statistics.places += standsFor[v] == v ? 1 : 0;
    }
    statistics.places -= statistics.unreferencedVertices;
}

/// Corners in a row at one place are one.
void SurfaceTopologyBuilder::gatherCorners() {
    const std::vector<std::uint32_t> standsFor = weldedVertices(m_mesh);
    countPlaces(standsFor);
    if (isPlain(standsFor)) {
        m_cornerPlaces = m_mesh.cornerVertices;
        m_cornerStarts = m_mesh.faceStarts;
        return;
    }
    m_ownPlaces.reserve(m_mesh.cornerVertices.size());
    m_ownStarts.reserve(m_mesh.faceCount() + 1);
    std::vector<std::uint32_t> places;
    for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f) {
        places.clear();
        for (const std::uint32_t vertex : m_mesh.face(f)) {
            if (places.empty() || places.back() != standsFor[vertex]) {
                places.push_back(standsFor[vertex]);
            }
        }
        while (places.size() > 1 && places.front() == places.back()) {
            places.pop_back();
        }
        m_ownStarts.push_back(static_cast<std::uint32_t>(m_ownPlaces.size()));
        if (places.size() < 3 || turnsBack(places)) {
            ++m_made.m_statistics.collapsedFaces;
        } else {
            m_ownPlaces.insert(m_ownPlaces.end(), places.begin(), places.end());
        }
    }
    m_ownStarts.push_back(static_cast<std::uint32_t>(m_ownPlaces.size()));
    m_cornerPlaces = m_ownPlaces;
    m_cornerStarts = m_ownStarts;
}

/// Places [begin, end), in their order.
void SurfaceTopologyBuilder::takePlaces(std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> starts(end - begin + 1, 0);
    const auto isHere = [&](std::uint32_t place) { return place >= begin && place < end; };
    for (const std::uint32_t place : m_cornerPlaces) {
        if (isHere(place)) {
            ++starts[place - begin + 1];
        }
    }
    accumulate(starts);
    std::vector<Corner> corners(starts.back());
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f) {
        for (std::uint32_t corner = m_cornerStarts[f]; corner < m_cornerStarts[f + 1]; ++corner) {
            if (isHere(m_cornerPlaces[corner])) {
                corners[next[m_cornerPlaces[corner] - begin]++] = {corner, f};
            }
        }
    }
    for (std::size_t i = 0; i < end - begin; ++i) {
        if (starts[i] < starts[i + 1]) {
            takePlace(static_cast<std::uint32_t>(begin + i),
                      std::span(corners).subspan(starts[i], starts[i + 1] - starts[i]));
        }
    }
}

/// Both sides of each corner, by the place at their other end, then by face.
void SurfaceTopologyBuilder::listSides(std::span<const Corner> corners) {
    m_sides.clear();
    for (std::uint32_t c = 0; c < corners.size(); ++c) {
        const std::uint32_t first = m_cornerStarts[corners[c].face];
        const std::uint32_t last = m_cornerStarts[corners[c].face + 1] - 1;
        const std::uint32_t at = corners[c].index;
        m_sides.push_back({m_cornerPlaces[at < last ? at + 1 : first], c, true});
        m_sides.push_back({m_cornerPlaces[at > first ? at - 1 : last], c, false});
    }
    std::sort(m_sides.begin(), m_sides.end(), [](const Side& a, const Side& b) {
        return a.other != b.other ? a.other < b.other : a.corner < b.corner;
    });
}

void SurfaceTopologyBuilder::takePlace(std::uint32_t place, std::span<const Corner> corners) {
    ++m_places;
    listSides(corners);
    m_fans.resize(corners.size());
    std::iota(m_fans.begin(), m_fans.end(), 0u);
    m_fanEdges.assign(corners.size(), kNoIndex);
    m_isEdgeEnd = false;
    const auto forEachEdge = [this](const auto& act) {
        for (std::size_t begin = 0, end = 0; begin < m_sides.size(); begin = end) {
            while (end < m_sides.size() && m_sides[end].other == m_sides[begin].other) {
                ++end;
            }
            act(std::span<const Side>(m_sides).subspan(begin, end - begin));
        }
    };
    forEachEdge([&](std::span<const Side> sides) { takeEdge(place, corners, sides); });
    forEachEdge([&](std::span<const Side> sides) {
        if (sides.size() == 1) {
            takeBoundary({std::min(place, sides[0].other), std::max(place, sides[0].other)}, sides[0].corner);
        }
    });
    countFans(corners.size());
}

/// Joins the faces that share an edge, corner by corner (fans), and at its lower end as wholes (components).
void SurfaceTopologyBuilder::takeEdge(std::uint32_t place, std::span<const Corner> corners,
                                      std::span<const Side> sides) {
    m_isEdgeEnd = m_isEdgeEnd || sides.size() > 2;
    for (const Side& other : sides.subspan(1)) {
        m_fans[rootOf(m_fans, other.corner)] = rootOf(m_fans, sides[0].corner);
    }
    if (place > sides[0].other) {
        return;
    }
    SurfaceStatistics& statistics = m_made.m_statistics;
    if (sides.size() == 1) {
        ++statistics.boundaryEdges;
        m_boundary.push_back(static_cast<std::uint32_t>(m_made.m_edges.size()));
    }
    m_made.m_edges.push_back({place, sides[0].other});
    statistics.nonManifoldEdges += sides.size() > 2 ? 1 : 0;
    for (const Side& other : sides.subspan(1)) {
        const bool opposed = other.isOut == sides[0].isOut;
        statistics.opposedEdges += opposed && sides.size() == 2 ? 1 : 0;
        const bool fits = m_faces.join(corners[sides[0].corner].face, corners[other.corner].face,
                                       opposed && sides.size() == 2);
        statistics.orientable = statistics.orientable && (fits || sides.size() > 2);
    }
}

/// Boundary edges that end in the same fan follow one another round a hole. Those that end here begin here
/// or at a place that was taken before.
void SurfaceTopologyBuilder::takeBoundary(const SurfaceTopology::Edge& edge, std::uint32_t corner) {
    const auto& edges = m_made.m_edges;
    const auto at = std::lower_bound(m_boundary.begin(), m_boundary.end(), edge,
                                     [&edges](std::uint32_t number, const SurfaceTopology::Edge& wanted) {
                                         const SurfaceTopology::Edge& other = edges[number];
                                         return other.low != wanted.low ? other.low < wanted.low
                                                                        : other.high < wanted.high;
                                     });
    const auto number = static_cast<std::uint32_t>(at - m_boundary.begin());
    std::uint32_t& known = m_fanEdges[rootOf(m_fans, corner)];
    if (known == kNoIndex) {
        known = number;
    } else {
        m_neighbours.emplace_back(known, number);
    }
}

/// A place where more than one fan of faces meets is not manifold.
void SurfaceTopologyBuilder::countFans(std::size_t corners) {
    std::size_t fans = 0;
    for (std::uint32_t c = 0; c < corners; ++c) {
        fans += m_fans[c] == c ? 1 : 0;
    }
    m_made.m_statistics.nonManifoldVertices += fans > 1 && !m_isEdgeEnd ? 1 : 0;
}

void SurfaceTopologyBuilder::conclude() {
    SurfaceStatistics& s = m_made.m_statistics;
    s.edges = m_made.m_edges.size();
    s.components = m_faces.sets() - s.collapsedFaces;
    DisjointSets lines(m_boundary.size());
    for (const auto& [one, other] : m_neighbours) {
        lines.join(one, other);
    }
    s.holes = lines.sets();
    const auto number = [](std::size_t count) { return static_cast<long long>(count); };
    s.eulerCharacteristic = number(m_places) - number(s.edges) + number(s.faces - s.collapsedFaces);
    s.watertight = s.isManifold() && s.boundaryEdges == 0 && s.faces > s.collapsedFaces;
    if (s.isManifold() && s.orientable && s.components > 0) {
        // chi = 2 components - 2 genus - holes
        s.genus = (2 * number(s.components) - number(s.holes) - s.eulerCharacteristic) / 2;
    }
}

std::shared_ptr<const SurfaceTopology> SurfaceTopology::build(const MeshData& mesh,
                                                              const std::stop_token& stop) {
    return SurfaceTopologyBuilder(mesh).build(stop);
}

}  // namespace hitscope
