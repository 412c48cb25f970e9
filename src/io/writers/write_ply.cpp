// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFileInfo>
#include <algorithm>
#include <new>
#include <utility>

#include "core/give_up.h"
#include "io/export_files.h"
#include "io/export_names.h"
#include "io/writers/coordinate_check.h"
#include "io/writers/line_segments.h"
#include "io/writers/ply_copy.h"

namespace hitscope {
namespace {

/// A value for each vertex where all its corners have the same; empty: some have several, or none has any.
std::vector<std::uint32_t> onePerVertex(const MeshData& mesh, const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> values(mesh.positions.size(), kNoIndex);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        mayGiveUp(c);
        std::uint32_t& value = values[mesh.cornerVertices[c]];
        if (corners[c] == kNoIndex || (value != kNoIndex && value != corners[c])) {
            return {};
        }
        value = corners[c];
    }
    return corners.empty() ? std::vector<std::uint32_t>() : values;
}

/// Likewise of normals: the first corner of each vertex.
std::vector<std::uint32_t> oneNormalPerVertex(const MeshData& mesh, std::span<const glm::vec3> normals) {
    std::vector<std::uint32_t> first(mesh.positions.size(), kNoIndex);
    for (std::size_t c = 0; c < normals.size(); ++c) {
        mayGiveUp(c);
        std::uint32_t& corner = first[mesh.cornerVertices[c]];
        corner = corner == kNoIndex ? static_cast<std::uint32_t>(c) : corner;
        if (!sameBits(normals[corner], normals[c])) {
            return {};
        }
    }
    return normals.empty() ? std::vector<std::uint32_t>() : first;
}

bool hasMoreThanTexture(const Material& material) {
    return material.diffuse != glm::vec3(1.0f) || material.opacity != 1.0f ||
           !material.normalMap.texture.empty() || material.normalMap.image >= 0 ||
           material.metalRoughness.isGiven();
}

/// A mesh as a PLY file of its own.
class WholePly {
public:
    WholePly(const MeshExport& what, const PlyOptions& options, std::string texture)
        : m_what(what),
          m_mesh(*what.mesh),
          m_texture(std::move(texture)),
          m_positions(what),
          m_values(options.encoding == PlyOptions::Encoding::Ascii ? PlyEncoding::Ascii
                                                                   : PlyEncoding::LittleEndian),
          m_added(what, options),
          m_type(m_positions.fitFloatsMoved() ? PlyType::Float32 : PlyType::Float64),
          m_normals(oneNormalPerVertex(m_mesh, what.normals)),
          m_texcoords(onePerVertex(m_mesh, m_mesh.cornerTexcoords)),
          m_hasFaceTexcoords(!m_mesh.cornerTexcoords.empty() && m_texcoords.empty()),
          m_segments(lineSegments(m_mesh)) {
        for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
            m_largest = std::max(m_largest, m_mesh.face(f).size());
        }
    }

    void write(PieceWriter& out) const;
    [[nodiscard]] QStringList notes() const;

private:
    [[nodiscard]] std::string header() const;
    void vertex(std::string& text, std::size_t v) const;
    void face(std::string& text, std::size_t f) const;
    void edge(std::string& text, std::size_t e) const;
    [[nodiscard]] PlyType countType() const { return m_largest < 128 ? PlyType::Uint8 : PlyType::Int32; }
    [[nodiscard]] PlyType texcoordCountType() const {
        return 2 * m_largest < 256 ? PlyType::Uint8 : PlyType::Int32;
    }
    [[nodiscard]] PlyType indexType() const {
        return m_mesh.positions.size() < 0x80000000u ? PlyType::Int32 : PlyType::Uint32;
    }

    const MeshExport& m_what;
    const MeshData& m_mesh;
    std::string m_texture;  ///< as the file names it; empty: there is none
    FilePositions m_positions;
    PlyValues m_values;
    PlyAdded m_added;
    PlyType m_type;
    std::vector<std::uint32_t> m_normals;    ///< a corner for each vertex, or empty
    std::vector<std::uint32_t> m_texcoords;  ///< one for each vertex, or empty
    bool m_hasFaceTexcoords;
    std::vector<std::uint32_t> m_segments;  ///< of lines, 2 vertices each
    std::size_t m_largest = 3;              ///< corners of a face
};

std::string WholePly::header() const {
    std::string text = std::string("ply\nformat ") + (m_values.isAscii() ? "ascii" : "binary_little_endian") +
                       " 1.0\ncomment Written by Hitscope " HITSCOPE_VERSION "\n";
    if (!m_texture.empty() && !m_mesh.cornerTexcoords.empty()) {
        text += "comment TextureFile " + m_texture + '\n';
    }
    const auto add = [&text](PlyType type, std::initializer_list<const char*> names) {
        for (const char* const name : names) {
            text += plyLine({name, type, false, PlyType::Uint8}) + '\n';
        }
    };
    const auto addList = [&text](PlyType count, const PlyProperty& property) {
        const std::string line = plyLine(property);
        const std::string countName = plyLine({{}, count, false, PlyType::Uint8});
        text += "property list" + countName.substr(8) + line.substr(9) + '\n';
    };
    text += "element vertex " + std::to_string(m_mesh.positions.size()) + '\n';
    add(m_type, {"x", "y", "z"});
    if (!m_normals.empty()) {
        add(PlyType::Float32, {"nx", "ny", "nz"});
    }
    if (!m_texcoords.empty()) {
        add(PlyType::Float32, {"s", "t"});
    }
    if (!m_mesh.colours.empty()) {
        add(PlyType::Uint8, {"red", "green", "blue"});
    }
    for (const PlyProperty& property : m_added.properties()) {
        text += plyLine(property) + '\n';
    }
    text += "element face " + std::to_string(m_mesh.faceCount()) + '\n';
    addList(countType(), {"vertex_indices", indexType(), true, countType()});
    if (m_hasFaceTexcoords) {
        addList(texcoordCountType(), {"texcoord", PlyType::Float32, true, texcoordCountType()});
    }
    if (!m_segments.empty()) {
        text += "element edge " + std::to_string(m_segments.size() / 2) + '\n';
        add(indexType(), {"vertex1", "vertex2"});
    }
    return text + "end_header\n";
}

void WholePly::vertex(std::string& text, std::size_t v) const {
    const glm::dvec3 now = m_positions.now(v);
    for (int i = 0; i < 3; ++i) {
        m_values.append(text, m_type, now[i]);
    }
    for (int i = 0; !m_normals.empty() && i < 3; ++i) {
        const std::uint32_t corner = m_normals[v];
        m_values.append(text, PlyType::Float32, corner == kNoIndex ? 0.0f : m_what.normals[corner][i]);
    }
    for (int i = 0; !m_texcoords.empty() && i < 2; ++i) {
        const std::uint32_t index = m_texcoords[v];
        m_values.append(text, PlyType::Float32, index == kNoIndex ? 0.0f : m_mesh.texcoords[index][i]);
    }
    for (int i = 0; !m_mesh.colours.empty() && i < 3; ++i) {
        m_values.append(text, PlyType::Uint8, 255.0f * m_mesh.colours[v][i]);
    }
    m_added.append(text, m_values, v);
    m_values.endRecord(text);
}

void WholePly::face(std::string& text, std::size_t f) const {
    const std::span<const std::uint32_t> corners = m_mesh.face(f);
    m_values.append(text, countType(), static_cast<double>(corners.size()));
    for (const std::uint32_t vertex : corners) {
        m_values.append(text, indexType(), vertex);
    }
    if (m_hasFaceTexcoords) {
        const std::size_t first = m_mesh.faceStarts[f];
        const auto isThere = [this](std::size_t c) { return m_mesh.cornerTexcoords[c] != kNoIndex; };
        bool all = true;
        for (std::size_t c = first; c < first + corners.size(); ++c) {
            all = all && isThere(c);
        }
        m_values.append(text, texcoordCountType(), all ? 2.0 * static_cast<double>(corners.size()) : 0.0);
        for (std::size_t c = first; all && c < first + corners.size(); ++c) {
            const glm::vec2& texcoord = m_mesh.texcoords[m_mesh.cornerTexcoords[c]];
            m_values.append(text, PlyType::Float32, texcoord.x);
            m_values.append(text, PlyType::Float32, texcoord.y);
        }
    }
    m_values.endRecord(text);
}

void WholePly::edge(std::string& text, std::size_t e) const {
    m_values.append(text, indexType(), m_segments[2 * e]);
    m_values.append(text, indexType(), m_segments[2 * e + 1]);
    m_values.endRecord(text);
}

void WholePly::write(PieceWriter& out) const {
    const std::size_t edges = m_segments.size() / 2;
    const std::size_t records = m_mesh.positions.size() + m_mesh.faceCount();
    const std::size_t all = records + edges;
    out.put(header());
    for (std::size_t v = 0; v < m_mesh.positions.size() && out.goesOn(v, all); ++v) {
        vertex(out.text(), v);
    }
    for (std::size_t f = 0; f < m_mesh.faceCount() && out.goesOn(m_mesh.positions.size() + f, all); ++f) {
        face(out.text(), f);
    }
    for (std::size_t e = 0; e < edges && out.goesOn(records + e, all); ++e) {
        edge(out.text(), e);
    }
}

QStringList WholePly::notes() const {
    QStringList notes;
    if (!m_what.normals.empty() && m_normals.empty()) {
        notes += QStringLiteral(
            "A vertex of a PLY file has one normal, and here some have several: "
            "normals are left out.");
    }
    if (m_texture.empty() ? !m_mesh.materials.empty() : m_mesh.materials.size() > 1) {
        notes += QStringLiteral("PLY has no materials; they are left out.");
    } else if (!m_texture.empty() && hasMoreThanTexture(m_mesh.materials.front())) {
        notes += QStringLiteral("PLY has the texture of a material alone; its other values are left out.");
    }
    if (!m_mesh.groups.empty()) {
        notes += QStringLiteral("PLY has no groups; they are left out.");
    }
    if (!m_mesh.points.empty()) {
        notes += QStringLiteral("PLY has no point elements; they are left out.");
    }
    return notes;
}

/// Why the source could not be copied.
QString whyAnew(const PlyCopy& copy, const QString& sourcePath) {
    const QString name = QFileInfo(sourcePath).fileName();
    return copy.isTooCoarse()
               ? QStringLiteral(
                     "The file %1 has whole numbers for coordinates, too coarse for metres: the "
                     "mesh is written in full, without what else is in that file.")
                     .arg(name)
               : QStringLiteral(
                     "The file %1 is not as it was when it was opened (%2): the mesh is written "
                     "in full, without what else is in that file.")
                     .arg(name, copy.whyNot());
}

/// The PLY file that the mesh is in as it was read.
bool hasSource(const MeshExport& what) {
    return what.mesh->isAsRead() && what.inFile().sourceHash != 0 &&
           QFileInfo(what.sourcePath).suffix().compare(QStringLiteral("ply"), Qt::CaseInsensitive) == 0;
}

/// What the file calls its one texture, whose picture is staged beside it; empty: it has none.
Result<std::string> stageTexture(const MeshExport& what, const QFileInfo& file, StagedFiles& staged) {
    const bool mayNameOne = !what.mesh->cornerTexcoords.empty() || hasSource(what);
    if (what.mesh->materials.size() != 1 || !mayNameOne) {
        return std::string();
    }
    const QString folder =
        !what.sourcePath.isEmpty() ? QFileInfo(what.sourcePath).absolutePath() : what.sourceFolder;
    const ExportPlace place{folder, file.absolutePath(), file.completeBaseName()};
    const Material& material = what.mesh->materials.front();
    Result<std::string> name =
        MaterialFiles(*what.mesh, place, staged).placeTexture(material.diffuseTexture, material.diffuseImage);
    return name ? Result<std::string>(nameOnLine(name.value())) : name;
}

/// Notes, or why it could not be written.
Result<QStringList> write(const MeshExport& what, const QString& path, const PlyOptions& options) {
    StagedFiles staged(what.beforeStep);
    Result<std::string> texture = stageTexture(what, QFileInfo(path), staged);
    if (!texture) {
        return texture.error();
    }
    QStringList notes;
    const auto writeAs = [&](const auto& put, const QStringList& own) -> Result<QStringList> {
        Status written = stageInPieces(what, path, staged, StagedFiles::Existing::Replace, put);
        written = written ? staged.commit() : written;
        return written ? Result<QStringList>(notes + own +
                                             (options.isAlone ? QStringList() : staged.noteOfOthers(path)))
                       : Result<QStringList>(written.error());
    };
    if (hasSource(what)) {
        PlyCopy copy(what, options);
        copy.setTexture(texture.value());
        if (copy.check()) {
            return writeAs([&copy](PieceWriter& out) { copy.write(out); }, copy.notes());
        }
        if (copy.isGivenUp()) {
            return cancelledAt(path);
        }
        notes += whyAnew(copy, what.sourcePath);
    }
    const WholePly whole(what, options, std::move(texture).value());
    return writeAs([&whole](PieceWriter& out) { whole.write(out); }, whole.notes());
}

}  // namespace

Result<QStringList> exportPly(const MeshExport& what, const QString& path, const PlyOptions& options) {
    if (const Status fits = checkLengths(what); !fits) {
        return fits.error();
    }
    if (const Status fits = checkDisplacements(what, path); !fits) {
        return fits.error();
    }
    try {
        return write(what, path, options);
    } catch (const std::bad_alloc&) {
        return noMemoryFor(path);
    }
}

}  // namespace hitscope
