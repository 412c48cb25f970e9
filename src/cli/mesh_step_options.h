// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/result.h"
#include "mesh/refine/refine.h"
#include "session/session.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// --up, and whether it says that z points up in the file.
[[nodiscard]] UsageOption upOption();
[[nodiscard]] bool givenZUp(Invocation& given);
/// All targets of the session together.
[[nodiscard]] Status turnAllUpright(Session& session);
/// --separate, --refine, --refine-by: what is done to meshes before they are shot at.
[[nodiscard]] QList<UsageOption> meshStepOptions();
/// Nothing: it is not asked for.
[[nodiscard]] std::optional<RefineOptions> givenRefinement(Invocation& given);
/// The objects of each target that has several become targets.
[[nodiscard]] Status separateAll(Session& session);
/// All targets of the session, whole.
[[nodiscard]] Status refineAll(Session& session, const RefineOptions& options);

}  // namespace hitscope::cli
