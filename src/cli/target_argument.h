// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "core/result.h"
#include "session/session.h"

namespace hitscope::cli {

/// The target of that name; the error names those there are.
[[nodiscard]] Result<const Target*> targetNamed(const Session& session, const QString& name);
/// That one, or all where the name is empty.
[[nodiscard]] Result<std::vector<const Target*>> targetsNamed(const Session& session, const QString& name);

}  // namespace hitscope::cli
