// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "core/result.h"
#include "deform/dent_form.h"
#include "deform/pipeline_kind.h"
#include "session/flight_mode.h"

namespace hitscope::cli {

struct ShootOptions {
    QString meshPath;    ///< empty: the paper's scene
    QString hitsPath;    ///< hits that come before the shots; empty: none
    bool shoots = true;  ///< false: only those hits
    QString scriptPath;  ///< empty: a burst
    int burst = 20;
    double cone = 5.0;  ///< degrees from its middle to its edge
    unsigned seed = 1;
    double interval = 0.0;  ///< seconds between the burst's shots
    /// How the burst flies; a script says so itself. Nothing: as in the paper at the paper's scene, quick at
    /// a mesh, which may be of any size.
    std::optional<FlightMode> flight;
    std::optional<PipelineKind> pipeline;
    DentForm form;        ///< of the dents; a script may have one of its own
    QString savePath;     ///< where the script goes; empty: nowhere
    QString meshOutPath;  ///< where the deformed mesh goes, that of most changed vertices; empty: nowhere
    QString hitsOutPath;  ///< where all hits go; empty: nowhere
};

/// Shoots a script, or a burst at the middle of the scene from where all of it is seen, with no display;
/// prints what was hit, a number that is the same for the same hits, and one for the same positions, in every
/// bit. An error, after all is written, if the mesh is not what the reference makes of the hits.
[[nodiscard]] Status runShoot(const ShootOptions& options);

/// hitscope-cli shoot; returns the exit status.
int shootCommand(const QStringList& arguments);

}  // namespace hitscope::cli
