// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/result.h"
#include "io/imported_mesh.h"

namespace hitscope {

/// Parses a text OFF file (also COFF, NOFF, STOFF and their mixtures); pure. Own code because Assimp leaves a
/// face's index to chance where the file's is out of range. Colours of faces are not read.
[[nodiscard]] Result<ImportedMesh> parseOff(std::string_view text, const ProgressSink& progress = {});

}  // namespace hitscope
