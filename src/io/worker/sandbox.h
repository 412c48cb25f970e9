// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace hitscope {

/// What took hold of lockThisProcess(): kernels lack one or the other, or it is switched off in them.
struct Lock {
    bool files = false;  ///< Landlock: only the mesh's file and folder can be read
    bool calls = false;  ///< seccomp: no network, no programs, no processes, nothing opened to be written
};

/// Loads what is otherwise loaded when it is first used: plugins for pictures. Before lockThisProcess().
void loadWhatComesLate();

/// From now on this process opens `file`, and what is in its folder and below, and both to read only. It
/// reaches no network, starts no program and no process, and writes to nothing but the descriptors it has.
/// There is no way back. The rest goes on where the kernel lacks a part; builds with a sanitizer, which does
/// all that is forbidden here, are not locked at all.
Lock lockThisProcess(const QString& file);

}  // namespace hitscope
