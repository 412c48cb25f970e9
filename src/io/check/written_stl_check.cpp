// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/check/written_stl_check.h"

#include <QFile>
#include <cstring>

#include "core/give_up.h"
#include "io/check/written_check.h"
#include "io/check/written_surface_check.h"
#include "io/readers/text_cursor.h"
#include "io/writers/file_positions.h"
#include "io/writers/stl_facet.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

/// The normals of a file that we wrote, facet by facet.
class FacetNormals {
public:
    explicit FacetNormals(const QString& path) : m_file(path) {
        m_isOpen = m_file.open(QIODevice::ReadOnly);
        m_isText = m_isOpen && m_file.peek(5) == "solid";
        m_isOpen = m_isOpen && (m_isText || m_file.seek(kStlStart));
    }

    /// None: there is no further facet, or its normal is none.
    std::optional<glm::vec3> next() {
        if (!m_isOpen) {
            return std::nullopt;
        }
        return m_isText ? nextInText() : nextInBinary();
    }

private:
    std::optional<glm::vec3> nextInBinary() {
        const QByteArray facet = m_file.read(kStlFacetSize);
        std::array<float, 3> normal{};
        if (facet.size() != static_cast<qsizetype>(kStlFacetSize)) {
            return std::nullopt;
        }
        std::memcpy(normal.data(), facet.constData(), sizeof normal);
        return glm::vec3(normal[0], normal[1], normal[2]);
    }
    std::optional<glm::vec3> nextInText() {
        while (!m_file.atEnd()) {
            const QByteArray bytes = m_file.readLine();
            TextCursor line({bytes.constData(), static_cast<std::size_t>(bytes.size())});
            if (line.word() != "facet") {
                continue;
            }
            if (line.word() != "normal") {
                return std::nullopt;
            }
            glm::vec3 normal(0.0f);
            for (int i = 0; i < 3; ++i) {
                line.skipBlanks();
                const std::optional<double> number = line.number();
                if (!number) {
                    return std::nullopt;
                }
                normal[i] = static_cast<float>(*number);
            }
            return normal;
        }
        return std::nullopt;
    }

    QFile m_file;
    bool m_isText = false;
    bool m_isOpen = false;
};

/// Corner by corner: an STL file has no vertices that faces share.
class FacetComparison {
public:
    FacetComparison(const MeshData& read, const MeshExport& what, const QString& path)
        : m_read(read), m_path(path), m_positions(what), m_normals(path) {}

    Status facet(const MeshData& mesh, std::size_t f, const std::uint32_t* corners);

private:
    const MeshData& m_read;
    const QString& m_path;
    FilePositions m_positions;
    FacetNormals m_normals;
    std::size_t m_at = 0;  ///< corner that comes next
};

Status FacetComparison::facet(const MeshData& mesh, std::size_t f, const std::uint32_t* corners) {
    const std::string name = "triangle " + std::to_string(m_at / 3 + 1);
    StlFacet meant;
    for (std::size_t i = 0; i < 3; ++i, ++m_at) {
        const std::uint32_t vertex = m_read.cornerVertices[m_at];
        const glm::vec3 is =
            m_read.filePositions.empty() ? m_read.positions[vertex] : glm::vec3(m_read.filePositions[vertex]);
        meant[i] = glm::vec3(m_positions.now(mesh.face(f)[corners[i]]));
        if (is != meant[i]) {
            return notAsMeant(m_path, elsewhere("a corner of " + name, is, meant[i]));
        }
    }
    const std::optional<glm::vec3> normal = m_normals.next();
    if (!normal) {
        return notAsMeant(m_path, name + " has no normal");
    }
    return *normal == stlNormal(meant)
               ? Status(Done{})
               : Status(notAsMeant(m_path, otherVector(name, "normal", *normal, stlNormal(meant), 3)));
}

}  // namespace

Status verifyWrittenStl(const MeshData& read, const MeshExport& what, const QString& path,
                        const ExportGoOn& goOn) {
    const MeshData& mesh = *what.mesh;
    const std::size_t facets = mesh.cornerVertices.size() - 2 * mesh.faceCount();
    if (read.faceCount() != facets || read.cornerVertices.size() != 3 * facets) {
        return notAsMeant(path, "it has " + std::to_string(read.faceCount()) + " triangles and should have " +
                                    std::to_string(facets));
    }
    FacetComparison comparison(read, what, path);
    Triangulator triangulator;
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        tellPart(goOn, ExportStep::Comparing, f, mesh.faceCount());
        corners.clear();
        triangulator.triangulate(mesh.positions, mesh.face(f), corners);
        for (std::size_t t = 0; t + 3 <= corners.size(); t += 3) {
            if (Status same = comparison.facet(mesh, f, corners.data() + t); !same) {
                return same;
            }
        }
    }
    return Done{};
}

}  // namespace hitscope
