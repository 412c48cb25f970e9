// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QThreadPool;

namespace hitscope {

/// Where work of any length runs beside the window. Not QThreadPool::globalInstance(): Qt paints large
/// widgets on that one's threads and waits for them, so that the window would stand still until work there is
/// done. The application waits for what runs here when it ends.
[[nodiscard]] QThreadPool& backgroundPool();

/// Has the thread that calls this, which is one of that pool's, give way to the window's where processors are
/// few: a key or click then waits less while a large mesh is worked on.
void yieldToTheWindow();

}  // namespace hitscope
