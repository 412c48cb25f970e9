// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/ids.h"
#include "mesh/surface/surface_measurer.h"

namespace hitscope {

struct Target;

/// Which vertices have moved since they were last taken: for who keeps a copy of the positions on another
/// thread, so that only what changed has to be carried there. Each vertex is noted once, however often it
/// moves.
class MovedVertices {
public:
    void note(const Target& target, std::span<const std::uint32_t> fileVertices);
    void forget(TargetId target) { m_noted.erase(target); }
    void clear() { m_noted.clear(); }
    /// Where they are by `positions` (one a file vertex), appended to `taken`; at most `room` of them, which
    /// is then so much less. Whether these were all.
    [[nodiscard]] bool take(TargetId target, std::span<const glm::vec3> positions, std::size_t& room,
                            std::vector<MovedVertex>& taken);

private:
    struct Noted {
        std::vector<std::uint32_t> vertices;
        std::vector<bool> isNoted;  ///< one a file vertex
    };
    std::map<TargetId, Noted> m_noted;
};

}  // namespace hitscope
