// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/teapot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace hitscope {
namespace {

// Newell's 32 bicubic patches, in the customary proportions (height 3.15). The published list of 306 control
// points is highly regular, and is written here by its rules. The pot, the lid and the bottom are turned
// about the axis: each row of a patch is a quarter of a circle of some radius, control points (r, 0) (r, c)
// (c, r) (0, r). The handle and the spout are mirrored: each row is half a cross section from an inner to an
// outer point, control points (inner, 0) (inner, w) (outer, w) (outer, 0). Rows run along the part, so that
// row x column points inwards: column x row, outwards.

/// A row of a turned patch.
struct Circle {
    double radius;
    double height;
    double bulge;  ///< c above
};

/// A row of a mirrored patch, in the plane of symmetry.
struct Section {
    double innerX, innerHeight;
    double outerX, outerHeight;
    double halfWidth;
};

constexpr Circle circle(double radius, double height) {
    return {radius, height, 0.56 * radius};
}

/// From the rim's inner edge over the rim, down the body and to the middle of the bottom: four patches.
constexpr std::array<Circle, 13> kPot{
    {circle(1.4, 2.4), circle(1.3375, 2.53125), circle(1.4375, 2.53125), circle(1.5, 2.4),
     circle(1.75, 1.875), circle(2.0, 1.35), circle(2.0, 0.9), circle(2.0, 0.45), circle(1.5, 0.225),
     circle(1.5, 0.15), circle(1.5, 0.075), circle(1.425, 0.0), circle(0.0, 0.0)}};
/// From the top of the knob to the lid's edge: two patches. The knob's bulge is 0.45 in the published data.
constexpr std::array<Circle, 7> kLid{{circle(0.0, 3.15),
                                      {0.8, 3.15, 0.45},
                                      circle(0.0, 2.85),
                                      circle(0.2, 2.7),
                                      circle(0.4, 2.55),
                                      circle(1.3, 2.55),
                                      circle(1.3, 2.4)}};
/// From the body's top to its side: two patches.
constexpr std::array<Section, 7> kHandle{{{-1.6, 2.025, -1.5, 2.25, 0.3},
                                          {-2.3, 2.025, -2.5, 2.25, 0.3},
                                          {-2.7, 2.025, -3.0, 2.25, 0.3},
                                          {-2.7, 1.8, -3.0, 1.8, 0.3},
                                          {-2.7, 1.575, -3.0, 1.35, 0.3},
                                          {-2.5, 1.125, -2.65, 0.9375, 0.3},
                                          {-2.0, 0.9, -1.9, 0.6, 0.3}}};
/// From inside the body to the tip and a little way back inside: two patches.
constexpr std::array<Section, 7> kSpout{{{1.7, 1.425, 1.7, 0.6, 0.66},
                                         {2.6, 1.425, 3.1, 0.825, 0.66},
                                         {2.3, 2.1, 2.4, 2.025, 0.25},
                                         {2.7, 2.4, 3.3, 2.4, 0.25},
                                         {2.8, 2.475, 3.525, 2.49375, 0.25},
                                         {2.9, 2.475, 3.45, 2.5125, 0.15},
                                         {2.8, 2.4, 3.2, 2.4, 0.15}}};

using Row = std::array<glm::dvec3, 4>;  ///< control points of one sector, y up

/// A part of the teapot: patches that follow each other along it, the same in each sector around it.
struct Part {
    const char* name;
    std::vector<Row> rows;  ///< 3 * patches + 1
    int sectors;            ///< 4: quarter turns about y; 2: halves mirrored in the plane z = 0
};

Part turnedPart(const char* name, std::span<const Circle> circles) {
    Part part{name, {}, 4};
    for (const Circle& c : circles) {
        part.rows.push_back({{{c.radius, c.height, 0.0},
                              {c.radius, c.height, c.bulge},
                              {c.bulge, c.height, c.radius},
                              {0.0, c.height, c.radius}}});
    }
    return part;
}

Part mirroredPart(const char* name, std::span<const Section> sections) {
    Part part{name, {}, 2};
    for (const Section& s : sections) {
        part.rows.push_back({{{s.innerX, s.innerHeight, 0.0},
                              {s.innerX, s.innerHeight, s.halfWidth},
                              {s.outerX, s.outerHeight, s.halfWidth},
                              {s.outerX, s.outerHeight, 0.0}}});
    }
    return part;
}

struct Weights {
    std::array<double, 4> value, slope;
};

/// Bernstein polynomials of degree three and their derivatives at t.
Weights bernstein(double t) {
    const double s = 1.0 - t;
    return {{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t},
            {-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t}};
}

struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};  ///< outwards, not unit; zero where the patch collapses
};

/// The first sector's surface at `across` in [0, 1], `along` the part in [0, patches].
SurfacePoint evaluate(const Part& part, double along, double across) {
    const int patches = static_cast<int>(part.rows.size()) / 3;
    const int patch = std::min(static_cast<int>(along), patches - 1);
    const Weights rowWeights = bernstein(along - patch);
    const Weights columnWeights = bernstein(across);
    SurfacePoint point;
    glm::dvec3 alongSlope(0.0);
    glm::dvec3 acrossSlope(0.0);
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            const glm::dvec3& control = part.rows[static_cast<std::size_t>(3 * patch) + row][column];
            point.position += rowWeights.value[row] * columnWeights.value[column] * control;
            alongSlope += rowWeights.slope[row] * columnWeights.value[column] * control;
            acrossSlope += rowWeights.value[row] * columnWeights.slope[column] * control;
        }
    }
    point.normal = glm::cross(acrossSlope, alongSlope);
    return point;
}

glm::dvec3 inSector(const Part& part, int sector, const glm::dvec3& v) {
    if (part.sectors == 2) {
        return sector == 0 ? v : glm::dvec3(v.x, v.y, -v.z);
    }
    glm::dvec3 result = v;
    for (int turn = 0; turn < sector; ++turn) {
        result = {-result.z, result.y, result.x};
    }
    return result;
}

/// Builds one part's vertices and faces into the mesh. Columns go once around; shared patch edges are welded
/// because neighbouring patches name the same row or column.
class PartBuilder {
public:
    PartBuilder(MeshData& mesh, const Part& part, int divisions)
        : m_mesh(mesh),
          m_part(part),
          m_divisions(divisions),
          m_rows(divisions * static_cast<int>(part.rows.size() / 3)),
          m_columns(divisions * part.sectors) {}

    void build() {
        m_mesh.groups.push_back(
            {FaceGroup::Kind::Group, m_part.name, static_cast<std::uint32_t>(m_mesh.faceCount())});
        for (int row = 0; row <= m_rows; ++row) {
            addRow(row);
        }
        for (int row = 0; row < m_rows; ++row) {
            for (int column = 0; column < m_columns; ++column) {
                addFace(row, column);
            }
        }
    }

private:
    [[nodiscard]] bool isPole(int row) const {
        const std::size_t controlRow = row == 0 ? 0 : m_part.rows.size() - 1;
        return (row == 0 || row == m_rows) &&
               m_part.rows[controlRow].front() == m_part.rows[controlRow].back();
    }

    [[nodiscard]] SurfacePoint at(double along, int column) const {
        const int sector = column / m_divisions;
        const int step = column % m_divisions;
        // The mirrored half runs backwards, from the outer points to the inner ones.
        const bool isBackwards = m_part.sectors == 2 && sector == 1;
        const double across = static_cast<double>(isBackwards ? m_divisions - step : step) / m_divisions;
        const SurfacePoint point = evaluate(m_part, along, across);
        return {inSector(m_part, sector, point.position), inSector(m_part, sector, point.normal)};
    }

    void addVertex(const glm::dvec3& position, const glm::dvec3& normal) {
        m_mesh.positions.emplace_back(position);
        m_mesh.normals.emplace_back(glm::normalize(normal));
    }

    void addRow(int row) {
        m_firstOfRow.push_back(static_cast<std::uint32_t>(m_mesh.positions.size()));
        const double along = static_cast<double>(row) / m_divisions;
        if (isPole(row)) {
            // The derivative across is zero here: the normal is the mean of those close by.
            const double nearby = along + (row == 0 ? 1e-3 : -1e-3);
            glm::dvec3 normal(0.0);
            for (int column = 0; column < m_columns; ++column) {
                normal += glm::normalize(at(nearby, column).normal);
            }
            addVertex(at(along, 0).position, normal);
            return;
        }
        for (int column = 0; column < m_columns; ++column) {
            const SurfacePoint point = at(along, column);
            addVertex(point.position, point.normal);
        }
    }

    void addCorner(int row, int column, std::uint32_t texcoord) {
        const std::uint32_t vertex = m_firstOfRow[static_cast<std::size_t>(row)] +
                                     static_cast<std::uint32_t>(isPole(row) ? 0 : column % m_columns);
        m_mesh.cornerVertices.push_back(vertex);
        m_mesh.cornerNormals.push_back(vertex);
        m_mesh.cornerTexcoords.push_back(texcoord);
    }

    void addFace(int row, int column) {
        const int u = column % m_divisions;
        const int v = row % m_divisions;
        const auto grid = [this](int across, int along) {
            return static_cast<std::uint32_t>(along * (m_divisions + 1) + across);
        };
        const std::uint32_t firstPole = grid(0, m_divisions + 1);
        if (isPole(row)) {
            addCorner(row, column, firstPole + static_cast<std::uint32_t>(u));
        } else {
            addCorner(row, column, grid(u, v));
            addCorner(row, column + 1, grid(u + 1, v));
        }
        if (isPole(row + 1)) {
            addCorner(row + 1, column, firstPole + static_cast<std::uint32_t>(m_divisions + u));
        } else {
            addCorner(row + 1, column + 1, grid(u + 1, v + 1));
            addCorner(row + 1, column, grid(u, v + 1));
        }
        m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(m_mesh.cornerVertices.size()));
    }

    MeshData& m_mesh;
    const Part& m_part;
    int m_divisions;
    int m_rows;
    int m_columns;
    std::vector<std::uint32_t> m_firstOfRow;
};

/// One grid serves all patches. Both coordinates run against the control points, so that pictures stand
/// upright and are not mirrored. Behind the grid: the points of the triangles at a pole, those at the start
/// of a part first.
std::vector<glm::vec2> patchTexcoords(int divisions) {
    std::vector<glm::vec2> texcoords;
    for (int along = 0; along <= divisions; ++along) {
        for (int across = 0; across <= divisions; ++across) {
            texcoords.emplace_back(1.0 - static_cast<double>(across) / divisions,
                                   1.0 - static_cast<double>(along) / divisions);
        }
    }
    for (const double v : {1.0, 0.0}) {
        for (int across = 0; across < divisions; ++across) {
            texcoords.emplace_back(1.0 - (across + 0.5) / divisions, v);
        }
    }
    return texcoords;
}

}  // namespace

MeshData makeTeapot(int divisions) {
    const int steps = std::max(divisions, 1);
    MeshData mesh;
    mesh.name = "Teapot";
    mesh.faceStarts.push_back(0);
    mesh.texcoords = patchTexcoords(steps);
    for (const Part& part : {turnedPart("pot", kPot), turnedPart("lid", kLid),
                             mirroredPart("handle", kHandle), mirroredPart("spout", kSpout)}) {
        PartBuilder(mesh, part, steps).build();
    }
    return mesh;
}

}  // namespace hitscope
