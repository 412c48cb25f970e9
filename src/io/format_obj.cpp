// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/give_up.h"
#include "io/export_names.h"
#include "io/export_obj.h"
#include "io/float_text.h"
#include "io/number_text.h"
#include "io/welder.h"
#include "io/writers/file_coordinate.h"

namespace hitscope {
namespace {

/// The normals to write and each corner's index among them: the file's own where they still hold, in its
/// order, and each other one once.
struct NormalTable {
    std::vector<glm::vec3> values;
    std::size_t inFile = 0;  ///< the first ones, which are the file's own
    std::vector<std::uint32_t> corners;
};

NormalTable tabulateNormals(const MeshData& mesh, const CornerNormalView& normals) {
    NormalTable table;
    table.corners.assign(normals.size(), kNoIndex);
    std::vector<bool> used(mesh.normals.size());
    std::vector<bool> still(mesh.normals.size());
    for (std::size_t c = 0; c < mesh.cornerNormals.size() && c < normals.size(); ++c) {
        mayGiveUp(c);
        const std::uint32_t index = mesh.cornerNormals[c];
        if (index != kNoIndex) {
            used[index] = true;
            if (isSameDirection(mesh.normals[index], normals[c])) {
                still[index] = true;
                table.corners[c] = index;
            }
        }
    }
    std::vector<std::uint32_t> written(mesh.normals.size(), kNoIndex);
    for (std::size_t n = 0; n < mesh.normals.size(); ++n) {
        if (still[n] || !used[n]) {
            written[n] = static_cast<std::uint32_t>(table.values.size());
            table.values.push_back(mesh.normals[n]);
        }
    }
    table.inFile = table.values.size();
    Welder others(table.values);
    others.startAnew();
    for (std::size_t c = 0; c < normals.size(); ++c) {
        mayGiveUp(c);
        const glm::vec3& normal = normals[c];
        const bool finite = std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z);
        std::uint32_t& corner = table.corners[c];
        corner = corner != kNoIndex ? written[corner] : others.index(finite ? normal : glm::vec3(0.0f));
    }
    return table;
}

class ObjText {
public:
    ObjText(const ObjExport& what, const std::vector<std::string>& materialLibraries)
        : m_mesh(*what.mesh), m_what(what), m_libraries(materialLibraries) {}

    std::string format();

private:
    void vertices();
    void position(std::size_t v);
    void texcoords();
    void normals();
    void faces();
    void groupsBefore(std::size_t face);
    void stateOf(std::size_t face);
    void corner(std::size_t c);
    void sayNew();
    void linesAndPoints();
    /// To be asked before each vertex and face. `done`: of all of them.
    bool isGivenUp(std::size_t done);
    void index(std::uint32_t zeroBased) { appendNumber(m_text, std::uint64_t{zeroBased} + 1); }

    const MeshData& m_mesh;
    const ObjExport& m_what;
    const std::vector<std::string>& m_libraries;
    std::string m_text;
    NormalTable m_normals;
    std::vector<std::string> m_materials;
    std::size_t m_nextGroup = 0;
    std::uint32_t m_material = kNoIndex;
    bool m_isGivenUp = false;
};

bool ObjText::isGivenUp(std::size_t done) {
    constexpr std::size_t kBetween = 8192;
    if (!m_isGivenUp && m_what.goOn && done % kBetween == 0) {
        const std::size_t all = m_mesh.positions.size() + m_mesh.faceCount();
        m_isGivenUp = !m_what.goOn(ExportStep::Writing, static_cast<double>(done) / static_cast<double>(all));
    }
    return m_isGivenUp;
}

void ObjText::position(std::size_t v) {
    for (int axis = 0; axis < 3; ++axis) {
        m_text += ' ';
        appendFileCoordinate(m_text, m_mesh, v, m_what.positions[v], axis);
    }
}

void ObjText::vertices() {
    for (std::size_t v = 0; v < m_mesh.positions.size() && !isGivenUp(v); ++v) {
        m_text += 'v';
        position(v);
        for (int i = 0; !m_mesh.colours.empty() && i < 3; ++i) {
            m_text += ' ';
            appendTwiceRoundedFloat(m_text, m_mesh.colours[v][i]);
        }
        m_text += '\n';
    }
}

void ObjText::texcoords() {
    for (std::size_t t = 0; t < m_mesh.texcoords.size(); ++t) {
        mayGiveUp(t);
        m_text += "vt ";
        appendTwiceRoundedFloat(m_text, m_mesh.texcoords[t].x);
        m_text += ' ';
        appendTwiceRoundedFloat(m_text, m_mesh.texcoords[t].y);
        m_text += '\n';
    }
}

void ObjText::normals() {
    m_normals = tabulateNormals(m_mesh, m_what.normals);
    for (std::size_t n = 0; n < m_normals.values.size(); ++n) {
        mayGiveUp(n);
        m_text += "vn";
        for (int i = 0; i < 3; ++i) {
            m_text += ' ';
            char number[kFloatText];
            const float value = m_normals.values[n][i];
            m_text.append(number,
                          n < m_normals.inFile ? writeFloat(number, value) : writeSixDecimals(number, value));
        }
        m_text += '\n';
    }
}

void ObjText::groupsBefore(std::size_t face) {
    for (; m_nextGroup < m_mesh.groups.size() && m_mesh.groups[m_nextGroup].firstFace <= face;
         ++m_nextGroup) {
        const FaceGroup& group = m_mesh.groups[m_nextGroup];
        m_text += group.kind == FaceGroup::Kind::Object ? "o " : "g ";
        m_text += nameOnLine(group.name) + '\n';
    }
}

/// Material and smoothing group, where they change.
void ObjText::stateOf(std::size_t face) {
    if (!m_mesh.faceMaterials.empty() && m_mesh.faceMaterials[face] != m_material) {
        m_material = m_mesh.faceMaterials[face];
        m_text += "usemtl";
        m_text += m_material == kNoIndex ? std::string() : " " + m_materials[m_material];
        m_text += '\n';
    }
    const std::vector<std::uint32_t>& smoothing = m_mesh.faceSmoothing;
    if (!smoothing.empty() && (face == 0 || smoothing[face] != smoothing[face - 1])) {
        m_text += "s ";
        if (smoothing[face] == 0) {
            m_text += "off";
        } else {
            appendNumber(m_text, smoothing[face]);
        }
        m_text += '\n';
    }
}

void ObjText::corner(std::size_t c) {
    const std::uint32_t texcoord = m_mesh.cornerTexcoords.empty() ? kNoIndex : m_mesh.cornerTexcoords[c];
    m_text += ' ';
    index(m_mesh.cornerVertices[c]);
    if (texcoord != kNoIndex) {
        m_text += '/';
        index(texcoord);
    }
    if (!m_normals.corners.empty()) {
        m_text += texcoord == kNoIndex ? "//" : "/";
        index(m_normals.corners[c]);
    }
}

void ObjText::faces() {
    for (std::size_t f = 0; f < m_mesh.faceCount() && !isGivenUp(m_mesh.positions.size() + f); ++f) {
        groupsBefore(f);
        stateOf(f);
        m_text += 'f';
        for (std::size_t c = m_mesh.faceStarts[f]; c < m_mesh.faceStarts[f + 1]; ++c) {
            corner(c);
        }
        m_text += '\n';
    }
    groupsBefore(m_mesh.faceCount());
}

void ObjText::linesAndPoints() {
    for (const std::vector<std::uint32_t>& line : m_mesh.lines) {
        m_text += 'l';
        for (const std::uint32_t vertex : line) {
            m_text += ' ';
            index(vertex);
        }
        m_text += '\n';
    }
    for (const std::uint32_t vertex : m_mesh.points) {
        m_text += "p ";
        index(vertex);
        m_text += '\n';
    }
}

/// Runs of vertices that the mesh's file does not have, from 1.
void ObjText::sayNew() {
    for (std::size_t v = 0; v < m_mesh.vertexCount(); ++v) {
        if (!m_mesh.isNew(v)) {
            continue;
        }
        const std::size_t first = v + 1;
        while (v + 1 < m_mesh.vertexCount() && m_mesh.isNew(v + 1)) {
            ++v;
        }
        m_text += "# New vertices: " + std::to_string(first) + " to " + std::to_string(v + 1) + '\n';
    }
}

std::string ObjText::format() {
    // Long lines, with a normal for each vertex: a text that grows is copied, and nobody could end that.
    constexpr std::size_t kVertexBytes = 64 + 40;
    constexpr std::size_t kCornerBytes = 24;
    constexpr std::size_t kTexcoordBytes = 28;
    m_text.reserve(kVertexBytes * m_mesh.positions.size() + kCornerBytes * m_mesh.cornerVertices.size() +
                   kTexcoordBytes * m_mesh.texcoords.size());
    m_text = "# Written by Hitscope " HITSCOPE_VERSION "\n";
    sayNew();
    for (const std::string& library : m_libraries) {
        m_text += "mtllib " + library + '\n';
    }
    m_materials = materialNames(m_mesh);
    vertices();
    if (!m_isGivenUp) {
        texcoords();
        normals();
        faces();
        linesAndPoints();
    }
    if (m_isGivenUp || (m_what.goOn && !m_what.goOn(ExportStep::Writing, 1.0))) {
        return {};
    }
    return std::move(m_text);
}

}  // namespace

std::string formatObj(const ObjExport& what, const std::vector<std::string>& materialLibraries) {
    return ObjText(what, materialLibraries).format();
}

}  // namespace hitscope
