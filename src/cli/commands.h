// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/result.h"

namespace hitscope::cli {

struct DemoOptions {
    QString folder;    ///< where pictures and mesh go; made if missing
    QString meshPath;  ///< empty: the paper's scene
    int shots = 50;
    unsigned seed = 1;
    int width = 1280;  ///< pixels
    int height = 720;  ///< pixels
};

/// Shoots at the scene with no display, compares the pipelines, writes pictures and the deformed mesh, prints
/// a table.
[[nodiscard]] Status runDemo(const DemoOptions& options);

/// Prints what is in a mesh file.
[[nodiscard]] Status runInfo(const QString& meshPath);

/// Prints what draws without a window, how many hits its uniform arrays hold, and whether it deforms as the
/// reference does in every bit.
[[nodiscard]] Status runRendererInfo();

}  // namespace hitscope::cli
