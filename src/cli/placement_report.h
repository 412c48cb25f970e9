// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/json_report.h"
#include "mesh/mesh_data.h"

namespace hitscope::cli {

/// Where a report gives coordinates of the scene: how those of the file come from them, as the member
/// "placement" of the object that is open. Nothing where they are the same.
inline void addPlacement(JsonReport& report, const Placement& placement) {
    if (!placement.isIdentity()) {
        report.beginObject("placement").vector("centre", placement.centre);
        report.number("scale", placement.scale).endObject();
    }
}

}  // namespace hitscope::cli
