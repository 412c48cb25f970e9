// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/face_cutter.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace hitscope {

bool isConvexQuad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    const std::array corners{glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), glm::dvec3(d)};
    const glm::dvec3 normal = glm::cross(corners[2] - corners[0], corners[3] - corners[1]);
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 in = corners[(i + 1) % 4] - corners[i];
        const glm::dvec3 out = corners[(i + 2) % 4] - corners[(i + 1) % 4];
        if (!(glm::dot(glm::cross(in, out), normal) > 0.0)) {
            return false;
        }
    }
    return true;
}

FaceCutter::FaceCutter(RefineWork& work, const RefineWork::Face& face,
                       std::span<const std::optional<RefineCorner>> middles)
    : m_work(work), m_middles(middles.begin(), middles.end()) {
    const std::span<const RefineCorner> corners = work.cornersOf(face);
    m_corners.assign(corners.begin(), corners.end());
}

void FaceCutter::cut(const Emit& emit) {
    if (m_corners.size() == 3) {
        cutTriangle(emit);
        return;
    }
    if (m_corners.size() == 4 && isConvexQuad()) {
        cutQuad(emit);
        return;
    }
    // A polygon beside the region: it takes the vertices in.
    std::vector<RefineCorner> all;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        all.push_back(m_corners[i]);
        if (m_middles[i]) {
            all.push_back(*m_middles[i]);
        }
    }
    emit(all);
}

void FaceCutter::cutTriangle(const Emit& emit) {
    const auto count =
        std::count_if(m_middles.begin(), m_middles.end(), [](const auto& m) { return m.has_value(); });
    if (count == 3) {
        for (std::size_t i = 0; i < 3; ++i) {
            emit(std::array{corner(i), middle(i), middle(i + 2)});
        }
        emit(std::array{middle(0), middle(1), middle(2)});
        return;
    }
    if (count == 1) {
        while (!has(0)) {
            ++m_turn;
        }
        emit(std::array{corner(0), middle(0), corner(2)});
        emit(std::array{middle(0), corner(1), corner(2)});
        return;
    }
    while (has(2)) {
        ++m_turn;
    }
    emit(std::array{middle(0), corner(1), middle(1)});
    cutByDiagonal(emit, corner(0), middle(0), middle(1), corner(2));
}

/// On the shorter diagonal.
void FaceCutter::cutByDiagonal(const Emit& emit, const RefineCorner& a, const RefineCorner& b,
                               const RefineCorner& c, const RefineCorner& d) const {
    if (m_work.squaredLength(a.vertex, c.vertex) <= m_work.squaredLength(b.vertex, d.vertex)) {
        emit(std::array{a, b, c});
        emit(std::array{a, c, d});
    } else {
        emit(std::array{a, b, d});
        emit(std::array{b, c, d});
    }
}

void FaceCutter::cutQuad(const Emit& emit) {
    const auto count = static_cast<std::size_t>(
        std::count_if(m_middles.begin(), m_middles.end(), [](const auto& m) { return m.has_value(); }));
    if (count == 1) {
        while (!has(0)) {
            ++m_turn;
        }
        emit(std::array{corner(0), middle(0), corner(3)});
        emit(std::array{middle(0), corner(1), corner(2)});
        emit(std::array{middle(0), corner(2), corner(3)});
        return;
    }
    if (count == 2 && has(0) == has(2)) {
        while (!has(0)) {
            ++m_turn;
        }
        emit(std::array{corner(0), middle(0), middle(2), corner(3)});
        emit(std::array{middle(0), corner(1), corner(2), middle(2)});
        return;
    }
    cutQuadAcross(emit, count);
}

/// With a vertex in its middle: two neighbouring sides, three or four.
void FaceCutter::cutQuadAcross(const Emit& emit, std::size_t count) {
    const RefineCorner centre = m_work.centreOf(m_corners);
    if (count == 2) {
        while (!has(0) || !has(1)) {
            ++m_turn;
        }
        emit(std::array{middle(0), corner(1), middle(1), centre});
        emit(std::array{corner(0), middle(0), centre, corner(3)});
        emit(std::array{centre, middle(1), corner(2), corner(3)});
        return;
    }
    if (count == 3) {
        while (has(3)) {
            ++m_turn;
        }
        emit(std::array{middle(0), corner(1), middle(1), centre});
        emit(std::array{middle(1), corner(2), middle(2), centre});
        emit(std::array{corner(0), middle(0), centre});
        emit(std::array{centre, middle(2), corner(3)});
        emit(std::array{corner(0), centre, corner(3)});
        return;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        emit(std::array{corner(i), middle(i), centre, middle(i + 3)});
    }
}

bool FaceCutter::isConvexQuad() const {
    return hitscope::isConvexQuad(m_work.position(m_corners[0].vertex), m_work.position(m_corners[1].vertex),
                                  m_work.position(m_corners[2].vertex), m_work.position(m_corners[3].vertex));
}

}  // namespace hitscope
