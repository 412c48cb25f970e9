// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"
#include "document/session_document.h"

namespace hitscope {

/// Of session files' names, with the point.
inline constexpr const char* kSessionSuffix = ".hitscope";

/// readDocument() of a file, which is a regular one; the error names it. On any thread.
[[nodiscard]] Result<SessionDocument> readSessionFile(const QString& path);

/// writeDocument() into a file, whole or not at all, with its meshes' paths from there. On any thread.
[[nodiscard]] Status writeSessionFile(SessionDocument document, const QString& path);

}  // namespace hitscope
