// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/off_reader.h"

#include "io/readers/text_cursor.h"
#include "io/readers/tidy.h"

namespace hitscope {
namespace {

const char* const kWrongAdvice = "Correct the line, or write the file again with the program it came from.";

class OffParser {
public:
    OffParser(std::string_view text, const ProgressSink& progress)
        : m_lines(text), m_size(text.size()), m_progress(progress) {}

    Result<ImportedMesh> parse();

private:
    bool nextLine();
    std::optional<long long> wholeNumber();
    Status parseKind();
    Status parseCounts();
    Status parseVertex();
    Status parseFace();
    void finish();
    void report();
    [[nodiscard]] Error wrong(const std::string& what) const {
        return {what, "line " + std::to_string(m_line), kWrongAdvice};
    }

    TextCursor m_lines;
    std::size_t m_size;
    const ProgressSink& m_progress;
    TextCursor m_at{{}};  ///< in the line being read
    std::size_t m_line = 0;
    std::uint64_t m_vertices = 0;
    std::uint64_t m_faces = 0;
    bool m_hasTexcoords = false;
    bool m_hasColours = false;
    bool m_hasNormals = false;
    std::size_t m_smallFaces = 0;
    ImportedMesh m_imported;
    MeshData& m_mesh = m_imported.mesh;
    std::vector<glm::dvec3> m_positions;
    std::vector<glm::vec3> m_colours;
};

/// To the next line that holds something; false at the end.
bool OffParser::nextLine() {
    while (!m_lines.atEnd()) {
        ++m_line;
        std::string_view line = m_lines.line();
        m_at = TextCursor(line.substr(0, line.find('#')));
        m_at.skipBlanks();
        if (!m_at.atEnd()) {
            return true;
        }
    }
    return false;
}

/// Nothing if what comes next on the line is none.
std::optional<long long> OffParser::wholeNumber() {
    m_at.skipBlanks();
    const std::optional<long long> number = m_at.integer();
    return m_at.atEnd() || TextCursor::isBlank(m_at.peek()) ? number : std::nullopt;
}

/// "OFF" with letters before it that say what a vertex has. The counts may follow on the same line, and the
/// word may be missing.
Status OffParser::parseKind() {
    const Error noOff{
        "It does not begin as an OFF file.", {}, "Check that the file's suffix tells its format."};
    if (!nextLine()) {
        return noOff;
    }
    TextCursor ahead = m_at;
    std::string_view word = ahead.word();
    if (!word.empty() && word.front() >= '0' && word.front() <= '9' && word.find("OFF") == word.npos) {
        return Done{};
    }
    if (!word.ends_with("OFF")) {
        return noOff;
    }
    word.remove_suffix(3);
    const auto takeLetters = [&word](std::string_view letters) {
        const bool there = word.starts_with(letters);
        word.remove_prefix(there ? letters.size() : 0);
        return there;
    };
    m_hasTexcoords = takeLetters("ST");
    m_hasColours = takeLetters("C");
    m_hasNormals = takeLetters("N");
    ahead.skipBlanks();
    if (!word.empty() || ahead.rest().starts_with("BINARY")) {
        return Error{"This kind of OFF (binary, or of another dimension) is not known here.",
                     {},
                     "Save it as a text OFF, OBJ or PLY with another program."};
    }
    m_at = ahead;
    if (m_at.atEnd() && !nextLine()) {
        return Error{"The file ends after its first line.", {}, kCutAdvice};
    }
    return Done{};
}

Status OffParser::parseCounts() {
    const std::optional<long long> vertices = wholeNumber();
    const std::optional<long long> faces = wholeNumber();
    if (!vertices || !faces || *vertices < 0 || *faces < 0) {
        return wrong("Here should be the numbers of vertices and faces.");
    }
    m_vertices = static_cast<std::uint64_t>(*vertices);
    m_faces = static_cast<std::uint64_t>(*faces);
    constexpr std::size_t kLeastVertex = 6;  // "0 0 0" and a line end
    constexpr std::size_t kLeastFace = 2;
    const std::size_t left = m_lines.rest().size() + 1;
    if (m_vertices > left / kLeastVertex || m_faces > left / kLeastFace) {
        return Error{"The file promises " + std::to_string(m_vertices) + " vertices and " +
                         std::to_string(m_faces) + " faces, but ends too early for them.",
                     "line " + std::to_string(m_line), kCutAdvice};
    }
    return Done{};
}

Status OffParser::parseVertex() {
    constexpr std::size_t kMost = 12;  // x y z, nx ny nz, r g b a, s t
    double numbers[kMost] = {};
    std::size_t count = 0;
    for (; count < kMost; ++count) {
        m_at.skipBlanks();
        const std::optional<double> number = m_at.number();
        if (!number) {
            break;
        }
        numbers[count] = *number;
    }
    const std::size_t needed = 3 + (m_hasNormals ? 3 : 0) + (m_hasColours ? 3 : 0) + (m_hasTexcoords ? 2 : 0);
    if (count < needed) {
        return wrong("A vertex needs " + std::to_string(needed) + " numbers here.");
    }
    const glm::dvec3 position(numbers[0], numbers[1], numbers[2]);
    for (int i = 0; i < 3; ++i) {
        if (!std::isfinite(static_cast<float>(position[i]))) {
            return wrong("A coordinate is not a number, infinite or too large.");
        }
    }
    m_positions.push_back(position);
    const double* at = numbers + 3;
    if (m_hasNormals) {
        m_mesh.normals.emplace_back(at[0], at[1], at[2]);
        at += 3;
    }
    if (m_hasColours) {
        m_colours.emplace_back(at[0], at[1], at[2]);
    }
    if (m_hasTexcoords) {
        m_mesh.texcoords.emplace_back(numbers[count - 2], numbers[count - 1]);
    }
    return Done{};
}

Status OffParser::parseFace() {
    const long long corners = wholeNumber().value_or(-1);
    if (corners < 0) {
        return wrong("A face begins with the number of its corners.");
    }
    const std::size_t first = m_mesh.cornerVertices.size();
    for (long long c = 0; c < corners; ++c) {
        m_at.skipBlanks();
        const bool isThere = !m_at.atEnd();
        const std::optional<long long> vertex = wholeNumber();
        if (!vertex) {
            return wrong(isThere ? "A corner of the face is no whole number."
                                 : "The face has fewer corners than it says.");
        }
        if (*vertex < 0 || *vertex >= static_cast<long long>(m_vertices)) {
            return wrong("The face refers to vertex " + std::to_string(*vertex) +
                         " (counted from 0), but the file has " + std::to_string(m_vertices) + ".");
        }
        m_mesh.cornerVertices.push_back(static_cast<std::uint32_t>(*vertex));
    }
    if (m_mesh.cornerVertices.size() >= kNoIndex) {
        return wrong("The mesh has more face corners than Hitscope can count (4,294,967,294).");
    }
    if (corners < 3) {
        m_mesh.cornerVertices.resize(first);
        ++m_smallFaces;
    } else {
        m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(m_mesh.cornerVertices.size()));
    }
    return Done{};
}

void OffParser::report() {
    constexpr std::size_t kEvery = 1 << 16;  // lines
    if (m_progress && m_line % kEvery == 0) {
        m_progress(static_cast<double>(m_lines.offset()) / static_cast<double>(m_size), "Reading OFF");
    }
}

void OffParser::finish() {
    if (m_mesh.faceStarts.size() == 1) {
        m_mesh.faceStarts.clear();
    }
    if (m_hasNormals) {
        m_mesh.cornerNormals = m_mesh.cornerVertices;
    }
    if (m_hasTexcoords) {
        m_mesh.cornerTexcoords = m_mesh.cornerVertices;
    }
    if (m_hasColours) {
        setColours(m_mesh, std::move(m_colours));
    }
    if (m_smallFaces > 0) {
        m_imported.notes += counted(m_smallFaces, "face with fewer than three corners was left out.",
                                    "faces with fewer than three corners were left out.");
    }
    if (nextLine()) {
        m_imported.notes += QStringLiteral("The file goes on after its last face; the rest was not read.");
    }
    tidy(m_imported);
}

Result<ImportedMesh> OffParser::parse() {
    if (Status kind = parseKind(); !kind) {
        return kind.error();
    }
    if (Status counts = parseCounts(); !counts) {
        return counts.error();
    }
    m_positions.reserve(m_vertices);
    m_mesh.faceStarts.push_back(0);
    for (std::uint64_t i = 0; i < m_vertices + m_faces; ++i) {
        if (!nextLine()) {
            return Error{"The file ends after " + std::to_string(i) + " of its " +
                             std::to_string(m_vertices) + " vertices and " + std::to_string(m_faces) +
                             " faces.",
                         {},
                         kCutAdvice};
        }
        if (Status good = i < m_vertices ? parseVertex() : parseFace(); !good) {
            return good.error();
        }
        report();
    }
    if (Status set = setPositions(m_mesh, std::move(m_positions)); !set) {
        return set.error();
    }
    finish();
    return std::move(m_imported);
}

}  // namespace

Result<ImportedMesh> parseOff(std::string_view text, const ProgressSink& progress) {
    return OffParser(text, progress).parse();
}

}  // namespace hitscope
