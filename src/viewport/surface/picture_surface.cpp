// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/picture_surface.h"

#include <utility>

#include "viewport/surface/composed_surface.h"
#include "viewport/surface/raster_surface.h"
#include "viewport/surface/surface_format.h"

namespace hitscope {

PictureSurface& makePictureSurface(QWidget& viewport, PictureSurface::Hooks hooks) {
    if (isDrawnByCpu() && !qEnvironmentVariableIsSet(kComposes)) {
        return *new RasterSurface(viewport, std::move(hooks));
    }
    return *new ComposedSurface(viewport, std::move(hooks));
}

}  // namespace hitscope
