// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace hitscope {

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

[[nodiscard]] constexpr std::size_t sizeOf(PlyType type) {
    constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}
[[nodiscard]] constexpr bool isWhole(PlyType type) {
    return type != PlyType::Float32 && type != PlyType::Float64;
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    bool isList = false;
    PlyType countType = PlyType::Uint8;  ///< of a list's length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

/// Bytes. A header that has not ended by then is none.
inline constexpr std::int64_t kLongestPlyHeader = 1 << 20;

enum class PlyEncoding : std::uint8_t { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string> textures;  ///< from MeshLab's "comment TextureFile"
    std::size_t size = 0;               ///< bytes of the file before the first element
};

/// Where the records of an element "edge" have vertex1 and vertex2.
struct PlyEdgeEnds {
    std::size_t first;
    std::size_t second;
};

/// Nothing for other elements, and for edges that do not say both.
[[nodiscard]] std::optional<PlyEdgeEnds> plyEdgeEnds(const PlyElement& element);

/// Parses the header at the start of a PLY file; pure. Promises of more elements than the file has room for
/// are an error, so that counts can be trusted when allocating.
[[nodiscard]] Result<PlyHeader> parsePlyHeader(std::string_view file);
/// The same of a file's start, `fileSize` bytes long in all.
[[nodiscard]] Result<PlyHeader> parsePlyHeader(std::string_view start, std::uint64_t fileSize);

}  // namespace hitscope
