// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hitscope {

/// A line of an MTL file that names a picture; views of the line.
struct MtlMap {
    std::string_view keyword;  ///< "map_Kd"
    std::string_view name;     ///< of the picture, with the blanks inside it; empty: the line has none
    std::string_view bumps;    ///< the number of its option -bm; empty: it has none
};

/// Nothing if the line begins with no word that names a picture. It may have its line end.
[[nodiscard]] std::optional<MtlMap> mtlMapOf(std::string_view line);

/// What ends the lines of an MTL file: \n, also where \r is before it; \r where there is no \n.
[[nodiscard]] char mtlLineEnd(std::string_view file);
/// A file's text without byte order mark, zeros and \r; all its lines end with \n.
[[nodiscard]] std::string mtlText(std::string_view file);
/// Whether the file defines a material.
[[nodiscard]] bool definesMaterials(std::string_view file);

}  // namespace hitscope
