// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "cli/form_options.h"
#include "cli/repeat_options.h"
#include "core/result.h"
#include "deform/pipeline_kind.h"
#include "io/hit_records.h"
#include "session/flight_mode.h"
#include "session/mesh_steps/mesh_step.h"
#include "session/session.h"
#include "session/shots/shot_script.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// What shoot is asked for.
struct ShootOptions {
    enum class Shots : std::uint8_t { None, Burst, Random, At, Script };

    QString scenePath;                ///< as SceneWish has it
    bool isZUp = false;               ///< z points up in the file
    bool separates = false;           ///< objects become targets
    std::vector<MeshStep> meshSteps;  ///< done to all targets, in order
    QString hitsPath;                 ///< hits that come before the shots; empty: none
    Shots shots = Shots::Burst;
    QString scriptPath;
    int count = 20;      ///< of a burst, of random shots
    glm::vec3 at{0.0f};  ///< metres, world: where one shot is aimed at
    glm::vec3 direction{0.0f, 0.0f, -1.0f};
    double cone = 5.0;  ///< degrees from a burst's middle to its edge
    unsigned seed = 1;
    double interval = 0.0;  ///< seconds between shots
    /// How shots fly; a script says so itself. Nothing: as in the paper at the paper's scene, instant at one
    /// place, quick at a mesh, which may be of any size.
    std::optional<FlightMode> flight;
    std::optional<PipelineKind> pipeline;
    std::vector<std::optional<double>> constants;   ///< by deformationParameters(); nothing: as they are
    GivenForm form;                                 ///< of the dents; what is not given is as it is
    RepeatWish repeat;                              ///< hits that come after the shots
    bool absolute = false;                          ///< they hold on targets of any size
    std::vector<std::optional<double>> projectile;  ///< by projectileParameters(); likewise
    QString savePath;                               ///< where the script goes; empty: nowhere
    QString meshOutPath;  ///< where the deformed mesh goes, that of most changed vertices; empty: nowhere
    QString hitsOutPath;  ///< where all hits go; empty: nowhere
    QString sessionPath;  ///< where the session goes; empty: nowhere
    QString picturePath;  ///< where a picture goes; empty: nowhere
    int samples = 1;      ///< of the picture, as in PictureRequest
};

/// appendRecords() of a file's hits, or of the standard input's, with a note where they go to a target of
/// another name.
[[nodiscard]] Status takeHits(Session& session, const QString& path);

/// What shoot takes on the command line, and what was given.
[[nodiscard]] QList<UsageOption> shootOptions();
[[nodiscard]] ShootOptions readShootOptions(Invocation& given);

/// Of random shots: each is aimed at the surface as the ones before have left it, and `play` lets it land.
/// Gives them all, at the times when they left: fewer than asked for where no place is left that a shot could
/// strike.
[[nodiscard]] ShotScript shootAtSurface(Session& session, const ShootOptions& options,
                                        const std::function<void(const ShotScript& shot)>& play);
/// All others, in the scene as it is.
[[nodiscard]] Result<ShotScript> shotsOf(const Session& session, const ShootOptions& options);

}  // namespace hitscope::cli
