// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace hitscope {

/// Appends a vertex's line to MeshData::positionTexts: its coordinates as `written` in the file, or an empty
/// line where these are the shortest texts of `position`.
void appendPositionLine(std::string& texts, const std::array<std::string_view, 3>& written,
                        const glm::dvec3& position);

/// Goes through MeshData::positionTexts vertex by vertex.
class PositionLines {
public:
    /// `texts` outlives this.
    explicit PositionLines(std::string_view texts) : m_rest(texts) {}

    /// The next vertex's line, without its end; nothing where there is none.
    std::string_view next();

private:
    std::string_view m_rest;
};

}  // namespace hitscope
