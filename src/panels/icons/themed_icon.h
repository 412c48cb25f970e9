// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace hitscope {

/// The icon resources/icons/NAME.svg, drawn in the palette's text colour of the moment, so that it is
/// readable on light and dark windows alike; dimmed when disabled.
[[nodiscard]] QIcon themedIcon(const QString& name);

}  // namespace hitscope
