// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

class QThreadPool;

namespace hitscope {

/// Where work of any length runs beside the window. Not QThreadPool::globalInstance(): Qt paints large
/// widgets on that one's threads and waits for them, so that the window would stand still until work there is
/// done. The application waits for what runs here when it ends.
[[nodiscard]] QThreadPool& backgroundPool();

/// Runs the job there. Its thread gives way to the window's and to those that a software renderer draws with:
/// a picture that shares the processors with it as an equal takes twice as long, and events wait for it.
void startInBackground(std::function<void()> job);

/// From now on this thread, with those and the programs that it starts, works when the window needs no
/// processor.
void giveWay();

}  // namespace hitscope
