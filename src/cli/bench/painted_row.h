// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

#include "session/session.h"

namespace hitscope::bench {

/// A row of the paper's tables whose vertices have colours and whose faces have a material that looks like
/// none: with colours off it is drawn as the row itself. 0 <= row < paperRows().size().
[[nodiscard]] ScenePlan planPaintedRow(int row);

/// Makes the targets of such a scene of metal, and back.
class MetalCoat {
public:
    void put(Session& session, bool on);

private:
    /// What the meshes are with it or without it. They are kept, so that a shape stays one mesh.
    std::map<std::shared_ptr<const MeshData>, std::shared_ptr<const MeshData>> m_others;
    bool m_on = false;
};

}  // namespace hitscope::bench
