// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "io/writers/morph_steps.h"
#include "view/display_options.h"

namespace hitscope {

struct Hit;
struct Target;

enum class ExportFormat : std::uint8_t { Obj, Ply, PlyAscii, Stl, Glb, Gltf, Csv };

/// What must be known of a format anywhere.
struct ExportFormatTraits {
    ExportFormat format;
    const char* key;     ///< for settings and the command line
    const char* suffix;  ///< of its files, lower case
    const char* name;    ///< for people
    bool hasNormals;     ///< those of corners or vertices, so that one may choose among them
    bool hasSteps;       ///< holds the shapes on the way from the original to the deformed one
};

[[nodiscard]] const std::array<ExportFormatTraits, 7>& exportFormats();
[[nodiscard]] const ExportFormatTraits& traitsOf(ExportFormat format);
/// The first with that suffix, in letters of any case; nothing: there is none.
[[nodiscard]] std::optional<ExportFormat> exportFormatOf(const QString& path);

/// How deformed meshes are written.
struct ExportOptions {
    ExportFormat format = ExportFormat::Obj;
    NormalMode normals = NormalMode::True;
    /// OBJ: a normal for each corner, even where the mesh's file has none; otherwise the file's own normals
    /// are kept where they hold.
    bool allNormals = false;
    bool inWorld = false;   ///< coordinates as in the scene, metres; otherwise those of the mesh's file
    std::size_t steps = 0;  ///< glTF: shapes on the way, at most so many; 0: none
    MorphUnit stepOf = MorphUnit::Hit;  ///< what a step holds at least
    bool readBack = false;              ///< read the file afterwards and hold it against what was meant
    bool isAlone = false;               ///< nobody gets the files beside it, of which no note tells
};

/// What an export will amount to. `hits`: that made what is shown; the size of the steps between follows from
/// some of them.
struct ExportEstimate {
    std::size_t vertices = 0;  ///< CSV: that moved
    std::size_t faces = 0;     ///< CSV has none
    std::uint64_t bytes = 0;   ///< about
};
[[nodiscard]] ExportEstimate estimateExport(std::span<const Target* const> targets,
                                            const ExportOptions& options, std::span<const Hit> hits);

}  // namespace hitscope
