// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/result.h"
#include "session/target.h"
#include "view/display_options.h"

namespace hitscope {

/// A target as it is on the screen at one moment: what another thread needs to write it.
struct TargetExport {
    std::shared_ptr<const MeshData> original;
    std::shared_ptr<const RenderMesh> render;
    std::vector<glm::vec3> positions;  ///< one a file vertex, local frame, metres
    std::vector<glm::vec3> normals;    ///< one a render vertex, unit length
    QString sourcePath;                ///< empty: none
};

/// Copies of what hits change; the rest is shared. The target's read-back is current.
[[nodiscard]] TargetExport copyForExport(const Target& target, NormalMode normals);

/// Writes it to an OBJ file, in its file's own vertex order. Of any thread. goOn, notes and
/// errors are exportObj()'s.
[[nodiscard]] Result<QStringList> writeExport(const TargetExport& what, const QString& path,
                                              const std::function<bool(double)>& goOn = {});

/// Both at once: writes a target as it is on the screen, with true or the paper's normals.
[[nodiscard]] Result<QStringList> exportTarget(const Target& target, const QString& path, NormalMode normals);

}  // namespace hitscope
