// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "analysis/moved_vertices.h"
#include "session/target.h"

namespace hitscope {

/// Copies of targets for background work, each made once and then brought up to date with
/// what moved: on the session's thread what is needed for that is gathered, a bounded number of vertices in
/// one turn of the event loop.
template <class Copy>
class CopiedTargets {
public:
    /// What the other thread is handed of one target.
    struct Part {
        std::shared_ptr<Copy> copy;
        std::vector<MovedVertex> moved;  ///< since the part before; to be taken over first
    };
    /// How many vertices one turn may still carry over: about a millisecond of them to begin with.
    using Room = std::size_t;
    static constexpr Room kATurn = 40'000;

    [[nodiscard]] bool contains(TargetId target) const { return m_copies.contains(target); }
    [[nodiscard]] bool empty() const { return m_copies.empty(); }

    /// These file vertices have moved. Returns whether there is a copy that it matters to.
    bool note(const Target& target, std::span<const std::uint32_t> vertices) {
        if (!contains(target.id)) {
            return false;
        }
        m_moved.note(target, vertices);
        return true;
    }
    /// Gathers what has moved of a target; make() makes its copy, of the original shape, if there is none.
    /// `shape`: where it is now; null: at the original. Returns whether that was all.
    template <class Make>
    bool gather(const Target& target, const DeformedMesh* shape, Room& room, const Make& make) {
        std::shared_ptr<Copy>& copy = m_copies[target.id];
        if (!copy) {
            copy = make();
            if (shape != nullptr) {
                m_moved.note(target, shape->onceChanged());
            }
        }
        const auto positions =
            shape != nullptr ? shape->positions() : std::span(target.deformed.original().positions);
        return m_moved.take(target.id, positions, room, m_gathered[target.id]);
    }
    template <class Make>
    bool gather(const Target& target, Room& room, const Make& make) {
        return gather(target, &target.deformed, room, make);
    }
    /// What was gathered; once for each target that was.
    [[nodiscard]] Part take(TargetId target) {
        return {m_copies.at(target), std::exchange(m_gathered[target], {})};
    }
    /// Leaves the copies to who still uses them: the next ones are new.
    void clear() {
        m_copies.clear();
        m_moved.clear();
        m_gathered.clear();
    }

private:
    std::map<TargetId, std::shared_ptr<Copy>> m_copies;
    MovedVertices m_moved;
    std::map<TargetId, std::vector<MovedVertex>> m_gathered;
};

}  // namespace hitscope
