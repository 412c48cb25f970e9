// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

struct aiScene;

namespace hitscope {

/// Whether all arrays of a scene that Assimp made are as long as it says. They are not always: its readers
/// trust counts of broken files, and who believes them reads beyond what was allocated.
[[nodiscard]] Status checkScene(const aiScene& scene);

}  // namespace hitscope
