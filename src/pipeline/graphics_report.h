// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deform/exactness.h"
#include "deform/renderer_verdict.h"

namespace hitscope {

/// Name and value, in the order in which people read them.
using GraphicsReport = std::vector<std::pair<std::string, std::string>>;

/// What draws and what it can do: names and versions, the limits that matter here, how exactly it deforms,
/// which pipelines run, and what came of trying them and picking. `exactness`: nothing: not measured. `why`
/// may know more reasons than the driver's version why a pipeline cannot run; empty: it can. A context is
/// current.
[[nodiscard]] GraphicsReport graphicsReport(const std::optional<Exactness>& exactness,
                                            const RendererVerdict& verdict,
                                            const std::function<std::string(PipelineKind)>& why = {});

/// A line an entry, "  name    value", the values below one another.
[[nodiscard]] std::string toText(const GraphicsReport& report);

}  // namespace hitscope
