// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mesh/refine/refine_work.h"

namespace hitscope {

/// Cuts one face whose sides have vertices in their middles: into faces that have all of these as corners.
class FaceCutter {
public:
    using Emit = std::function<void(std::span<const RefineCorner>)>;

    /// `middles`: one a side, side i from corner i to the next; one of them at least is there. All outlive
    /// this.
    FaceCutter(RefineWork& work, const RefineWork::Face& face,
               std::span<const std::optional<RefineCorner>> middles);

    void cut(const Emit& emit);

private:
    // Corners and middles as one turns the face: corner(0) is where its numbers begin.
    [[nodiscard]] const RefineCorner& corner(std::size_t i) const {
        return m_corners[(m_turn + i) % m_corners.size()];
    }
    [[nodiscard]] const RefineCorner& middle(std::size_t i) const {
        return *m_middles[(m_turn + i) % m_corners.size()];
    }
    [[nodiscard]] bool has(std::size_t i) const {
        return m_middles[(m_turn + i) % m_corners.size()].has_value();
    }
    void cutTriangle(const Emit& emit);
    void cutQuad(const Emit& emit);
    void cutQuadAcross(const Emit& emit, std::size_t count);
    void cutByDiagonal(const Emit& emit, const RefineCorner& a, const RefineCorner& b, const RefineCorner& c,
                       const RefineCorner& d) const;
    [[nodiscard]] bool isConvexQuad() const;

    RefineWork& m_work;
    std::vector<RefineCorner> m_corners;
    std::vector<std::optional<RefineCorner>> m_middles;
    std::size_t m_turn = 0;
};

/// Whether a quad turns the same way at each of its corners.
[[nodiscard]] bool isConvexQuad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                                const glm::vec3& d);

}  // namespace hitscope
