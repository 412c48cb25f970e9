// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/obj_patcher.h"

#include <algorithm>

#include "io/number_text.h"
#include "io/writers/file_coordinate.h"
#include "mesh/same_bits.h"

namespace hitscope {
namespace {

/// Whether `values`, which rise, have one in [first, end).
bool hasBetween(const std::vector<std::uint32_t>& values, std::size_t first, std::size_t end) {
    const auto found = std::lower_bound(values.begin(), values.end(), first);
    return found != values.end() && *found < end;
}

/// "v", "v/t", "v//n" or "v/t/n" with another normal, counted from 0.
void appendCorner(std::string& out, std::string_view corner, std::uint32_t normal) {
    const std::size_t slash = corner.find('/');
    const std::size_t second = slash == corner.npos ? slash : corner.find('/', slash + 1);
    out += corner.substr(0, second);
    out += slash == corner.npos ? "//" : "/";
    appendNumber(out, std::uint64_t{normal} + 1);
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
    const std::vector<std::uint32_t>& corners = changes.mesh.cornerNormals;
    m_hasDangling = !changes.normals.added.empty() &&
                    std::find(corners.begin(), corners.end(), kNoIndex) != corners.end();
}

bool ObjPatcher::moved(std::size_t vertex) const {
    return !sameBits(m_changes.positions[vertex], m_changes.mesh.positions[vertex]);
}

bool ObjPatcher::changes(std::size_t p) const {
    const SourcePart& part = m_index.parts[p];
    const Counts& first = m_before[p];
    const Counts& end = m_before[p + 1];
    const std::uint64_t partEnd = part.start + part.size;
    const bool addsHere = !m_changes.normals.added.empty() && m_addAt >= part.start &&
                          (m_addAt < partEnd || (m_addAt == partEnd && p + 1 == m_index.parts.size()));
    const auto library = m_changes.libraries.lower_bound(first.libraries);
    if (addsHere || (m_hasDangling && part.faces > 0) ||
        hasBetween(m_changes.normals.replaced, first.normals, end.normals) ||
        hasBetween(m_changes.normals.corners, m_changes.mesh.faceStarts[first.faces],
                   m_changes.mesh.faceStarts[end.faces]) ||
        (library != m_changes.libraries.end() && library->first < end.libraries)) {
        return true;
    }
    std::size_t vertex = first.vertices;
    while (vertex < end.vertices && !moved(vertex)) {
        ++vertex;
    }
    return vertex < end.vertices;
}

void ObjPatcher::appendAdded(std::string& out) const {
    if (m_addAt == m_index.size && m_index.endsInLine) {
        out += m_index.newLine;
    }
    for (const glm::vec3& normal : m_changes.normals.added) {
        out += "vn";
        for (int i = 0; i < 3; ++i) {
            out += ' ';
            appendTwiceRoundedFloat(out, normal[i]);
        }
        out += m_index.newLine;
    }
}

void ObjPatcher::rewrite(std::size_t p, std::string_view text, std::string& out) const {
    const SourcePart& part = m_index.parts[p];
    Counts at = m_before[p];
    ObjLines lines(text, m_index.lineEnd);
    TextRange range;
    const bool adds = !m_changes.normals.added.empty();
    while (lines.next(range)) {
        const std::uint64_t start = part.start + range.start;
        if (adds && start == m_addAt) {
            appendAdded(out);
        }
        rewriteLine({text.substr(range.start, range.end - range.start), start}, at, out);
    }
    if (adds && m_addAt == m_index.size && p + 1 == m_index.parts.size()) {
        appendAdded(out);
    }
}

void ObjPatcher::rewriteLine(const Line& line, Counts& at, std::string& out) const {
    const NormalPlan& normals = m_changes.normals;
    const std::vector<std::uint32_t>& starts = m_changes.mesh.faceStarts;
    switch (keywordOf(line.text, m_index.lineEnd)) {
        case ObjKeyword::Vertex:
            if (moved(at.vertices++)) {
                return vertex(line.text, at.vertices - 1, out);
            }
            break;
        case ObjKeyword::Normal:
            ++at.normals;
            if (hasBetween(normals.replaced, at.normals - 1, at.normals)) {
                return normal(line.text, at.normals - 1, out);
            }
            break;
        case ObjKeyword::Face:
            if (normals.corners.empty() ||
                (m_faces == ObjFaces::OfThreeCorners && !isObjFace(line.text, m_index.lineEnd))) {
                break;
            }
            ++at.faces;
            if (m_hasDangling || hasBetween(normals.corners, starts[at.faces - 1], starts[at.faces])) {
                return face(line.text, at.faces - 1, out);
            }
            break;
        case ObjKeyword::Library:
            if (const auto found = m_changes.libraries.find(at.libraries++);
                found != m_changes.libraries.end()) {
                return library(line.text, found->second, out);
            }
            break;
        case ObjKeyword::Other:
            break;
    }
    out += line.text;
}

void ObjPatcher::vertex(std::string_view line, std::size_t vertex, std::string& out) const {
    const glm::vec3& now = m_changes.positions[vertex];
    ObjWords words(line, m_index.lineEnd);
    words.next();
    std::size_t copied = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const TextRange word = words.next();
        if (!isStill(m_changes.mesh, vertex, now, axis)) {
            out += line.substr(copied, word.start - copied);
            appendFileCoordinate(out, m_changes.mesh, vertex, now, axis);
            copied = word.end;
        }
    }
    out += line.substr(copied);
}

void ObjPatcher::normal(std::string_view line, std::size_t normal, std::string& out) const {
    const std::vector<std::uint32_t>& replaced = m_changes.normals.replaced;
    const auto found = std::lower_bound(replaced.begin(), replaced.end(), normal);
    const glm::vec3& value = m_changes.normals.values[static_cast<std::size_t>(found - replaced.begin())];
    ObjWords words(line, m_index.lineEnd);
    words.next();
    std::size_t copied = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const TextRange word = words.next();
        out += line.substr(copied, word.start - copied);
        appendTwiceRoundedFloat(out, value[axis]);
        copied = word.end;
    }
    out += line.substr(copied);
}

void ObjPatcher::face(std::string_view line, std::size_t face, std::string& out) const {
    const std::vector<std::uint32_t>& corners = m_changes.normals.corners;
    const std::size_t first = m_changes.mesh.faceStarts[face];
    const std::size_t end = m_changes.mesh.faceStarts[face + 1];
    auto next = std::lower_bound(corners.begin(), corners.end(), first);
    ObjWords words(line, m_index.lineEnd);
    words.next();
    std::size_t copied = 0;
    for (std::size_t c = first; c < end; ++c) {
        const TextRange word = words.next();
        const bool isOther = next != corners.end() && *next == c;
        if (!isOther && !(m_hasDangling && m_changes.mesh.cornerNormals[c] == kNoIndex)) {
            continue;
        }
        out += line.substr(copied, word.start - copied);
        if (isOther) {
            appendCorner(out, words.text(word),
                         m_changes.normals.cornerNormals[static_cast<std::size_t>(next - corners.begin())]);
            ++next;
        } else {
            out += withoutNormal(words.text(word));
        }
        copied = word.end;
    }
    out += line.substr(copied);
}

/// The name goes on to the line's end.
void ObjPatcher::library(std::string_view line, const std::string& name, std::string& out) const {
    ObjWords words(line, m_index.lineEnd);
    const TextRange keyword = words.next();
    out += line.substr(0, keyword.end);
    out += ' ';
    out += name;
    const std::size_t end = line.find_last_not_of("\r\n");
    out += end == line.npos ? std::string_view() : line.substr(end + 1);
}

}  // namespace hitscope
