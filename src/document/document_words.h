// SPDX-License-Identifier: GPL-3.0-or-later
// Words and plain checks of document_fields.h.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/session_document.h"
#include "session/primitive_target.h"

namespace hitscope {

namespace document_words {

/// By the index of TargetSource's alternatives.
enum class SourceKind : std::uint8_t { Unknown, Primitive, BuiltIn, File };
inline constexpr std::array<std::string_view, 4> kSourceKinds{"unknown", "primitive", "built-in", "file"};
inline constexpr std::array<std::string_view, 7> kPrimitives{
    "cube", "uv-sphere", "geodesic-sphere", "torus", "cylinder", "sheet", "turntable"};
inline constexpr std::array<std::string_view, 7> kBuiltInMeshes{
    "teapot",           "low-poly-cube",   "high-poly-cube", "low-poly-sphere",
    "high-poly-sphere", "turntable-stand", "fine-torus"};

inline const std::vector<std::string_view>& pipelines() {
    static const auto words = [] {
        std::vector<std::string_view> keys(allPipelines().size());
        for (const PipelineTraits& traits : allPipelines()) {
            keys[static_cast<std::size_t>(traits.kind)] = traits.key;
        }
        return keys;
    }();
    return words;
}

inline const std::array<std::string_view, 4>& flightModes() {
    static const auto words = [] {
        std::array<std::string_view, 4> keys;
        for (const FlightModeTraits& traits : allFlightModes()) {
            keys[static_cast<std::size_t>(traits.mode)] = traits.key;
        }
        return keys;
    }();
    return words;
}

/// `digits` hexadecimal ones, in lower case.
inline bool isHex(std::string_view text, std::size_t digits) {
    return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

inline bool isPlainZero(const glm::vec3& v) {
    return v == glm::vec3(0.0f) && !std::signbit(v.x) && !std::signbit(v.y) && !std::signbit(v.z);
}

}  // namespace document_words

}  // namespace hitscope
