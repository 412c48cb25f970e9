// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/obj_parser.h"

#include <array>
#include <cmath>

#include "io/readers/obj_numbers.h"
#include "io/readers/text_cursor.h"
#include "io/writers/obj_lines.h"

namespace hitscope {
namespace {

std::string_view trimEnd(std::string_view line) {
    while (!line.empty() && TextCursor::isBlank(line.back())) {
        line.remove_suffix(1);
    }
    return line;
}

/// A comment is over at its line's end: it may name a folder of Windows.
bool isContinued(std::string_view line) {
    if (line.empty() || line.back() != '\\') {
        return false;
    }
    TextCursor start(line);
    start.skipBlanks();
    return start.peek() != '#';
}

}  // namespace

/// A line without its end, continued lines joined; counts lines.
std::string_view ObjParser::nextLine(TextCursor& text) {
    ++m_line;
    std::string_view line = trimEnd(text.line());
    if (!isContinued(line)) {
        return line;
    }
    m_joined.clear();
    while (isContinued(line)) {
        m_joined.append(line.substr(0, line.size() - 1));
        m_joined += ' ';
        if (text.atEnd()) {
            return trimEnd(m_joined);
        }
        ++m_line;
        line = trimEnd(text.line());
    }
    m_joined.append(line);
    return m_joined;
}

void ObjParser::parseVertex(TextCursor& line) {
    glm::dvec3 position;
    for (int i = 0; i < 3; ++i) {
        position[i] = coordinate(line, "vertex");
        if (!std::isfinite(static_cast<float>(position[i]))) {
            throw BadLine{"A coordinate is not a number, infinite or too large."};
        }
    }
    m_part.positions.push_back(position);
    std::array<double, 4> more{};
    const std::size_t count = optionalNumbers(line, more);
    const bool hasWeight = count == 1 || count == 4;  // x y z w, or x y z w r g b
    if (hasWeight && (more[0] == 0.0 || !std::isfinite(more[0]))) {
        throw BadLine{"The weight (w) of a vertex is 0, infinite or not a number: it lies nowhere."};
    }
    if (count >= 3) {
        const std::size_t red = count - 3;
        if (!std::isfinite(more[red]) || !std::isfinite(more[red + 1]) || !std::isfinite(more[red + 2])) {
            throw BadLine{"A colour is infinite or not a number."};
        }
        m_part.colours.resize(m_part.positions.size() - 1, glm::vec3(1.0f));
        m_part.colours.emplace_back(more[red], more[red + 1], more[red + 2]);
    }
}

void ObjParser::parseNormal(TextCursor& line) {
    glm::vec3 normal;
    for (int i = 0; i < 3; ++i) {
        normal[i] = static_cast<float>(coordinate(line, "normal"));
    }
    m_mesh.normals.push_back(normal);
}

void ObjParser::parseTexcoord(TextCursor& line) {
    const double u = coordinate(line, "texture coordinate");
    std::array<double, 2> more{};
    optionalNumbers(line, more);
    m_mesh.texcoords.emplace_back(u, more[0]);
}

/// Counted from one in the file, or from the end when negative.
std::uint32_t ObjParser::vertexIndex(long long written, const char* of) {
    const auto count = static_cast<long long>(m_part.positions.size());
    if (written < 0 && !m_isWhole) {
        throw BadLine{"It counts from the end of what comes before."};
    }
    if (written == 0) {
        throw BadLine{"The " + std::string(of) + " refers to vertex 0, but OBJ files count from 1."};
    }
    if (written < 0 ? written < -count : written >= kNoIndex) {
        const bool isRead = written < std::numeric_limits<long long>::max();
        throw BadLine{"The " + std::string(of) + " refers to vertex " +
                      (isRead ? std::to_string(written) : "9223372036854775807 or more") +
                      ", but there are only " + std::to_string(count) + " so far."};
    }
    if (written > m_part.largest.index && (written > count || !m_isWhole)) {
        m_part.largest = {written, m_line};
    }
    return static_cast<std::uint32_t>(written < 0 ? count + written : written - 1);
}

/// The same for normals and texture coordinates, which a face can do without: tidy() sorts bad ones out.
std::uint32_t ObjParser::otherIndex(long long written, std::size_t count) const {
    if (written < 0 && !m_isWhole) {
        throw BadLine{"It counts from the end of what comes before."};
    }
    const auto signedCount = static_cast<long long>(count);
    const long long index = written < 0 ? signedCount + written : written - 1;
    return index < 0 || index >= kNoIndex ? kNoIndex - 1 : static_cast<std::uint32_t>(index);
}

/// v, v/t, v//n or v/t/n; false at the end of the line.
bool ObjParser::parseCorner(TextCursor& line) {
    line.skipBlanks();
    if (line.atEnd() || line.peek() == '#') {
        return false;
    }
    const std::string_view word = line.rest().substr(0, 40);
    const std::optional<long long> vertex = line.integer();
    std::uint32_t texcoord = kNoIndex;
    std::uint32_t normal = kNoIndex;
    if (vertex && line.take('/')) {
        if (const auto index = line.integer()) {
            texcoord = otherIndex(*index, m_mesh.texcoords.size());
        }
        if (line.take('/')) {
            if (const auto index = line.integer()) {
                normal = otherIndex(*index, m_mesh.normals.size());
            }
        }
    }
    if (!vertex || !(line.atEnd() || TextCursor::isBlank(line.peek()))) {
        throw BadLine{quoted(TextCursor(word).word()) + " is not a corner of a face."};
    }
    m_mesh.cornerVertices.push_back(vertexIndex(*vertex, "face"));
    m_mesh.cornerTexcoords.push_back(texcoord);
    m_mesh.cornerNormals.push_back(normal);
    return true;
}

void ObjParser::parseFace(TextCursor& line) {
    const std::size_t first = m_mesh.cornerVertices.size();
    while (parseCorner(line)) {
    }
    if (m_mesh.cornerVertices.size() >= kNoIndex) {
        throw BadLine{"The mesh has more face corners than Hitscope can count (4,294,967,294)."};
    }
    if (m_mesh.cornerVertices.size() - first < 3) {
        if (m_lastLineCut) {
            throw BadLine{"The file ends in the middle of a face."};
        }
        m_mesh.cornerVertices.resize(first);
        m_mesh.cornerTexcoords.resize(first);
        m_mesh.cornerNormals.resize(first);
        ++m_part.smallFaces;
        return;
    }
    m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(m_mesh.cornerVertices.size()));
    m_mesh.faceMaterials.push_back(m_part.material.value_or(kNoIndex));
    m_mesh.faceSmoothing.push_back(m_part.smoothing.value_or(0));
}

void ObjParser::parseLineElement(TextCursor& line) {
    std::vector<std::uint32_t> vertices;
    for (line.skipBlanks(); !line.atEnd() && line.peek() != '#'; line.skipBlanks()) {
        const std::optional<long long> vertex = line.integer();
        if (!vertex) {
            throw BadLine{quoted(line.word()) + " is not a vertex of a line."};
        }
        if (line.peek() == '/') {
            line.word();  // its texture coordinate
        }
        vertices.push_back(vertexIndex(*vertex, "line"));
    }
    if (vertices.size() < 2) {
        ++m_part.smallLines;
        return;
    }
    m_mesh.lines.push_back(std::move(vertices));
}

void ObjParser::parsePoints(TextCursor& line) {
    for (line.skipBlanks(); !line.atEnd() && line.peek() != '#'; line.skipBlanks()) {
        const std::optional<long long> vertex = line.integer();
        if (!vertex) {
            throw BadLine{quoted(line.word()) + " is not a point's vertex."};
        }
        m_mesh.points.push_back(vertexIndex(*vertex, "point"));
    }
}

void ObjParser::parseSmoothing(TextCursor& line) {
    line.skipBlanks();
    const long long group = line.integer().value_or(-1);
    const bool isNumber = group >= 0 && group < kNoIndex;
    if (!m_part.smoothing) {
        m_part.facesBeforeSmoothing = m_part.faceCount();
    }
    m_part.smoothing = isNumber ? static_cast<std::uint32_t>(group) : line.word() == "on" ? 1 : 0;
}

void ObjParser::useMaterial(std::string_view name) {
    if (!m_part.material) {
        m_part.facesBeforeMaterial = m_part.faceCount();
    }
    if (name.empty()) {
        m_part.material = kNoIndex;
        return;
    }
    const auto [known, isNew] =
        m_materials.try_emplace(std::string(name), static_cast<std::uint32_t>(m_mesh.materials.size()));
    if (isNew) {
        m_mesh.materials.emplace_back().name = name;
    }
    m_part.material = known->second;
}

/// The lines whose argument is a name up to their end, blanks and all.
bool ObjParser::parseName(std::string_view keyword, TextCursor& line) {
    line.skipBlanks();
    const std::string_view name = line.rest();
    const std::size_t faces = m_part.faceCount();
    if (keyword == "g") {
        m_mesh.groups.push_back(
            {FaceGroup::Kind::Group, std::string(name), static_cast<std::uint32_t>(faces)});
    } else if (keyword == "o") {
        m_mesh.groups.push_back(
            {FaceGroup::Kind::Object, std::string(name), static_cast<std::uint32_t>(faces)});
    } else if (keyword == "usemtl") {
        useMaterial(name);
    } else if (keyword == "mtllib") {
        m_mesh.materialLibraries.emplace_back(name);
    } else {
        return false;
    }
    return true;
}

void ObjParser::parseLine(std::string_view text) {
    TextCursor line(text);
    const std::string_view keyword = line.word();
    if (keyword.empty()) {
        return;
    }
    if (keyword == "v") {
        parseVertex(line);
    } else if (keyword == "f" || keyword == "fo") {
        parseFace(line);
    } else if (keyword == "vn") {
        parseNormal(line);
    } else if (keyword == "vt") {
        parseTexcoord(line);
    } else if (keyword == "s") {
        parseSmoothing(line);
    } else if (keyword == "l") {
        parseLineElement(line);
    } else if (keyword == "p") {
        parsePoints(line);
    } else if (keyword.front() != '#' && !parseName(keyword, line)) {
        m_part.freeForm += keyword == "curv" || keyword == "curv2" || keyword == "surf" ? 1 : 0;
    }
    if (!line.atEnd() && hidesObjLine(text)) {  // most lines are read to their end
        throw BadLine{};                        // see parse()
    }
}

Error ObjParser::errorAt(const std::string& what, std::size_t line) {
    return {what, "line " + std::to_string(line),
            "Correct the line, or write the file again with the program it came from."};
}

Error ObjParser::errorHere(const std::string& what) const {
    Error error = errorAt(what, m_line);
    if (m_lastLineCut) {
        error.what += " The file ends there, in the middle of a line.";
        error.advice = kCutAdvice;
    }
    return error;
}

ObjPart ObjParser::parse() {
    constexpr std::size_t kTellEvery = 1 << 20;  // bytes
    m_mesh.faceStarts.push_back(0);
    TextCursor text(m_text);
    std::size_t told = 0;
    while (!text.atEnd()) {
        const std::string_view line = nextLine(text);
        m_lastLineCut = text.atEnd() && m_text.back() != '\n';
        try {
            parseLine(line);
        } catch (const BadLine& bad) {
            m_part.error = errorHere(bad.what);
            m_part.hidesLine = hidesObjLine(line);
            break;
        }
        if (text.offset() - told >= kTellEvery) {
            m_told(text.offset() - told);
            told = text.offset();
        }
    }
    if (!m_part.material) {
        m_part.facesBeforeMaterial = m_part.faceCount();
    }
    if (!m_part.smoothing) {
        m_part.facesBeforeSmoothing = m_part.faceCount();
    }
    return std::move(m_part);
}

}  // namespace hitscope
