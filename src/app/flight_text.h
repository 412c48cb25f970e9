// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "session/session.h"

namespace hitscope {

/// What the session's flight mode comes to at the target in focus, in numbers.
[[nodiscard]] QString flightText(const Session& session);

}  // namespace hitscope
