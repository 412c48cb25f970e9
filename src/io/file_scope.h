// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace hitscope {

/// The canonical path of `name` (relative to `folder`, or absolute) if it is a regular, readable file inside
/// `folder` once every link and ".." is followed; empty otherwise. Backslashes count as separators. A mesh
/// file names other files, and must not be able to name any file of the person's.
[[nodiscard]] QString resolveInside(const QString& folder, const QString& name);

}  // namespace hitscope
