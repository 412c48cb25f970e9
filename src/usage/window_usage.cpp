// SPDX-License-Identifier: GPL-3.0-or-later
#include "usage/usage.h"

namespace hitscope {

const ProgramUsage& windowUsage() {
    static const ProgramUsage usage{
        .all = {.name = QStringLiteral("hitscope"),
                .files = QStringLiteral("[FILE...]"),
                .about = QStringLiteral("shoot a mesh, see exactly what moved, save the result"),
                .description =
                    QStringLiteral("Opens the files in a window: a session (.hitscope), or OBJ, PLY, STL, "
                                   "glTF, GLB, OFF, FBX, 3DS or DAE meshes. Without a file, it shows a "
                                   "teapot. hitscope-cli works without a display."),
                .options = {flagOption("version", QStringLiteral("Print the version."))},
                .examples = {{QStringLiteral("Open a mesh."), QStringLiteral("hitscope bunny.obj")}},
                .mostFiles = -1},
        .verbs = {},
        .statuses = {{0, QStringLiteral("The window was closed.")},
                     {1,
                      QStringLiteral("The command line is wrong, there is no display, or it has no OpenGL.")},
                     {128, QStringLiteral("plus n: terminated cleanly by signal n.")}},
        .environment = {},
        .seeAlso = {QStringLiteral("hitscope-cli(1)")}};
    return usage;
}

}  // namespace hitscope
