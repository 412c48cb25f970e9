// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/result.h"
#include "session/mesh_steps/mesh_step.h"
#include "session/session.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// --up, and whether it says that z points up in the file.
[[nodiscard]] UsageOption upOption();
[[nodiscard]] bool givenZUp(Invocation& given);
/// All targets of the session together.
[[nodiscard]] Status turnAllUpright(Session& session);
/// --separate
[[nodiscard]] UsageOption separateOption();
/// --simplify, --refine, --refine-by, --smooth: what is done to meshes as they are read.
[[nodiscard]] QList<UsageOption> meshStepOptions();
/// In the order in which they are done; empty: none is asked for.
[[nodiscard]] std::vector<MeshStep> givenMeshSteps(Invocation& given);
/// The objects of each target that has several become targets.
[[nodiscard]] Status separateAll(Session& session);
/// One step after the other, on all targets of the session, whole.
[[nodiscard]] Status changeAll(Session& session, const std::vector<MeshStep>& steps);

}  // namespace hitscope::cli
