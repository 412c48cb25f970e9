// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope::cli {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE end the program as they do without this, after files and
/// folders that are half written have been removed. Those that whoever started it has switched off stay so.
void endInOrder();

}  // namespace hitscope::cli
