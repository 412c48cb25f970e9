// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "io/imported_mesh.h"

namespace hitscope {

/// The materials of an MTL text, in its order; pure. What is not understood is left at its default. `others`,
/// unless null, takes the names of maps that are not drawn.
[[nodiscard]] std::vector<Material> parseMtl(const std::string& text, QStringList* others = nullptr);

/// Fills in the materials of an OBJ from the libraries it names, looked for in `folder` alone, and adds those
/// no face uses. Trouble is a note and never more: geometry does not need materials. Gives the names of their
/// maps that are not drawn.
QStringList readMaterialLibraries(ImportedMesh& imported, const QString& folder);

}  // namespace hitscope
