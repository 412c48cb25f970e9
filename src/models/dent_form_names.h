// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "deform/dent_form.h"

namespace hitscope {

/// As people read them.
[[nodiscard]] QString nameOf(DentProfile profile);
[[nodiscard]] QString nameOf(DentDirection direction);

/// "Crater, into the surface"; "Press, radius 0.1 m".
[[nodiscard]] QString nameOf(const DentForm& form);

}  // namespace hitscope
