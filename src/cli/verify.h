// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace hitscope::cli {

/// hitscope-cli verify: applies a file's hits with every pipeline that runs here and holds each against the
/// reference. The exit status: kFailed where one differs.
int verifyCommand(const QStringList& arguments);

}  // namespace hitscope::cli
