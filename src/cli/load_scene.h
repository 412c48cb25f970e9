// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"
#include "session/session.h"

class QTextStream;

namespace hitscope::cli {

/// The mesh of that file, or, without a path, the paper's scene. Notes of the import go to `out`.
[[nodiscard]] Status loadScene(Session& session, const QString& meshPath, QTextStream& out);

}  // namespace hitscope::cli
