// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hitscope {

/// Some whole lines of an OBJ file, and how many of them say what an export may change.
struct SourcePart {
    std::uint64_t start = 0;      ///< byte in the file
    std::uint64_t size = 0;       ///< bytes
    std::uint32_t vertices = 0;   ///< v lines
    std::uint32_t normals = 0;    ///< vn lines
    std::uint32_t faces = 0;      ///< f lines
    std::uint32_t libraries = 0;  ///< mtllib lines
};

/// What must be known of an OBJ file to find its vertices, normals and faces again.
struct ObjIndex {
    std::vector<SourcePart>
        parts;  ///< all of the file but its byte order mark, in order; 256 KB each, so that caches hold them
    std::uint64_t hash = 0;           ///< contentHash()
    char lineEnd = '\n';              ///< or '\r', for files of old Macs, or kAnyLineEnd
    std::string newLine = "\n";       ///< for lines that are added: also "\r\n" or "\r"
    std::uint64_t afterNormals = 0;   ///< byte behind the last vn line; 0: there is none
    std::uint64_t firstFace = 0;      ///< byte at which the first face starts; the file's size: none
    bool hasRelativeNormals = false;  ///< a face may count its normals from the end
    bool endsInLine = false;          ///< the last line has no end
    bool endsContinued = false;       ///< the last line would go on with what comes behind it
    std::uint64_t size = 0;           ///< bytes
};

/// Which f lines are faces of the mesh: its reader leaves those of fewer than three corners out.
enum class ObjFaces : std::uint8_t { AllLines, OfThreeCorners };

/// Reads the whole file, on all processors. Nothing where it cannot be read or `goOn` (given the share that
/// is done, may be empty, called on this thread) says false.
[[nodiscard]] std::optional<ObjIndex> indexObj(int descriptor, ObjFaces faces,
                                               const std::function<bool(double)>& goOn);

/// Whether an f line has three corners or more.
[[nodiscard]] bool isObjFace(std::string_view line, char lineEnd);

}  // namespace hitscope
