// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/ids.h"
#include "deform/vertex_range.h"
#include "gl/objects.h"

namespace hitscope {

/// Vertices as they were before the last hits, kept on the GPU, so that taking a hit back costs about what it
/// did. A ring of fixed size: the oldest are overwritten, and hits older than these are undone by going
/// through the others again. A context is current for every call and the destructor.
class UndoRing {
public:
    /// Keeps vertices of `buffer` (DynamicVertex) as they are, before hits [firstHit, ...) of the target are
    /// applied to them. Calls for one target come with growing firstHit.
    void save(TargetId target, GLuint buffer, std::size_t firstHit, std::vector<VertexRange> ranges);

    /// The hit from which on the target's vertices can be put back to what they were before it, such that
    /// `hit` is not applied any more: the greatest one not after it. Nothing: no longer kept.
    [[nodiscard]] std::optional<std::size_t> reachableBefore(TargetId target, std::size_t hit) const;
    /// Puts them back: all that was saved for hits from `firstHit` on, which reachableBefore() has named.
    /// Returns what was written, sorted and merged.
    std::vector<VertexRange> goBack(TargetId target, GLuint buffer, std::size_t firstHit);

    /// What was saved for the target is of no use any more.
    void forget(TargetId target) { m_entries.erase(target); }
    void clear() { m_entries.clear(); }

private:
    struct Entry {
        std::size_t firstHit = 0;
        std::vector<VertexRange> ranges;
        std::uint64_t start = 0;  ///< in bytes since the ring was made; it lies at start % size
    };
    [[nodiscard]] bool isKept(const Entry& entry) const;
    void reserve();

    gl::Buffer m_buffer;
    std::uint64_t m_end = 0;  ///< where the next entry starts
    std::unordered_map<TargetId, std::deque<Entry>> m_entries;
};

}  // namespace hitscope
