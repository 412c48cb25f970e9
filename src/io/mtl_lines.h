// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
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

}  // namespace hitscope
