// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "core/result.h"
#include "deform/pipeline_kind.h"
#include "view/display_options.h"

namespace hitscope::cli {

struct DemoOptions {
    QString folder;    ///< where pictures and mesh go; made if missing
    QString meshPath;  ///< empty: the paper's scene
    int shots = 50;
    unsigned seed = 1;
    std::optional<PipelineKind> pipeline;   ///< what is shown and exported; nothing: the usual one
    NormalMode normals = NormalMode::True;  ///< of pictures and mesh
    int width = 1280;                       ///< pixels
    int height = 720;                       ///< pixels
};

/// Shoots at the scene with no display, compares all pipelines that run here with the reference, writes
/// pictures and the deformed mesh, prints a table.
[[nodiscard]] Status runDemo(const DemoOptions& options);

/// Prints what is in a mesh file.
[[nodiscard]] Status runInfo(const QString& meshPath);

/// Prints what draws without a window, how many hits its uniform arrays hold, and whether it deforms as the
/// reference does in every bit.
[[nodiscard]] Status runRendererInfo();

/// hitscope-cli replay: the hits of a session file, applied again. The exit status.
int replayCommand(const QStringList& arguments);
/// hitscope-cli collect: a session and all that it refers to, in one folder. The exit status.
int collectCommand(const QStringList& arguments);
/// hitscope-cli picture: one picture of a scene as a PNG file. The exit status.
int pictureCommand(const QStringList& arguments);
/// hitscope-cli sequence: a turntable, or the hits one by one, as PNG files. The exit status.
int sequenceCommand(const QStringList& arguments);

}  // namespace hitscope::cli
