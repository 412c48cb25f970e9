// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage/usage.h"

namespace hitscope {

const ProgramUsage& windowUsage() {
    static const ProgramUsage usage{
        .all = {.name = QStringLiteral("hitscope"),
                .files = QStringLiteral("[FILE...]"),
                .about = QStringLiteral("shoot a mesh, see exactly what moved, save the result"),
                .description = QStringLiteral(
                    "Opens a window with the files: a session (.hitscope), or meshes as OBJ, PLY, STL, glTF, "
                    "GLB, "
                    "OFF, FBX, 3DS or DAE. Without a file, a teapot. hitscope-cli works without a display."),
                .options = {flagOption("version", QStringLiteral("Print the version."))},
                .examples = {{QStringLiteral("Open a mesh."), QStringLiteral("hitscope bunny.obj")}},
                .mostFiles = -1},
        .verbs = {},
        .statuses = {{0, QStringLiteral("The window was closed.")},
                     {1, QStringLiteral("There is no display, or OpenGL is missing there.")},
                     {128, QStringLiteral("and a number n more: signal n ended it in order.")}},
        .environment = {},
        .seeAlso = {QStringLiteral("hitscope-cli(1)")}};
    return usage;
}

}  // namespace hitscope
