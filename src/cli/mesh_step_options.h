// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/result.h"
#include "session/session.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// --separate, --refine: what is done to meshes before they are shot at.
[[nodiscard]] QList<UsageOption> meshStepOptions();
/// Metres; nothing: it is not there.
[[nodiscard]] std::optional<float> givenRefinement(Invocation& given);
/// The objects of each target that has several become targets.
[[nodiscard]] Status separateAll(Session& session);
/// All targets of the session, by the middles of edges; quads stay quads.
[[nodiscard]] Status refineAll(Session& session, float edgeLength);

}  // namespace hitscope::cli
