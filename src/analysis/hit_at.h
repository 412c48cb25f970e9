// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope {

/// The hit, of those shown, that moved a vertex farthest: whose dent it is in. The last of equals; nothing if
/// none moved it. Takes the vertex through all hits, which is 100,000 in about a millisecond.
[[nodiscard]] std::optional<std::size_t> hitThatMovedMost(const Session& session, const VertexRef& vertex);

}  // namespace hitscope
