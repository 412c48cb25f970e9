// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/result.h"
#include "io/export_files.h"
#include "io/export_obj.h"

namespace hitscope {

enum class SourceCopy : std::uint8_t {
    Written,   ///< and staged
    NotThere,  ///< what.sourcePath cannot be read
    Changed,   ///< it has another content than the mesh was read from
};

/// Stages `path` as a copy of what.sourcePath in which only what changed is replaced: see exportObj(). Memory
/// is a few megabytes and what the changes take. Errors: it was given up, or `path` cannot be written.
[[nodiscard]] Result<SourceCopy> copyWithChanges(const ObjExport& what, const QString& path,
                                                 MaterialFiles& materials, StagedFiles& staged);

}  // namespace hitscope
