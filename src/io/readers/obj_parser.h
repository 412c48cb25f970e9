// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/imported_mesh.h"
#include "io/readers/text_cursor.h"

namespace hitscope {

/// Indices that point beyond what has been read so far may still turn out good: the largest is remembered.
struct LargestIndex {
    long long index = 0;
    std::size_t line = 0;
};

/// What a run of an OBJ file's lines says. Indices are those of the whole file.
struct ObjPart {
    /// But for positions and colours; faceStarts from 0, and groups and materials counted from the part's
    /// first.
    MeshData mesh;
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> colours;          ///< of the first vertices; those behind have none
    std::optional<std::uint32_t> material;   ///< at the part's end, if a line set it
    std::optional<std::uint32_t> smoothing;  ///< likewise
    std::size_t facesBeforeMaterial = 0;     ///< faces with the material of the parts before
    std::size_t facesBeforeSmoothing = 0;    ///< likewise
    LargestIndex largest;
    std::size_t smallFaces = 0;
    std::size_t smallLines = 0;
    std::size_t freeForm = 0;
    std::optional<Error> error;  ///< the first line that is wrong
    bool hidesLine = false;      ///< it is, as it has a carriage return that ends a line

    [[nodiscard]] std::size_t faceCount() const { return mesh.faceStarts.size() - 1; }
};

/// Reads the lines of an OBJ file.
class ObjParser {
public:
    enum class Whole : std::uint8_t {
        Yes,
        No  ///< what needs the lines before (an index from the end) is an error
    };
    /// Told how many bytes of the text have been read.
    using Told = std::function<void(std::size_t bytes)>;

    /// `told` outlives this.
    ObjParser(std::string_view text, Whole whole, const Told& told)
        : m_text(text), m_isWhole(whole == Whole::Yes), m_told(told) {}

    /// Once.
    ObjPart parse();
    [[nodiscard]] static Error errorAt(const std::string& what, std::size_t line);

private:
    std::string_view nextLine(TextCursor& text);
    void parseLine(std::string_view line);
    void parseVertex(TextCursor& line);
    void parseNormal(TextCursor& line);
    void parseTexcoord(TextCursor& line);
    void parseFace(TextCursor& line);
    void parseLineElement(TextCursor& line);
    void parsePoints(TextCursor& line);
    void parseSmoothing(TextCursor& line);
    bool parseCorner(TextCursor& line);
    bool parseName(std::string_view keyword, TextCursor& line);
    void useMaterial(std::string_view name);
    std::uint32_t vertexIndex(long long written, const char* of);
    std::uint32_t otherIndex(long long written, std::size_t count) const;
    [[nodiscard]] Error errorHere(const std::string& what) const;

    std::string_view m_text;
    bool m_isWhole;
    const Told& m_told;
    ObjPart m_part;
    MeshData& m_mesh = m_part.mesh;
    std::unordered_map<std::string, std::uint32_t> m_materials;
    std::size_t m_line = 0;
    std::string m_joined;        ///< a line that was continued with a backslash
    bool m_lastLineCut = false;  ///< the line being read is the last, and has no line end
};

}  // namespace hitscope
