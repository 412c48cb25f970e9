// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "cli/opened_scene.h"
#include "usage/invocation.h"
#include "view/display_options.h"

namespace hitscope::cli {

/// What picture and sequence have in common: the scene, and how it is seen.
struct PictureArguments {
    SceneWish scene;
    bool isZUp = false;  ///< z points up in the file
    int shots = 0;
    unsigned seed = 1;
    int width = 1280;    ///< pixels
    int height = 720;    ///< pixels
    int samples = 1;     ///< as in PictureRequest
    bool labels = true;  ///< the colour bar, where change is shown
    QString camera;      ///< as parseCamera() takes it; empty: that of the session, or all in the picture
};

/// --samples, which shoot has as well.
[[nodiscard]] UsageOption samplesOption();
/// The options of the command line for them, and what was given; `scene`: its file.
[[nodiscard]] QList<UsageOption> pictureOptions();
[[nodiscard]] PictureArguments readPictureArguments(Invocation& given, const QString& scene);
/// How it is seen: as `options`, a session's own, but for what was given.
[[nodiscard]] DisplayOptions readDisplay(Invocation& given, DisplayOptions options);

}  // namespace hitscope::cli
