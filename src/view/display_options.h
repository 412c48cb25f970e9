// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "view/change_options.h"
#include "view/cutting_plane.h"

namespace hitscope {

enum class WireframeMode : std::uint8_t { Off, Over, Only };
enum class NormalMode : std::uint8_t { True, Paper };  ///< which normals shade
enum class Theme : std::uint8_t { Light, Dark };
/// What surfaces are made of: what their files say, or one material for all of them.
enum class SurfaceLook : std::uint8_t { File, Matcap, Clay, Metal };
inline constexpr int kSurfaceLooks = 4;

/// How the picture is made; the same for window, pictures and measurements.
struct DisplayOptions {
    WireframeMode wireframe = WireframeMode::Off;
    NormalMode normals = NormalMode::True;
    Theme theme = Theme::Dark;
    bool floor = true;
    bool textures = true;
    bool vertexColours = true;  ///< of meshes that have some
    bool crosshair = false;
    ChangeMapOptions change = {};
    BeforeAfterOptions beforeAfter = {};
    CuttingPlane cut = {};
    bool sideBySide = false;  ///< two pictures, where there is a second pipeline to show
    bool flat = false;        ///< one normal a triangle
    bool needles = false;     ///< normals
    bool dots = false;        ///< vertices, seen from close by
    bool backFaces = false;   ///< tinted
    bool shadows = false;     ///< of the directional light
    /// No background: what is not covered stays transparent, and colours are premultiplied by their opacity.
    bool transparent = false;
    SurfaceLook look = SurfaceLook::File;
    bool environment = false;  ///< a studio lights the scene (view/environment.h), not the session's lights
    /// At rest the picture becomes the mean of many (render/refined/refined_picture.h).
    bool refine = false;
    /// While it moves the picture is drawn smaller and enlarged where its frames would take too long.
    bool reduceInMotion = false;

    bool operator==(const DisplayOptions&) const = default;
};

}  // namespace hitscope
