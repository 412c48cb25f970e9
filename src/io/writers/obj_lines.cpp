// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/obj_lines.h"

#include <algorithm>
#include <cstring>

#include "io/readers/text_cursor.h"

namespace hitscope {
namespace {

bool isComment(std::string_view line) {
    std::size_t first = 0;
    while (first < line.size() && isSpace(line[first])) {
        ++first;
    }
    return first < line.size() && line[first] == '#';
}

}  // namespace

bool hidesObjLine(std::string_view line) {
    static constexpr std::string_view kKeywords[] = {
        "v",      "vn",   "vt",   "vp",    "f",    "fo",   "l",    "p",      "s",    "g",   "o",  "usemtl",
        "mtllib", "curv", "surf", "curv2", "trim", "hole", "scrv", "cstype", "bmat", "deg", "mg", "end"};
    const std::size_t begin = line.find_first_not_of(" \t\r\f\v");
    for (std::size_t at = line.find('\r', begin); at != line.npos; at = line.find('\r', at + 1)) {
        const std::string_view word = TextCursor(line.substr(at)).word();
        const bool isContinued = at > 0 && line[at - 1] == '\\' && !word.empty();
        if (isContinued || std::ranges::find(kKeywords, word) != std::end(kKeywords)) {
            return true;
        }
    }
    return false;
}

/// Where the line that begins at m_at ends; the text's end if nothing ends it.
std::size_t ObjLines::nextEnd() const {
    if (m_lineEnd == kAnyLineEnd) {
        return std::min(m_text.find_first_of("\r\n", m_at), m_text.size());
    }
    const void* const found = std::memchr(m_text.data() + m_at, m_lineEnd, m_text.size() - m_at);
    return found ? static_cast<std::size_t>(static_cast<const char*>(found) - m_text.data()) : m_text.size();
}

bool ObjLines::next(TextRange& line) {
    line.start = m_at;
    m_wantsMore = false;
    while (m_at < m_text.size()) {
        const std::size_t begin = m_at;
        const std::size_t stop = nextEnd();
        m_at = std::min(stop + 1, m_text.size());
        if (m_lineEnd == kAnyLineEnd && m_text.substr(stop, 2) == "\r\n") {
            ++m_at;
        }
        std::size_t last = stop;
        while (last > begin && isSpace(m_text[last - 1])) {
            --last;
        }
        if (last == begin || m_text[last - 1] != '\\' || isComment(m_text.substr(begin, last - begin))) {
            break;
        }
        m_wantsMore = m_at == m_text.size();
    }
    line.end = m_at;
    return line.end > line.start;
}

/// A backslash counts as blank where only blanks follow it on its line.
bool ObjWords::isContinued(std::size_t at) const {
    for (++at; at < m_line.size() && isSpace(m_line[at]); ++at) {
        if (isLineEnd(m_line[at], m_lineEnd)) {
            return true;
        }
    }
    return at == m_line.size();
}

ObjKeyword keywordOf(std::string_view line, char lineEnd) {
    // Most lines begin at once with a keyword and a blank.
    if (line.size() > 2 && line[1] == ' ' && (line[0] == 'v' || line[0] == 'f')) {
        return line[0] == 'v' ? ObjKeyword::Vertex : ObjKeyword::Face;
    }
    if (line.size() > 3 && line[0] == 'v' && line[2] == ' ' && (line[1] == 'n' || line[1] == 't')) {
        return line[1] == 'n' ? ObjKeyword::Normal : ObjKeyword::Other;
    }
    if (!line.empty() && line.front() == '#') {
        return ObjKeyword::Other;
    }
    ObjWords words(line, lineEnd);
    const std::string_view keyword = words.text(words.next());
    return keyword == "v"                      ? ObjKeyword::Vertex
           : keyword == "f" || keyword == "fo" ? ObjKeyword::Face
           : keyword == "vn"                   ? ObjKeyword::Normal
           : keyword == "mtllib"               ? ObjKeyword::Library
                                               : ObjKeyword::Other;
}

}  // namespace hitscope
