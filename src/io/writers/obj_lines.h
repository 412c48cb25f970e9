// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hitscope {

/// What a line of an OBJ file begins with, as far as an export may change it.
enum class ObjKeyword : std::uint8_t { Vertex, Normal, Face, Library, Other };

/// Bytes [start, end) of a text.
struct TextRange {
    std::size_t start = 0;
    std::size_t end = 0;
};

/// What ends the lines of a file with line ends of several kinds: '\n', '\r', or both together.
inline constexpr char kAnyLineEnd = '\0';

inline bool isLineEnd(char c, char lineEnd) {
    return lineEnd == kAnyLineEnd ? c == '\n' || c == '\r' : c == lineEnd;
}

/// Whether a carriage return in a line that ends with '\n' ends it for whoever wrote what comes behind: lines
/// would be missed.
[[nodiscard]] bool hidesObjLine(std::string_view line);

/// What separates words.
inline bool isSpace(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Goes through the lines of an OBJ file as its reader does (readers/obj_parser.cpp): those that a backslash
/// continues are one; comments go to their line's end. It changes nothing, so that what it gives can be found
/// in the file.
class ObjLines {
public:
    /// lineEnd: '\n', '\r' for files of old Macs, or kAnyLineEnd.
    ObjLines(std::string_view text, char lineEnd) : m_text(text), m_lineEnd(lineEnd) {}

    /// The next line with its end; false where there is none.
    bool next(TextRange& line);
    /// Whether the line that next() gave ends with the text and a backslash: another would continue it.
    [[nodiscard]] bool wantsMore() const { return m_wantsMore; }

private:
    std::string_view m_text;
    std::size_t m_at = 0;
    [[nodiscard]] std::size_t nextEnd() const;

    bool m_wantsMore = false;
    char m_lineEnd;
};

/// Goes through the words of one line: what stands between blanks and continued line ends.
class ObjWords {
public:
    ObjWords(std::string_view line, char lineEnd) : m_line(line), m_lineEnd(lineEnd) {}

    /// The next word, within the line; empty where there is none.
    TextRange next() {
        while (m_at < m_line.size() && isBlank(m_at)) {
            ++m_at;
        }
        TextRange word{m_at, m_at};
        while (m_at < m_line.size() && !isBlank(m_at)) {
            ++m_at;
        }
        word.end = m_at;
        return word;
    }
    [[nodiscard]] std::string_view text(const TextRange& word) const {
        return m_line.substr(word.start, word.end - word.start);
    }

private:
    [[nodiscard]] bool isBlank(std::size_t at) const {
        return isSpace(m_line[at]) || (m_line[at] == '\\' && isContinued(at));
    }
    [[nodiscard]] bool isContinued(std::size_t at) const;

    std::string_view m_line;
    std::size_t m_at = 0;
    char m_lineEnd;
};

[[nodiscard]] ObjKeyword keywordOf(std::string_view line, char lineEnd);

}  // namespace hitscope
