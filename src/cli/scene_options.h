// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/opened_scene.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// --until
[[nodiscard]] UsageOption untilOption();
/// That scene, as --pipeline and --until have it; complains where --until goes with no session.
[[nodiscard]] SceneWish givenScene(Invocation& given, const QString& path);

}  // namespace hitscope::cli
