// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/obj_patcher.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

#include "io/eight_digits.h"
#include "io/float_text.h"
#include "io/writers/file_coordinate.h"

namespace hitscope {
namespace {

constexpr std::size_t kAddedAtOnce = 8192;  // normals
constexpr std::size_t kIndexText = 12;      // of a number of a normal, with its slashes

char* copyText(char* to, std::string_view text) {
    std::memcpy(to, text.data(), text.size());
    return to + text.size();
}

char* writeIndex(char* to, std::uint32_t index) {
    return index < kMostOfEightDigits ? writeShortNumber(to, index + 1)
                                      : std::to_chars(to, to + kIndexText, index + 1).ptr;
}

/// Copies digits, eight at a time: may read and write so many bytes more.
void copyDigits(const char*& from, char*& to) {
    if constexpr (std::endian::native == std::endian::little) {
        constexpr std::uint64_t kHighest = 0x8080808080808080u;
        std::size_t digits = sizeof(std::uint64_t);
        while (digits == sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, from, sizeof word);
            std::memcpy(to, &word, sizeof word);
            word ^= 0x3030303030303030u;  // digits: 0 to 9
            const std::uint64_t others = (((word & ~kHighest) + 0x7676767676767676u) | word) & kHighest;
            digits = static_cast<std::size_t>(std::countr_zero(others)) / 8;
            from += digits;
            to += digits;
        }
    } else {
        while (*from >= '0' && *from <= '9') {
            *to++ = *from++;
        }
    }
}

/// "v", "v/t", "v//n" or "v/t/n" with another normal, counted from 0.
char* writeCorner(char* to, std::string_view corner, std::uint32_t normal) {
    const std::size_t slash = corner.find('/');
    const std::size_t second = slash == corner.npos ? slash : corner.find('/', slash + 1);
    to = copyText(to, corner.substr(0, second));
    to = copyText(to, slash == corner.npos ? "//" : "/");
    return writeIndex(to, normal);
}

/// "v" or "v/t": without its normal.
std::string_view withoutNormal(std::string_view corner) {
    const std::size_t slash = corner.find('/');
    const std::size_t second = slash == corner.npos ? slash : corner.find('/', slash + 1);
    return second == corner.npos ? corner : corner.substr(0, second == slash + 1 ? slash : second);
}

}  // namespace

ObjPatcher::ObjPatcher(const ObjChanges& changes, const ObjIndex& index, ObjFaces faces)
    : m_changes(changes), m_index(index), m_faces(faces) {
    Counts count;
    m_before.push_back(count);
    for (const SourcePart& part : index.parts) {
        count.vertices += part.vertices;
        count.normals += part.normals;
        count.faces += part.faces;
        count.libraries += part.libraries;
        m_before.push_back(count);
    }
    // Behind the last of the file's normals no number of theirs changes; faces that count from the end see
    // the added ones unless they come last of all.
    m_addAt = index.hasRelativeNormals ? index.size
              : index.afterNormals > 0 ? index.afterNormals
                                       : index.firstFace;
}

/// Whether added normals would come in the part.
bool ObjPatcher::canAddIn(std::size_t p) const {
    const SourcePart& part = m_index.parts[p];
    const std::uint64_t end = part.start + part.size;
    return m_addAt >= part.start && (m_addAt < end || (m_addAt == end && p + 1 == m_index.parts.size()));
}

bool ObjPatcher::needsNormals(std::size_t p) const {
    return m_index.parts[p].normals > 0 || m_index.parts[p].faces > 0 || canAddIn(p);
}

const NormalPlan& ObjPatcher::normalsOf(std::size_t p) const {
    static const NormalPlan kNone;
    return needsNormals(p) ? m_normals : kNone;
}

bool ObjPatcher::addsIn(std::size_t p) const {
    return canAddIn(p) && !m_normals.added.empty();
}

bool ObjPatcher::changesNormals(std::size_t p) const {
    const NormalPlan& normals = normalsOf(p);
    const std::size_t first = m_before[p].normals;
    const auto replaced = std::lower_bound(normals.replaced.begin(), normals.replaced.end(), first);
    if (addsIn(p) || (replaced != normals.replaced.end() && *replaced < m_before[p + 1].normals)) {
        return true;
    }
    const std::vector<std::uint32_t>& starts = m_changes.mesh.faceStarts;
    return m_index.parts[p].faces > 0 &&
           (normals.hasDangling ||
            normals.corners.hasBetween(starts[m_before[p].faces], starts[m_before[p + 1].faces]));
}

bool ObjPatcher::changes(std::size_t p) const {
    const Counts& first = m_before[p];
    const Counts& end = m_before[p + 1];
    const auto library = m_changes.libraries.lower_bound(first.libraries);
    if ((library != m_changes.libraries.end() && library->first < end.libraries) || changesNormals(p)) {
        return true;
    }
    const std::span<const std::uint8_t> moved =
        m_changes.moved.subspan(first.vertices, end.vertices - first.vertices);
    return std::find(moved.begin(), moved.end(), 1) != moved.end();
}

void ObjPatcher::appendAdded(std::size_t piece, TextBuffer& out) const {
    if (piece == 0 && m_addAt == m_index.size) {
        out.append(m_index.endsInLine ? m_index.newLine : "");
        out.append(m_index.endsContinued ? m_index.newLine : "");  // an empty line continues it
    }
    const std::span<const glm::vec3> all = m_normals.added;
    const std::size_t first = piece * kAddedAtOnce;
    for (const glm::vec3& normal : all.subspan(first, std::min(kAddedAtOnce, all.size() - first))) {
        char* to = copyText(out.room(2 + 3 * (1 + kFloatText) + m_index.newLine.size()), "vn");
        for (int i = 0; i < 3; ++i) {
            *to++ = ' ';
            to = writeSixDecimals(to, normal[i]);
        }
        out.endAt(copyText(to, m_index.newLine));
    }
}

/// A part's text, of which lines that stay are copied, many at once.
class ObjPatcher::Part {
public:
    Part(std::string_view text, const NormalPlan& normals, TextBuffer& out)
        : m_text(text), m_normals(normals), m_out(out) {}
    [[nodiscard]] const NormalPlan& normals() const { return m_normals; }
    [[nodiscard]] std::string_view line(const TextRange& range) const {
        return m_text.substr(range.start, range.end - range.start);
    }
    /// Where a line is written that comes instead of [line.start, line.end).
    TextBuffer& instead(const TextRange& line) {
        m_out.append(m_text.substr(m_copied, line.start - m_copied));
        m_copied = line.end;
        return m_out;
    }

private:
    std::string_view m_text;
    const NormalPlan& m_normals;
    TextBuffer& m_out;
    std::size_t m_copied = 0;
};

std::size_t ObjPatcher::pieces(std::size_t p) const {
    return addsIn(p) ? 2 + (m_normals.added.size() + kAddedAtOnce - 1) / kAddedAtOnce : 1;
}

void ObjPatcher::rewrite(std::size_t p, std::size_t piece, std::string_view text, TextBuffer& out) const {
    const std::size_t last = pieces(p) - 1;
    if (piece > 0 && piece < last) {
        appendAdded(piece - 1, out);
        return;
    }
    const std::size_t middle = last > 0 ? m_addAt - m_index.parts[p].start : text.size();
    if (piece == 0) {
        rewriteLines(p, text, 0, middle, out);
    } else {
        rewriteLines(p, text, middle, text.size(), out);
    }
}

/// Appends the new text of the lines in [from, to) of the part.
void ObjPatcher::rewriteLines(std::size_t p, std::string_view text, std::size_t from, std::size_t to,
                              TextBuffer& out) const {
    Part part(text, normalsOf(p), out);
    const std::vector<std::uint32_t>& replaced = part.normals().replaced;
    Counts at = m_before[p];
    at.replaced = static_cast<std::size_t>(std::lower_bound(replaced.begin(), replaced.end(), at.normals) -
                                           replaced.begin());
    ObjLines lines(text, m_index.lineEnd);
    TextRange line;
    while (lines.next(line) && line.start < to) {
        if (from > 0 && line.start == from) {
            part.instead({from, from});
            out.clear();  // of the lines before only the numbers matter
        }
        rewriteLine(line, at, part);
    }
    part.instead({to, to});
    if (from > 0 && from == text.size()) {
        out.clear();
    }
}

void ObjPatcher::rewriteLine(const TextRange& range, Counts& at, Part& part) const {
    const NormalPlan& normals = part.normals();
    const std::vector<std::uint32_t>& starts = m_changes.mesh.faceStarts;
    const std::string_view line = part.line(range);
    switch (keywordOf(line, m_index.lineEnd)) {
        case ObjKeyword::Vertex:
            if (m_changes.moved[at.vertices++] != 0) {
                vertex(line, at.vertices - 1, part.instead(range));
            }
            break;
        case ObjKeyword::Normal:
            if (at.replaced < normals.replaced.size() && normals.replaced[at.replaced] == at.normals) {
                normal(line, normals.values[at.replaced++], part.instead(range));
            }
            ++at.normals;
            break;
        case ObjKeyword::Face:
            if (normals.corners.empty() ||
                (m_faces == ObjFaces::OfThreeCorners && !isObjFace(line, m_index.lineEnd))) {
                break;
            }
            ++at.faces;
            if (normals.hasDangling || normals.corners.hasBetween(starts[at.faces - 1], starts[at.faces])) {
                face(line, at.faces - 1, part.instead(range));
            }
            break;
        case ObjKeyword::Library:
            if (const auto found = m_changes.libraries.find(at.libraries++);
                found != m_changes.libraries.end()) {
                library(line, found->second, part.instead(range));
            }
            break;
        case ObjKeyword::Other:
            break;
    }
}

void ObjPatcher::vertex(std::string_view line, std::size_t vertex, TextBuffer& out) const {
    const glm::vec3& now = m_changes.positions[vertex];
    char* to = out.room(line.size() + 3 * kNumberText);
    ObjWords words(line, m_index.lineEnd);
    words.next();
    std::size_t copied = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const TextRange word = words.next();
        const bool stays = m_changes.isElsewhere ? isInFile(m_changes.mesh, vertex, now, axis)
                                                 : isStill(m_changes.mesh, vertex, now, axis);
        if (!stays) {
            to = copyText(to, line.substr(copied, word.start - copied));
            to = m_changes.isElsewhere ? writeFloat(to, now[axis])
                                       : writeFileCoordinate(to, m_changes.mesh, vertex, now, axis);
            copied = word.end;
        }
    }
    out.endAt(copyText(to, line.substr(copied)));
}

void ObjPatcher::normal(std::string_view line, const glm::vec3& value, TextBuffer& out) const {
    char* to = out.room(line.size() + 3 * kFloatText);
    ObjWords words(line, m_index.lineEnd);
    words.next();
    std::size_t copied = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const TextRange word = words.next();
        to = copyText(to, line.substr(copied, word.start - copied));
        to = writeSixDecimals(to, value[axis]);
        copied = word.end;
    }
    out.endAt(copyText(to, line.substr(copied)));
}

/// Most lines: of digits, slashes and blanks. False for others, without having written anything.
bool ObjPatcher::plainFace(std::string_view line, std::size_t face, TextBuffer& out) const {
    const std::size_t first = m_changes.mesh.faceStarts[face];
    const std::size_t end = m_changes.mesh.faceStarts[face + 1];
    const NormalPlan& normals = m_normals;
    // What ends the line ends its last number too.
    if (normals.hasDangling || line.size() < 2 || line[0] != 'f' || line[1] != ' ' || !isSpace(line.back())) {
        return false;
    }
    const char* at = line.data() + 1;
    char* to = out.room(line.size() + kIndexText * (end - first) + kPadding);
    *to++ = 'f';
    for (std::size_t c = first; c < end; ++c) {
        while (*at == ' ') {
            *to++ = *at++;
        }
        const char* const vertex = to;
        copyDigits(at, to);
        if (to == vertex) {
            return false;
        }
        const char* const texcoord = to;
        if (*at == '/') {
            *to++ = *at++;
            copyDigits(at, to);
        }
        const bool isOther = normals.corners.has(c);
        if (isOther && to <= texcoord + 1) {
            *(to == texcoord ? to++ : to - 1) = '/';
        }
        char* const slash = to;
        if (*at == '/') {
            *to++ = *at++;
            copyDigits(at, to);
        }
        if (isOther) {
            *slash = '/';
            to = writeIndex(slash + 1, normals.numberOf(c));
        }
        if (!isSpace(*at)) {
            return false;
        }
    }
    out.endAt(copyText(to, {at, static_cast<std::size_t>(line.data() + line.size() - at)}));
    return true;
}

void ObjPatcher::face(std::string_view line, std::size_t face, TextBuffer& out) const {
    if (plainFace(line, face, out)) {
        return;
    }
    const std::size_t first = m_changes.mesh.faceStarts[face];
    const std::size_t end = m_changes.mesh.faceStarts[face + 1];
    char* to = out.room(line.size() + kIndexText * (end - first));
    ObjWords words(line, m_index.lineEnd);
    words.next();
    std::size_t copied = 0;
    for (std::size_t c = first; c < end; ++c) {
        const TextRange word = words.next();
        const bool isOther = m_normals.corners.has(c);
        if (!isOther && !(m_normals.hasDangling && m_changes.mesh.cornerNormals[c] == kNoIndex)) {
            continue;
        }
        to = copyText(to, line.substr(copied, word.start - copied));
        to = isOther ? writeCorner(to, words.text(word), m_normals.numberOf(c))
                     : copyText(to, withoutNormal(words.text(word)));
        copied = word.end;
    }
    out.endAt(copyText(to, line.substr(copied)));
}

/// The name goes on to the line's end.
void ObjPatcher::library(std::string_view line, const std::string& name, TextBuffer& out) const {
    ObjWords words(line, m_index.lineEnd);
    const TextRange keyword = words.next();
    out.append(line.substr(0, keyword.end));
    out.append(" ");
    out.append(name);
    const std::size_t end = line.find_last_not_of("\r\n");
    out.append(end == line.npos ? std::string_view() : line.substr(end + 1));
}

}  // namespace hitscope
