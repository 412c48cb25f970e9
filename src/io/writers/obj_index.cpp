// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/obj_index.h"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>

#include "core/parallel.h"
#include "io/content_hash.h"
#include "io/descriptor.h"
#include "io/writers/obj_lines.h"

namespace hitscope {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::uint64_t kPiece = ContentHasher::kHashedPiece;
constexpr std::size_t kPart = 256 << 10;        // bytes, and what is left at a piece's end
constexpr std::uint64_t kLeastRange = 4 << 20;  // bytes; shorter ones are read sooner than a thread starts

/// What the lines of a range of the file come to.
struct Range {
    std::uint64_t start = 0;  // of its first line
    std::uint64_t end = 0;
    std::size_t firstPiece = 0;  // those of the file that it hashes
    std::size_t endPiece = 0;
    std::vector<SourcePart> parts;
    std::uint64_t afterNormals = 0;
    std::uint64_t firstFace = 0;  // its end: none
    bool hasRelativeNormals = false;
    bool endsContinued = false;
    bool hidesLine = false;
    bool isRead = true;
};

/// A face's number that counts from the end, of a normal or a texture coordinate.
bool hasRelativeNumber(std::string_view text, const SourcePart& part) {
    if (part.faces == 0) {
        return false;
    }
    // The numbers of vertices have signs too; where there are none, one sign is enough to look for.
    return text.find('-') != text.npos && (part.vertices + part.normals == 0 || text.find("/-") != text.npos);
}

/// Whether a carriage return comes before something else than a line feed.
bool hasLoneReturn(std::string_view text) {
    if (text.find('\r') == text.npos) {
        return false;
    }
    std::uint8_t found = 0;
    const char* const bytes = text.data();
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {  // without a branch: many bytes at once
        found |= static_cast<std::uint8_t>(static_cast<std::uint8_t>(bytes[i] == '\r') &
                                           static_cast<std::uint8_t>(bytes[i + 1] != '\n'));
    }
    return found != 0;
}

class Indexer {
public:
    /// lineEnd: kAnyLineEnd, or '\n' where the file is to be asked.
    Indexer(int descriptor, ObjFaces faces, char lineEnd, const std::function<bool(double)>& goOn)
        : m_descriptor(descriptor), m_faces(faces), m_goOn(goOn) {
        m_index.lineEnd = lineEnd;
    }

    std::optional<ObjIndex> index();
    /// Whether there are line ends of more kinds than one, as the reader has them.
    [[nodiscard]] bool hidesLine() const { return m_hidesLine; }

private:
    bool findLineEnd();
    bool findStart();
    [[nodiscard]] std::optional<std::uint64_t> lineStartAfter(std::uint64_t wanted) const;
    bool cut(std::vector<Range>& ranges) const;
    void read(Range& range, bool isTelling);
    void takeLines(Range& range, std::string& text, std::uint64_t& textStart, bool isLast) const;
    void take(Range& range, SourcePart& part, std::string_view line, std::uint64_t start) const;

    int m_descriptor;
    ObjFaces m_faces;
    const std::function<bool(double)>& m_goOn;
    ObjIndex m_index;
    std::uint64_t m_start = 0;            // behind the byte order mark
    std::vector<std::uint64_t> m_hashes;  // of the file's pieces
    std::atomic<bool> m_isGivenUp = false;
    bool m_hidesLine = false;
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
    if (hasReturn && m_index.lineEnd != kAnyLineEnd) {
        m_index.lineEnd = '\r';
        m_index.newLine = "\r";
    }
    return true;
}

bool Indexer::findStart() {
    std::string head(std::min<std::uint64_t>(m_index.size, kByteOrderMark.size()), '\0');
    char last = '\n';
    if (!readAt(m_descriptor, 0, head.data(), head.size()) ||
        (m_index.size > 0 && !readAt(m_descriptor, m_index.size - 1, &last, 1))) {
        return false;
    }
    m_start = head == kByteOrderMark ? head.size() : 0;
    m_index.endsInLine = !isLineEnd(last, m_index.lineEnd);
    if (m_index.lineEnd == kAnyLineEnd && last == '\r') {
        m_index.newLine = "\r\n";  // a line feed alone would belong to that
    }
    return true;
}

/// The first byte behind a line that does not go on, from `wanted` on; the file's end if there is none.
std::optional<std::uint64_t> Indexer::lineStartAfter(std::uint64_t wanted) const {
    constexpr std::uint64_t kBefore = 1 << 12;  // of blanks at most before a line's end
    std::string window;
    for (std::uint64_t at = wanted; at < m_index.size; at += kPiece) {
        const std::uint64_t from = at > m_start + kBefore ? at - kBefore : m_start;
        window.resize(std::min<std::uint64_t>(m_index.size - from, at - from + kPiece));
        if (!readAt(m_descriptor, from, window.data(), window.size())) {
            return std::nullopt;
        }
        const std::string_view ends =
            m_index.lineEnd == kAnyLineEnd ? "\r\n" : std::string_view(&m_index.lineEnd, 1);
        for (std::size_t end = window.find_first_of(ends, at - from); end != window.npos;
             end = window.find_first_of(ends, end + 1)) {
            const std::size_t last = window.find_last_not_of(" \t\f\v\r\n", end);
            if (last == window.npos || window[last] != '\\') {
                return from + end + 1;
            }
        }
    }
    return m_index.size;
}

/// Each has the lines that start in its pieces.
bool Indexer::cut(std::vector<Range>& ranges) const {
    ranges.front().start = m_start;
    ranges.back().endPiece = m_hashes.size();
    for (std::size_t r = 1; r < ranges.size(); ++r) {
        const std::size_t piece = m_hashes.size() * r / ranges.size();
        const std::optional<std::uint64_t> start = lineStartAfter(piece * kPiece);
        if (!start) {
            return false;
        }
        ranges[r].start = std::max(*start, ranges[r - 1].start);
        ranges[r].firstPiece = piece;
        ranges[r - 1].endPiece = piece;
    }
    for (std::size_t r = 0; r < ranges.size(); ++r) {
        ranges[r].end = r + 1 < ranges.size() ? ranges[r + 1].start : m_index.size;
    }
    return true;
}

void Indexer::take(Range& range, SourcePart& part, std::string_view line, std::uint64_t start) const {
    switch (keywordOf(line, m_index.lineEnd)) {
        case ObjKeyword::Vertex:
            ++part.vertices;
            break;
        case ObjKeyword::Normal:
            ++part.normals;
            range.afterNormals = start + line.size();
            break;
        case ObjKeyword::Face:
            if (m_faces == ObjFaces::AllLines || isObjFace(line, m_index.lineEnd)) {
                range.firstFace = std::min(range.firstFace, start);
                ++part.faces;
            }
            break;
        case ObjKeyword::Library:
            ++part.libraries;
            break;
        case ObjKeyword::Other:
            break;
    }
}

/// All lines but the last, which may go on in the next piece.
void Indexer::takeLines(Range& range, std::string& text, std::uint64_t& textStart, bool isLast) const {
    SourcePart part{textStart};
    ObjLines lines(text, m_index.lineEnd);
    TextRange line;
    std::size_t begin = 0;
    std::size_t done = 0;
    const auto endPart = [&] {
        part.size = done - begin;
        range.hasRelativeNormals = range.hasRelativeNormals ||
                                   hasRelativeNumber(std::string_view(text).substr(begin, part.size), part);
        range.parts.push_back(part);
        part = {textStart + done};
        begin = done;
    };
    const bool mayHide = m_index.lineEnd == '\n' && hasLoneReturn(text);
    while (lines.next(line) && (isLast || line.end < text.size())) {
        const std::string_view whole = std::string_view(text).substr(line.start, line.end - line.start);
        take(range, part, whole, textStart + line.start);
        range.hidesLine = range.hidesLine || (mayHide && hidesObjLine(whole));
        done = line.end;
        range.endsContinued = lines.wantsMore();
        if (done - begin >= kPart) {
            endPart();
        }
    }
    if (done > begin) {
        endPart();
    }
    textStart += done;
    text.erase(0, done);
}

void Indexer::read(Range& range, bool isTelling) {
    range.firstFace = range.end;
    std::string text;  // from a line's start on
    std::string piece;
    std::uint64_t textStart = range.start;
    for (std::size_t i = range.firstPiece; i <= range.endPiece && !m_isGivenUp; ++i) {
        // The last line goes on in the next range's pieces.
        const std::uint64_t at = i * kPiece;
        const std::uint64_t end =
            i < range.endPiece ? std::min(m_index.size, at + kPiece) : std::max(range.end, at);
        piece.resize(at < end ? end - at : 0);
        if (!readAt(m_descriptor, at, piece.data(), piece.size())) {
            range.isRead = false;
            return;
        }
        if (i < range.endPiece) {
            m_hashes[i] = ContentHasher::ofPiece(piece);
        }
        const std::uint64_t from = std::clamp(range.start, at, at + piece.size());
        const std::uint64_t to = std::clamp(range.end, from, at + piece.size());
        text.append(piece, from - at, to - from);
        takeLines(range, text, textStart, i == range.endPiece);
        const double done = static_cast<double>(i - range.firstPiece + 1);
        if (isTelling && m_goOn &&
            !m_goOn(done / static_cast<double>(range.endPiece - range.firstPiece + 1))) {
            m_isGivenUp = true;
        }
    }
}

std::optional<ObjIndex> Indexer::index() {
    struct stat info {};
    if (::fstat(m_descriptor, &info) != 0 || !S_ISREG(info.st_mode)) {
        return std::nullopt;
    }
    m_index.size = static_cast<std::uint64_t>(info.st_size);
    std::vector<Range> ranges(std::clamp<std::size_t>(m_index.size / kLeastRange, 1, usefulThreads()));
    m_hashes.resize((m_index.size + kPiece - 1) / kPiece);
    if (!findLineEnd() || !findStart() || !cut(ranges)) {
        return std::nullopt;
    }
    forEachAtOnce(ranges.size(), [&](std::size_t r) { read(ranges[r], r == 0); });  // 0: on this thread
    m_index.firstFace = m_index.size;
    for (const Range& range : ranges) {
        if (!range.isRead || m_isGivenUp) {
            return std::nullopt;
        }
        m_index.parts.insert(m_index.parts.end(), range.parts.begin(), range.parts.end());
        m_index.hasRelativeNormals = m_index.hasRelativeNormals || range.hasRelativeNormals;
        m_hidesLine = m_hidesLine || range.hidesLine;
        m_index.afterNormals = std::max(m_index.afterNormals, range.afterNormals);
        m_index.endsContinued = range.parts.empty() ? m_index.endsContinued : range.endsContinued;
        if (range.firstFace < range.end) {
            m_index.firstFace = std::min(m_index.firstFace, range.firstFace);
        }
    }
    m_index.hash = ContentHasher::ofPieces(m_hashes);
    return std::move(m_index);
}

}  // namespace

std::optional<ObjIndex> indexObj(int descriptor, ObjFaces faces, const std::function<bool(double)>& goOn) {
    Indexer usual(descriptor, faces, '\n', goOn);
    std::optional<ObjIndex> index = usual.index();
    return index && usual.hidesLine() ? Indexer(descriptor, faces, kAnyLineEnd, goOn).index()
                                      : std::move(index);
}

bool isObjFace(std::string_view line, char lineEnd) {
    ObjWords words(line, lineEnd);
    words.next();
    for (int corner = 0; corner < 3; ++corner) {
        const std::string_view word = words.text(words.next());
        if (word.empty() || word.front() == '#') {
            return false;
        }
    }
    return true;
}

}  // namespace hitscope
