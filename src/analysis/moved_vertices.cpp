// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/moved_vertices.h"

#include <algorithm>

#include "session/target.h"

namespace hitscope {

void MovedVertices::note(const Target& target, std::span<const std::uint32_t> fileVertices) {
    Noted& noted = m_noted[target.id];
    noted.isNoted.resize(target.deformed.positions().size(), false);
    for (const std::uint32_t vertex : fileVertices) {
        if (!noted.isNoted[vertex]) {
            noted.isNoted[vertex] = true;
            noted.vertices.push_back(vertex);
        }
    }
}

bool MovedVertices::take(TargetId target, std::span<const glm::vec3> positions, std::size_t& room,
                         std::vector<MovedVertex>& taken) {
    const auto found = m_noted.find(target);
    if (found == m_noted.end()) {
        return true;
    }
    Noted& noted = found->second;
    const std::size_t left = noted.vertices.size() - std::min(room, noted.vertices.size());
    for (std::size_t i = left; i < noted.vertices.size(); ++i) {
        const std::uint32_t vertex = noted.vertices[i];
        noted.isNoted[vertex] = false;
        taken.push_back({vertex, positions[vertex]});
    }
    room -= noted.vertices.size() - left;
    noted.vertices.resize(left);
    return left == 0;
}

}  // namespace hitscope
