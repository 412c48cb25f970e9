// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/stl_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/readers/text_cursor.h"
#include "io/readers/tidy.h"
#include "io/welder.h"

#include "core/finite.h"

namespace hitscope {
namespace {

static_assert(std::endian::native == std::endian::little, "STL's floats are copied as they are");

constexpr std::size_t kHeaderSize = 80;  // bytes
constexpr std::size_t kStart = kHeaderSize + sizeof(std::uint32_t);
constexpr std::size_t kFacetSize = 50;  // normal, three vertices, two bytes of attributes
constexpr std::size_t kReportEvery = 1 << 16;

Error badCoordinate(const std::string& where) {
    return {"A coordinate is not a number, infinite or too large.", where,
            "Repair the mesh in the program it came from."};
}

void endFace(MeshData& mesh) {
    if (mesh.faceStarts.empty()) {
        mesh.faceStarts.push_back(0);
    }
    mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.cornerVertices.size()));
}

std::uint32_t promisedFacets(std::string_view file) {
    std::uint32_t facets = 0;
    std::memcpy(&facets, file.data() + kHeaderSize, sizeof facets);
    return facets;
}

std::string_view withoutMark(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

/// Some programs write them in capitals.
bool isKeyword(std::string_view word, std::string_view keyword) {
    constexpr unsigned kSmall = 0x20;  // the bit in which letters differ
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), [](char a, char b) {
        return (static_cast<unsigned char>(a) | kSmall) == static_cast<unsigned char>(b);
    });
}

/// Some programs begin binary files with "solid" too: what decides is whether the size fits.
bool isBinary(std::string_view file) {
    if (file.size() >= kStart && file.size() == kStart + kFacetSize * std::size_t{promisedFacets(file)}) {
        return true;
    }
    constexpr std::string_view kStartOfText = "solid";
    TextCursor text(withoutMark(file).substr(0, 1024));
    text.skipBlanks(true);
    if (!isKeyword(text.rest().substr(0, kStartOfText.size()), kStartOfText)) {
        return true;
    }
    return text.rest().find('\0') != std::string_view::npos;
}

Result<ImportedMesh> parseBinary(std::string_view file, const ProgressSink& progress) {
    if (file.size() < kStart) {
        return Error{
            "It is too short for an STL file.", {}, "Check that the file is whole, and an STL file."};
    }
    const std::size_t facets = promisedFacets(file);
    const std::size_t room = (file.size() - kStart) / kFacetSize;
    if (facets > room) {
        return Error{"It promises " + std::to_string(facets) + " triangles, but ends after " +
                         std::to_string(room) + ".",
                     {},
                     std::string(kCutAdvice) + " If it never was an STL file, its suffix is wrong."};
    }
    ImportedMesh imported;
    Welder welder(imported.mesh.positions);
    imported.mesh.cornerVertices.reserve(3 * facets);
    imported.mesh.faceStarts.reserve(facets + 1);
    for (std::size_t f = 0; f < facets; ++f) {
        float numbers[9];
        std::memcpy(numbers, file.data() + kStart + kFacetSize * f + sizeof(glm::vec3), sizeof numbers);
        for (const float* at = numbers; at != numbers + 9; at += 3) {
            const glm::vec3 corner(at[0], at[1], at[2]);
            if (!isFinite(corner)) {
                return badCoordinate("triangle " + std::to_string(f + 1));
            }
            imported.mesh.cornerVertices.push_back(welder.index(corner));
        }
        endFace(imported.mesh);
        if (progress && f % kReportEvery == 0) {
            progress(static_cast<double>(f) / static_cast<double>(facets), "Reading STL");
        }
    }
    if (file.size() > kStart + kFacetSize * facets) {
        imported.notes += QStringLiteral("The file goes on after its last triangle; the rest was not read.");
    }
    return imported;
}

/// solid NAME / facet normal x y z / outer loop / vertex x y z (three or more) / endloop / endfacet /
/// endsolid
class AsciiParser {
public:
    AsciiParser(std::string_view file, const ProgressSink& progress)
        : m_size(file.size()), m_lines(file), m_progress(progress), m_welder(m_imported.mesh.positions) {}

    Result<ImportedMesh> parse();

private:
    [[nodiscard]] std::string place() const { return "line " + std::to_string(m_line); }
    Status parseVertex(TextCursor& line);
    void endLoop();
    Status parseLine(std::string_view text);

    std::size_t m_size;
    TextCursor m_lines;
    const ProgressSink& m_progress;
    ImportedMesh m_imported;
    Welder<> m_welder;
    std::size_t m_line = 0;
    std::size_t m_faceStart = 0;
    std::size_t m_smallFaces = 0;
    bool m_inSolid = false;
    bool m_inFacet = false;
    bool m_inLoop = false;
};

Status AsciiParser::parseVertex(TextCursor& line) {
    glm::vec3 position;
    for (int i = 0; i < 3; ++i) {
        line.skipBlanks();
        const std::optional<double> value = line.number();
        if (!value) {
            return Error{m_lines.atEnd() ? "The file ends in the middle of a vertex."
                                         : "A vertex needs three numbers.",
                         place(), kCutAdvice};
        }
        position[i] = static_cast<float>(*value);
    }
    if (!isFinite(position)) {
        return badCoordinate(place());
    }
    m_imported.mesh.cornerVertices.push_back(m_welder.index(position));
    return Done{};
}

void AsciiParser::endLoop() {
    m_inLoop = false;
    std::vector<std::uint32_t>& corners = m_imported.mesh.cornerVertices;
    if (corners.size() - m_faceStart < 3) {
        corners.resize(m_faceStart);
        ++m_smallFaces;
    } else {
        endFace(m_imported.mesh);
        m_faceStart = corners.size();
    }
}

Status AsciiParser::parseLine(std::string_view text) {
    TextCursor line(text);
    const std::string_view keyword = line.word();
    if (isKeyword(keyword, "vertex")) {
        return parseVertex(line);
    }
    if (isKeyword(keyword, "outer")) {
        m_inLoop = true;
    } else if (isKeyword(keyword, "endloop")) {
        endLoop();
    } else if (isKeyword(keyword, "facet")) {
        m_inFacet = true;
    } else if (isKeyword(keyword, "endfacet")) {
        m_inFacet = false;
    } else if (isKeyword(keyword, "endsolid")) {
        m_inSolid = false;
    } else if (isKeyword(keyword, "solid")) {
        m_inSolid = true;
        line.skipBlanks();
        std::string name(line.rest());
        while (!name.empty() && TextCursor::isBlank(name.back())) {
            name.pop_back();
        }
        if (!name.empty()) {
            m_imported.mesh.groups.push_back({FaceGroup::Kind::Object, std::move(name),
                                              static_cast<std::uint32_t>(m_imported.mesh.faceCount())});
        }
    }
    return Done{};
}

Result<ImportedMesh> AsciiParser::parse() {
    while (!m_lines.atEnd()) {
        ++m_line;
        if (const Status parsed = parseLine(m_lines.line()); !parsed) {
            return parsed.error();
        }
        if (m_progress && m_line % kReportEvery == 0) {
            m_progress(static_cast<double>(m_lines.offset()) / static_cast<double>(m_size), "Reading STL");
        }
    }
    if (m_inLoop || m_inFacet) {
        return Error{"The file ends in the middle of a triangle.", place(), kCutAdvice};
    }
    m_imported.mesh.cornerVertices.resize(m_faceStart);
    if (m_inSolid) {
        m_imported.notes +=
            QStringLiteral("The file ends without \"endsolid\". If it was cut off, triangles are missing.");
    }
    if (m_smallFaces > 0) {
        m_imported.notes += counted(m_smallFaces, "facet with fewer than three vertices was left out.",
                                    "facets with fewer than three vertices were left out.");
    }
    return std::move(m_imported);
}

}  // namespace

Result<ImportedMesh> parseStl(std::string_view file, const ProgressSink& progress) {
    Result<ImportedMesh> parsed =
        isBinary(file) ? parseBinary(file, progress) : AsciiParser(withoutMark(file), progress).parse();
    if (parsed) {
        placeIfExtreme(parsed.value());
    }
    return parsed;
}

}  // namespace hitscope
