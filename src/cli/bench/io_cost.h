// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bench/bench_room.h"

namespace hitscope::bench {

/// What files cost to come in and to go out, each the whole of it. Those that are compared were taken in
/// turn.
struct IoFigures {
    qint64 objBytes = 0;
    Samples tiny;     ///< tinyobjloader alone parses the OBJ file
    Samples assimp;   ///< Assimp does
    Samples coarse;   ///< Hitscope, from the file to the coarse picture that the window shows meanwhile
    Samples picture;  ///< Hitscope, from the file to the full picture
    Samples copy;     ///< cp and sync of the OBJ file, in turn with:
    Samples exportFew;
    Samples copyAgain;  ///< likewise
    Samples exportAll;
    Samples ply;             ///< a binary PLY to the full picture; empty: left out
    double peakBytes = 0.0;  ///< of a program that draws the OBJ file and its import worker, together
};

struct IoSizes {
    int quads = 0;         ///< of the OBJ file
    int plyTriangles = 0;  ///< 0: none
    int width = 0;         ///< of the picture, pixels
    int height = 0;        ///< of the picture, pixels
};

/// Files are made in `folder`.
[[nodiscard]] Result<IoFigures> measureIo(const BenchRoom& room, const IoSizes& sizes, const QString& folder,
                                          const Plan& plan);

}  // namespace hitscope::bench
