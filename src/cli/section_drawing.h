// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/scene_section.h"

namespace hitscope::cli {

/// A section as one sees it from the open side: the original dashed, the deformed over it, and a bar that
/// says how long a metre, or a round part or number of them, is. SVG without scripts, 160 mm wide.
[[nodiscard]] std::string sectionSvg(const SceneSection& section);

}  // namespace hitscope::cli
