// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "deform/hit_group.h"

namespace hitscope {

/// As people read it: "Scatter 3"; empty for none.
[[nodiscard]] QString groupName(const HitGroup& group);

}  // namespace hitscope
