// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/check/written_surface_check.h"

#include <algorithm>

#include "core/finite.h"
#include "core/give_up.h"
#include "io/export_names.h"
#include "io/number_text.h"
#include "mesh/same_bits.h"

namespace hitscope {
namespace {

/// An index of a corner or face, or none.
std::uint32_t indexAt(const std::vector<std::uint32_t>& indices, std::size_t at) {
    return indices.empty() ? kNoIndex : indices[at];
}

class SurfaceComparison {
public:
    SurfaceComparison(const MeshData& read, const MeshExport& what, const WrittenNormals& normals,
                      SurfaceFormat format, bool normalsAreExact);

    std::optional<std::string> first(const ExportGoOn& goOn);

private:
    void findTouched();
    void findTurned();
    [[nodiscard]] bool plyHasNormals() const;
    [[nodiscard]] std::string normal(std::size_t f, std::size_t c) const;
    [[nodiscard]] std::string texcoord(std::size_t f, std::size_t c) const;
    [[nodiscard]] std::string material(std::size_t f) const;
    [[nodiscard]] std::string corner(std::size_t f, std::size_t c) const {
        return cornerName(f, c - m_mesh.faceStarts[f]);
    }

    const MeshData& m_read;
    const MeshExport& m_what;
    const MeshData& m_mesh;
    const WrittenNormals& m_normals;
    SurfaceFormat m_format;
    bool m_normalsAreExact;
    bool m_needsNormals = false;           // PLY: of every corner
    std::vector<std::string> m_materials;  // OBJ: names as they are written anew
    std::vector<std::uint32_t> m_turned;   // PLY: of each vertex the corner whose normal it has, or none
    std::vector<std::uint8_t> m_touched;   // vertices of faces of which a vertex moved
};

SurfaceComparison::SurfaceComparison(const MeshData& read, const MeshExport& what,
                                     const WrittenNormals& normals, SurfaceFormat format,
                                     bool normalsAreExact)
    : m_read(read),
      m_what(what),
      m_mesh(*what.mesh),
      m_normals(normals),
      m_format(format),
      m_normalsAreExact(normalsAreExact),
      m_touched(m_mesh.positions.size(), 0) {
    if (format == SurfaceFormat::Obj) {
        m_materials = materialNames(m_mesh);
    }
    findTouched();
    if (format == SurfaceFormat::Ply && !m_normals.corners.empty()) {
        findTurned();
        m_needsNormals = plyHasNormals();
    }
}

void SurfaceComparison::findTouched() {
    for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
        mayGiveUp(f);
        const std::span<const std::uint32_t> face = m_mesh.face(f);
        const bool isTouched = std::any_of(face.begin(), face.end(), [this](std::uint32_t v) {
            return !sameBits(m_what.positions[v], m_mesh.positions[v]);
        });
        for (std::size_t i = 0; isTouched && i < face.size(); ++i) {
            m_touched[face[i]] = 1;
        }
    }
}

/// A vertex has one normal: that of its first corner whose normal is no longer the file's.
void SurfaceComparison::findTurned() {
    m_turned.assign(m_mesh.positions.size(), kNoIndex);
    for (std::uint32_t c = 0; c < m_mesh.cornerVertices.size(); ++c) {
        mayGiveUp(c);
        const std::uint32_t before = indexAt(m_mesh.cornerNormals, c);
        const glm::vec3& now = m_normals.corners[c];
        std::uint32_t& turned = m_turned[m_mesh.cornerVertices[c]];
        if (turned == kNoIndex && isFinite(now) &&
            (before == kNoIndex || !isSameDirection(m_mesh.normals[before], now))) {
            turned = c;
        }
    }
}

/// A copy has those that its source has, a file of its own those that are one a vertex.
bool SurfaceComparison::plyHasNormals() const {
    if (m_what.sourcePath.endsWith(QStringLiteral(".ply"), Qt::CaseInsensitive) && m_mesh.isAsRead()) {
        return !m_mesh.normals.empty();
    }
    std::vector<std::uint32_t> first(m_mesh.positions.size(), kNoIndex);
    for (std::uint32_t c = 0; c < m_mesh.cornerVertices.size(); ++c) {
        mayGiveUp(c);
        std::uint32_t& corner = first[m_mesh.cornerVertices[c]];
        corner = corner == kNoIndex ? c : corner;
        if (!sameBits(m_normals.corners[corner], m_normals.corners[c])) {
            return false;
        }
    }
    return true;
}

/// What was not turned has the file's own; empty: all is well.
std::string SurfaceComparison::normal(std::size_t f, std::size_t c) const {
    const std::uint32_t is = indexAt(m_read.cornerNormals, c);
    const std::uint32_t before = indexAt(m_mesh.cornerNormals, c);
    const bool isObj = m_format == SurfaceFormat::Obj;
    if (is == kNoIndex) {
        const bool isMeant =
            isObj ? (before != kNoIndex || m_normals.all) && !m_normals.corners.empty() : m_needsNormals;
        return isMeant ? corner(f, c) + " has no normal" : std::string();
    }
    if (m_normals.corners.empty()) {
        return isObj && before == kNoIndex ? corner(f, c) + " has a normal and should have none"
                                           : std::string();
    }
    const glm::vec3& now = m_read.normals[is];
    const std::uint32_t turned = indexAt(m_turned, m_mesh.cornerVertices[c]);
    const glm::vec3& given = m_normals.corners[turned == kNoIndex ? c : turned];
    const glm::vec3 meant = isFinite(given) ? given : glm::vec3(0.0f);
    const bool isKept = before != kNoIndex && m_touched[m_mesh.cornerVertices[c]] == 0 &&
                        sameBits(now, m_mesh.normals[before]);
    if (!m_normalsAreExact || isKept || now == meant || isSameDirection(now, meant)) {
        return {};
    }
    // A copy of a PLY keeps what is not a direction.
    const bool isOld =
        !isObj && before != kNoIndex && now == m_mesh.normals[before] && !isFinite(m_normals.corners[c]);
    return isOld ? std::string() : otherVector(corner(f, c), "normal", now, meant, 3);
}

std::string SurfaceComparison::texcoord(std::size_t f, std::size_t c) const {
    const std::uint32_t is = indexAt(m_read.cornerTexcoords, c);
    const std::uint32_t meant = indexAt(m_mesh.cornerTexcoords, c);
    if (meant == kNoIndex || is == kNoIndex) {
        if (meant == is) {
            return {};
        }
        if (m_format == SurfaceFormat::Ply) {
            // All corners of a face have one there, or none has.
            const auto from = m_mesh.cornerTexcoords.begin();
            const bool all =
                meant != kNoIndex && std::find(from + m_mesh.faceStarts[f], from + m_mesh.faceStarts[f + 1],
                                               kNoIndex) == from + m_mesh.faceStarts[f + 1];
            return all ? corner(f, c) + " has no texture coordinate" : std::string();
        }
        return corner(f, c) + (is == kNoIndex ? " has no texture coordinate"
                                              : " has a texture coordinate and should have none");
    }
    const glm::vec2& now = m_read.texcoords[is];
    const glm::vec2& wanted = m_mesh.texcoords[meant];
    return now == wanted ? std::string()
                         : otherVector(corner(f, c), "texture coordinate", glm::vec3(now, 0.0f),
                                       glm::vec3(wanted, 0.0f), 2);
}

std::string SurfaceComparison::material(std::size_t f) const {
    const std::uint32_t is = indexAt(m_read.faceMaterials, f);
    const std::uint32_t meant = indexAt(m_mesh.faceMaterials, f);
    const std::string now = is == kNoIndex ? std::string() : m_read.materials[is].name;
    const std::string wanted = meant == kNoIndex ? std::string() : m_mesh.materials[meant].name;
    if (now == wanted || (meant != kNoIndex && now == m_materials[meant])) {
        return {};
    }
    return "face " + std::to_string(f + 1) + " has the material \"" + now + "\" and should have \"" + wanted +
           '"';
}

std::optional<std::string> SurfaceComparison::first(const ExportGoOn& goOn) {
    for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
        tellPart(goOn, ExportStep::Comparing, f, m_mesh.faceCount());
        std::string difference = m_format == SurfaceFormat::Obj ? material(f) : std::string();
        for (std::size_t c = m_mesh.faceStarts[f]; difference.empty() && c < m_mesh.faceStarts[f + 1]; ++c) {
            difference = texcoord(f, c);
            difference = difference.empty() ? normal(f, c) : difference;
        }
        if (!difference.empty()) {
            return difference;
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> surfaceDifference(const MeshData& read, const MeshExport& what,
                                             const WrittenNormals& normals, SurfaceFormat format,
                                             bool normalsAreExact, const ExportGoOn& goOn) {
    return SurfaceComparison(read, what, normals, format, normalsAreExact).first(goOn);
}

std::string cornerName(std::size_t face, std::size_t corner) {
    return "corner " + std::to_string(corner + 1) + " of face " + std::to_string(face + 1);
}

std::string otherVector(const std::string& which, const char* kind, const glm::vec3& is,
                        const glm::vec3& meant, int components) {
    std::string text = which + " has the " + kind;
    const auto append = [&text, components](const glm::vec3& vector) {
        for (int i = 0; i < components; ++i) {
            text += ' ';
            appendNumber(text, vector[i]);
        }
    };
    append(is);
    text += " and should have";
    append(meant);
    return text;
}

}  // namespace hitscope
