// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include "cli/bench/harness.h"

class QString;

namespace hitscope::bench {

inline constexpr double kFrame = 1.0 / 60.0;  ///< seconds

/// What keeping a session costs, each the whole of it.
struct SessionFigures {
    Samples save;        ///< capture on the window's thread, then the file, synced
    Samples capture;     ///< the part that the window waits for
    Samples open;        ///< file, meshes and session: until it can be drawn
    Samples recover;     ///< the same from a journal's bytes
    Samples back;        ///< to before the first hit, by Session::goToStep()
    Samples forward;     ///< and again
    Samples hit;         ///< one more in the history, without a journal
    Samples journalled;  ///< and with one, on the window's thread
    Samples flush;       ///< settings that changed, handed to the journal
    qint64 fileBytes = 0;
};

/// Of a session with a teapot and so many hits, one step to undo each; files are written into `folder`.
[[nodiscard]] Result<SessionFigures> measureSession(std::size_t hits, const QString& folder,
                                                    const Plan& plan);

}  // namespace hitscope::bench
