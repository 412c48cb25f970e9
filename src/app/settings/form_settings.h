// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deform/dent_form.h"

class QSettings;

namespace hitscope {

/// The form of the dents to come, as it was when the program ended; what is not one is as usual.
[[nodiscard]] DentForm loadForm(const QSettings& settings);
void saveForm(QSettings& settings, const DentForm& form);

}  // namespace hitscope
