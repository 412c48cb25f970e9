// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/obj_index.h"

#include <sys/stat.h>

#include <algorithm>
#include <string_view>

#include "io/content_hash.h"
#include "io/descriptor.h"
#include "io/writers/obj_lines.h"

namespace hitscope {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class Indexer {
public:
    Indexer(int descriptor, const std::function<bool(double)>& goOn)
        : m_descriptor(descriptor), m_goOn(goOn) {}

    std::optional<ObjIndex> index();

private:
    bool findLineEnd();
    void takeLines(bool isLast);
    void take(ObjPart& part, std::string_view line, std::uint64_t start);
    void takeFace(ObjPart& part, std::string_view line, std::uint64_t start);

    int m_descriptor;
    const std::function<bool(double)>& m_goOn;
    ObjIndex m_index;
    std::string m_text;             // from a line's start on
    std::uint64_t m_textStart = 0;  // in the file
};

/// The line end is the reader's: '\r' only where no '\n' is in the whole file.
bool Indexer::findLineEnd() {
    std::string piece;
    bool hasReturn = false;
    for (std::uint64_t at = 0; at < m_index.size; at += piece.size()) {
        piece.resize(std::min<std::uint64_t>(m_index.size - at, 1 << 16));
        if (!readAt(m_descriptor, at, piece.data(), piece.size())) {
            return false;
        }
        const std::size_t end = piece.find('\n');
        if (end != piece.npos) {
            m_index.newLine = end > 0 && piece[end - 1] == '\r' ? "\r\n" : "\n";
            return true;
        }
        hasReturn = hasReturn || piece.find('\r') != piece.npos;
    }
    if (hasReturn) {
        m_index.lineEnd = '\r';
        m_index.newLine = "\r";
    }
    return true;
}

void Indexer::takeFace(ObjPart& part, std::string_view line, std::uint64_t start) {
    ObjWords words(line, m_index.lineEnd);
    words.next();
    int corners = 0;
    for (TextRange word = words.next(); word.end > word.start; word = words.next()) {
        const std::string_view corner = words.text(word);
        if (corner.front() == '#' || (++corners >= 3 && m_index.hasRelativeNormals)) {
            break;
        }
        m_index.hasRelativeNormals = m_index.hasRelativeNormals || corner.find("/-") != corner.npos;
    }
    if (corners >= 3) {
        m_index.firstFace = std::min(m_index.firstFace, start);
        ++part.faces;
    }
}

void Indexer::take(ObjPart& part, std::string_view line, std::uint64_t start) {
    switch (keywordOf(line, m_index.lineEnd)) {
        case ObjKeyword::Vertex:
            ++part.vertices;
            break;
        case ObjKeyword::Normal:
            ++part.normals;
            m_index.afterNormals = start + line.size();
            break;
        case ObjKeyword::Face:
            takeFace(part, line, start);
            break;
        case ObjKeyword::Library:
            ++part.libraries;
            break;
        case ObjKeyword::Other:
            break;
    }
}

/// All lines but the last, which may go on in the next piece.
void Indexer::takeLines(bool isLast) {
    ObjPart part{m_textStart};
    ObjLines lines(m_text, m_index.lineEnd);
    TextRange line;
    std::size_t done = 0;
    while (lines.next(line) && (isLast || line.end < m_text.size())) {
        take(part, std::string_view(m_text).substr(line.start, line.end - line.start),
             m_textStart + line.start);
        done = line.end;
    }
    if (done > 0) {
        part.size = done;
        m_index.parts.push_back(part);
        m_textStart += done;
        m_text.erase(0, done);
    }
}

std::optional<ObjIndex> Indexer::index() {
    struct stat info {};
    if (::fstat(m_descriptor, &info) != 0 || !S_ISREG(info.st_mode)) {
        return std::nullopt;
    }
    m_index.size = static_cast<std::uint64_t>(info.st_size);
    m_index.firstFace = m_index.size;
    if (!findLineEnd()) {
        return std::nullopt;
    }
    ContentHasher hasher;
    for (std::uint64_t at = 0; at < m_index.size;) {
        const std::size_t size = std::min<std::uint64_t>(m_index.size - at, ContentHasher::kHashedPiece);
        const std::size_t before = m_text.size();
        m_text.resize(before + size);
        if (!readAt(m_descriptor, at, m_text.data() + before, size)) {
            return std::nullopt;
        }
        hasher.add(std::string_view(m_text).substr(before));
        if (at == 0 && m_text.starts_with(kByteOrderMark)) {
            m_text.erase(0, kByteOrderMark.size());
            m_textStart = kByteOrderMark.size();
        }
        at += size;
        m_index.endsInLine = m_text.empty() || m_text.back() != m_index.lineEnd;
        takeLines(at == m_index.size);
        if (m_goOn && !m_goOn(static_cast<double>(at) / static_cast<double>(m_index.size))) {
            return std::nullopt;
        }
    }
    m_index.hash = hasher.hash();
    return std::move(m_index);
}

}  // namespace

std::optional<ObjIndex> indexObj(int descriptor, const std::function<bool(double)>& goOn) {
    return Indexer(descriptor, goOn).index();
}

}  // namespace hitscope
