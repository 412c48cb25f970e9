// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/obj_lines.h"

#include <cstring>

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

bool ObjLines::next(TextRange& line) {
    line.start = m_at;
    m_wantsMore = false;
    while (m_at < m_text.size()) {
        const std::size_t begin = m_at;
        const void* const found = std::memchr(m_text.data() + begin, m_lineEnd, m_text.size() - begin);
        const std::size_t stop =
            found ? static_cast<std::size_t>(static_cast<const char*>(found) - m_text.data()) : m_text.size();
        m_at = found ? stop + 1 : stop;
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
        if (m_line[at] == m_lineEnd) {
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
