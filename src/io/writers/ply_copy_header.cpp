// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/give_up.h"
#include "io/readers/text_cursor.h"
#include "io/writers/normal_plan.h"
#include "io/writers/ply_copy.h"

namespace hitscope {
namespace {

const char* nameOf(PlyEncoding encoding) {
    return encoding == PlyEncoding::Ascii          ? "ascii"
           : encoding == PlyEncoding::LittleEndian ? "binary_little_endian"
                                                   : "binary_big_endian";
}

/// Before the first element: what the reader passes over, and other programs may not.
bool isStray(std::string_view keyword) {
    static constexpr std::array kKnown{"", "ply", "format", "comment", "obj_info", "end_header"};
    return std::find(kKnown.begin(), kKnown.end(), keyword) == kKnown.end();
}

}  // namespace

bool PlyCopy::readHeader() {
    if (!QFileInfo(m_what.sourcePath).isFile() || !m_file.open(QIODevice::ReadOnly)) {
        m_whyNot = QStringLiteral("it cannot be opened");
        return false;
    }
    const QByteArray start = m_file.read(kLongestPlyHeader);
    const std::string_view bytes(start.constData(), static_cast<std::size_t>(start.size()));
    Result<PlyHeader> header = parsePlyHeader(bytes, static_cast<std::uint64_t>(m_file.size()));
    if (!header) {
        m_whyNot = QStringLiteral("it is no longer a PLY file");
        return false;
    }
    m_header = std::move(header.value());
    for (const PlyElement& element : m_header.elements) {
        m_all += element.count;
    }
    m_headerText = bytes.substr(0, m_header.size);
    const PlyEncoding own = m_header.encoding;
    const bool keepsOwn = m_options.encoding == PlyOptions::Encoding::AsSource ||
                          (m_options.encoding == PlyOptions::Encoding::Binary && own != PlyEncoding::Ascii);
    const PlyEncoding wanted = keepsOwn ? own
                               : m_options.encoding == PlyOptions::Encoding::Ascii
                                   ? PlyEncoding::Ascii
                                   : PlyEncoding::LittleEndian;
    m_values = PlyValues(wanted);
    m_isOther = wanted != own;
    return true;
}

/// As the reader takes them: the first element "vertex" with anything in it, and the last property of a name.
void PlyCopy::findSlots() {
    for (const PlyElement& element : m_header.elements) {
        if (element.name == "vertex" && element.count > 0 && !m_vertices) {
            m_vertices = &element;
        }
    }
    if (!m_vertices || m_vertices->count != m_mesh.positions.size()) {
        differs(QStringLiteral("it has another number of vertices"));
    }
    static constexpr const char* kNames[2][3] = {{"x", "y", "z"}, {"nx", "ny", "nz"}};
    for (std::size_t p = 0; p < m_vertices->properties.size(); ++p) {
        const PlyProperty& property = m_vertices->properties[p];
        for (int i = 0; i < 3 && !property.isList; ++i) {
            m_slots.position[i] = property.name == kNames[0][i] ? static_cast<int>(p) : m_slots.position[i];
            const bool isNormal = property.name == kNames[1][i] && !isWhole(property.type);
            m_slots.normal[i] = isNormal ? static_cast<int>(p) : m_slots.normal[i];
        }
    }
    if (m_slots.position[0] < 0 || m_slots.position[1] < 0 || m_slots.position[2] < 0) {
        differs(QStringLiteral("its vertices have no coordinates"));
    }
    m_isTooCoarse = m_what.asRead && std::ranges::any_of(m_slots.position, [this](int slot) {
                        return isWhole(m_vertices->properties[static_cast<std::size_t>(slot)].type);
                    });
    m_added.emplace(m_what, m_options, m_vertices->properties);
}

void PlyCopy::findTurned() {
    const bool has = m_slots.normal[0] >= 0 && m_slots.normal[1] >= 0 && m_slots.normal[2] >= 0;
    if (!has || m_what.normals.empty() || m_mesh.cornerNormals.empty()) {
        m_slots.normal[0] = m_slots.normal[1] = m_slots.normal[2] = -1;
        return;
    }
    for (std::size_t c = 0; c < m_mesh.cornerNormals.size(); ++c) {
        mayGiveUp(c);
        const std::uint32_t index = m_mesh.cornerNormals[c];
        const glm::vec3& now = m_what.normals[c];
        const bool isFinite = std::isfinite(now.x) && std::isfinite(now.y) && std::isfinite(now.z);
        if (index != kNoIndex && isFinite && !isSameDirection(m_what.mesh->normals[index], now)) {
            m_turned.emplace(m_mesh.cornerVertices[c], now);
        }
    }
    for (std::size_t c = 0; m_what.asRead && c < m_mesh.cornerNormals.size(); ++c) {
        mayGiveUp(c);
        const std::uint32_t index = m_mesh.cornerNormals[c];
        if (index != kNoIndex && m_mesh.normals[index] != m_what.mesh->normals[index]) {
            m_turned.emplace(m_mesh.cornerVertices[c], m_what.mesh->normals[index]);
        }
    }
}

/// Line for line, with the format's line in the new encoding and our properties after the vertices' last.
std::string PlyCopy::newHeader() const {
    TextCursor lines(m_headerText);
    std::string header;
    const auto vertices = static_cast<std::ptrdiff_t>(m_vertices - m_header.elements.data());
    std::ptrdiff_t element = -1;
    std::size_t insertAt = 0;
    std::string lineEnd = "\n";
    while (!lines.atEnd()) {
        const std::size_t start = lines.offset();
        const std::string_view line = lines.line();
        const std::string_view whole = lines.since(start);
        TextCursor words(line);
        const std::string_view keyword = words.word();
        if (keyword == "format" && m_isOther) {
            header += std::string("format ") + nameOf(m_values.encoding()) + " 1.0\n";
            continue;
        }
        if (keyword == "comment" && !m_texture.empty() && words.word() == "TextureFile") {
            header += "comment TextureFile " + m_texture + (line.ends_with('\r') ? "\r\n" : "\n");
            continue;
        }
        element += keyword == "element" ? 1 : 0;
        header += element < 0 && isStray(keyword) ? "comment " : "";
        header += whole;
        if (element == vertices && (keyword == "property" || keyword == "element")) {
            insertAt = header.size();
            lineEnd = line.ends_with('\r') ? "\r\n" : "\n";
        }
    }
    std::string added;
    for (const PlyProperty& property : m_added->properties()) {
        added += plyLine(property) + lineEnd;
    }
    return header.insert(insertAt, added);
}

}  // namespace hitscope
