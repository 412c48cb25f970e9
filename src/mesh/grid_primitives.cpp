// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/grid_primitives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "mesh/face_corner.h"

namespace hitscope {

namespace {

MeshData named(const char* name) {
    MeshData mesh;
    mesh.name = name;
    mesh.faceStarts.push_back(0);
    return mesh;
}

std::uint32_t index(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

/// Unit vector in the xz plane: step `i` of `count` around y, from +z towards +x.
glm::dvec3 direction(int i, int count) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    return {std::sin(angle), 0.0, std::cos(angle)};
}

/// Texture coordinates of a grid with a point more each way than it has cells: columns fastest.
void addGridTexcoords(MeshData& mesh, int columns, int rows, glm::vec2 repeats) {
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            mesh.texcoords.emplace_back(repeats.x * static_cast<float>(column) / static_cast<float>(columns),
                                        repeats.y * static_cast<float>(row) / static_cast<float>(rows));
        }
    }
}

/// The end of a cylinder on the side of `up` (1 or -1), from its rim inwards.
class CylinderEnd {
public:
    CylinderEnd(MeshData& mesh, int around, int rings, float radius, float y, double up)
        : m_mesh(mesh), m_around(around), m_rings(rings), m_radius(radius), m_y(y), m_up(up) {}

    /// `rim`: its first vertex; the others follow it.
    void add(std::uint32_t rim) {
        m_normal = index(m_mesh.normals.size());
        m_mesh.normals.emplace_back(0.0f, m_up, 0.0f);
        m_texcoord = index(m_mesh.texcoords.size());
        m_inner = index(m_mesh.positions.size());
        m_rim = rim;
        for (int ring = 0; ring < m_rings; ++ring) {
            const double share = 1.0 - static_cast<double>(ring) / m_rings;
            for (int i = 0; i < m_around; ++i) {
                addPoint(share * direction(i, m_around), ring > 0);
            }
        }
        addPoint(glm::dvec3(0.0), true);
        for (int ring = 0; ring < m_rings; ++ring) {
            for (int i = 0; i < m_around; ++i) {
                addCell(ring, i, (i + 1) % m_around);
            }
        }
    }

private:
    void addPoint(const glm::dvec3& at, bool isNew) {
        if (isNew) {
            m_mesh.positions.emplace_back(at.x * m_radius, m_y, at.z * m_radius);
        }
        m_mesh.texcoords.emplace_back(0.5 + 0.5 * at.x, 0.5 - 0.5 * m_up * at.z);
    }

    [[nodiscard]] FaceCorner corner(int ring, int i) const {
        const std::uint32_t point = ring == m_rings ? index(static_cast<std::size_t>(m_rings * m_around))
                                                    : index(static_cast<std::size_t>(ring * m_around + i));
        const auto rimPoints = static_cast<std::uint32_t>(m_around);
        return {ring == 0 ? m_rim + point : m_inner + point - rimPoints, m_texcoord + point, m_normal};
    }

    void addCell(int ring, int i, int next) {
        std::vector<FaceCorner> corners{corner(ring, i), corner(ring, next), corner(ring + 1, next)};
        if (ring + 1 < m_rings) {
            corners.push_back(corner(ring + 1, i));
        }
        if (m_up < 0.0) {
            std::reverse(corners.begin(), corners.end());
        }
        addFace(m_mesh, corners);
    }

    MeshData& m_mesh;
    int m_around;
    int m_rings;
    float m_radius;
    float m_y;
    double m_up;
    std::uint32_t m_rim = 0;       ///< first vertex of the rim
    std::uint32_t m_inner = 0;     ///< first vertex inside it
    std::uint32_t m_texcoord = 0;  ///< that of the rim's first point
    std::uint32_t m_normal = 0;
};

}  // namespace

MeshData makeTorus(int around, int tube, float radius, float tubeRadius) {
    const int n = std::max(around, 3);
    const int m = std::max(tube, 3);
    MeshData mesh = named("Torus");
    for (int j = 0; j < m; ++j) {
        const double angle = 2.0 * std::numbers::pi * j / m;  // from the outer rim upwards
        for (int i = 0; i < n; ++i) {
            const glm::dvec3 out = direction(i, n);
            const glm::dvec3 normal = std::cos(angle) * out + glm::dvec3(0.0, std::sin(angle), 0.0);
            mesh.normals.emplace_back(normal);
            mesh.positions.emplace_back(static_cast<double>(radius) * out +
                                        static_cast<double>(tubeRadius) * normal);
        }
    }
    // Repeats that keep the picture's proportions.
    const float repeats = std::max(1.0f, std::round(radius / tubeRadius));
    addGridTexcoords(mesh, n, m, {repeats, 1.0f});
    const auto corner = [n, m](int i, int j) {
        const std::uint32_t vertex = static_cast<std::uint32_t>((j % m) * n + i % n);
        return FaceCorner{vertex, static_cast<std::uint32_t>(j * (n + 1) + i), vertex};
    };
    for (int j = 0; j < m; ++j) {
        for (int i = 0; i < n; ++i) {
            addFace(mesh, std::array{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    }
    return mesh;
}

MeshData makeCylinder(int around, int up, int rings, float radius, float height) {
    const int n = std::max(around, 3);
    const int rows = std::max(up, 1);
    MeshData mesh = named("Cylinder");
    for (int i = 0; i < n; ++i) {
        mesh.normals.emplace_back(direction(i, n));
    }
    for (int row = 0; row <= rows; ++row) {
        const double y = static_cast<double>(height) * (static_cast<double>(row) / rows - 0.5);
        for (int i = 0; i < n; ++i) {
            const glm::dvec3 out = static_cast<double>(radius) * direction(i, n);
            mesh.positions.emplace_back(out.x, y, out.z);
        }
    }
    addGridTexcoords(mesh, n, rows, {2.0f, 1.0f});
    const auto corner = [n](int i, int row) {
        return FaceCorner{static_cast<std::uint32_t>(row * n + i % n),
                          static_cast<std::uint32_t>(row * (n + 1) + i), static_cast<std::uint32_t>(i % n)};
    };
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < n; ++i) {
            addFace(mesh, std::array{corner(i, row), corner(i + 1, row), corner(i + 1, row + 1),
                                     corner(i, row + 1)});
        }
    }
    const int inwards = std::max(rings, 1);
    CylinderEnd(mesh, n, inwards, radius, -0.5f * height, -1.0).add(0);
    CylinderEnd(mesh, n, inwards, radius, 0.5f * height, 1.0).add(static_cast<std::uint32_t>(rows * n));
    return mesh;
}

MeshData makeSheet(int columns, int rows, float width, float height) {
    const int n = std::max(columns, 1);
    const int m = std::max(rows, 1);
    MeshData mesh = named("Sheet");
    mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    for (int row = 0; row <= m; ++row) {
        for (int column = 0; column <= n; ++column) {
            mesh.positions.emplace_back(static_cast<double>(width) * (static_cast<double>(column) / n - 0.5),
                                        static_cast<double>(height) * (static_cast<double>(row) / m - 0.5),
                                        0.0);
        }
    }
    addGridTexcoords(mesh, n, m, glm::vec2(1.0f));
    const auto corner = [n](int column, int row) {
        const std::uint32_t vertex = static_cast<std::uint32_t>(row * (n + 1) + column);
        return FaceCorner{vertex, vertex, 0};
    };
    for (int row = 0; row < m; ++row) {
        for (int column = 0; column < n; ++column) {
            addFace(mesh, std::array{corner(column, row), corner(column + 1, row),
                                     corner(column + 1, row + 1), corner(column, row + 1)});
        }
    }
    return mesh;
}

}  // namespace hitscope
