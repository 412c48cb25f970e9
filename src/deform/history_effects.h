// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

#include "deform/effects.h"

namespace hitscope {

/// What each hit of a history did, on all targets. Belongs to one thread at a time.
class HistoryEffects {
public:
    /// The shapes of the targets; a hit on a target without one does nothing. Null: there is no such target.
    /// A target whose shape is given, be it the same as before, is a new one: its counts are told from zero.
    using Shapes = std::map<TargetId, std::shared_ptr<const RenderMesh>>;

    struct Changes {
        struct Row {
            std::uint32_t row = 0;  ///< of the history after the edits
            HitEffect effect;
        };
        struct Counts {
            TargetId target;
            bool fromZero = false;                ///< all that `vertices` does not list are 0
            std::vector<std::uint32_t> vertices;  ///< file vertices, each once
            std::vector<std::uint32_t> counts;    ///< one a vertex
        };
        std::vector<Row> rows;  ///< ascending: what has changed or came with an edit, less disabled hits
        std::vector<Counts> counts;
    };
    /// Follows edits of the history, in the order made, and takes `shapes` over. When `stop` is set meanwhile
    /// it returns early, and this is of no use any more.
    Changes follow(std::span<const HistoryEdit> edits, const Shapes& shapes, const std::atomic<bool>& stop);

    /// The file vertices of its target that a hit moved, ascending; none for one that is disabled.
    [[nodiscard]] std::vector<std::uint32_t> movedBy(std::size_t row) const;
    /// Null: no enabled hit is on it.
    [[nodiscard]] const TargetEffects* of(TargetId target) const;

private:
    /// Changed hits by target, as indices into those of the target, ascending.
    using ChangedHits = std::map<TargetId, std::vector<std::uint32_t>>;
    struct Rows {
        std::size_t first = 0;
        std::size_t end = 0;
    };
    static std::vector<Rows> madeBy(std::span<const HistoryEdit> edits);
    void followShapes(const Shapes& shapes);
    void follow(TargetId target, std::span<const TargetHitsEdit> edits, const std::atomic<bool>& stop,
                ChangedHits& changed, Changes& changes);
    [[nodiscard]] std::vector<Changes::Row> rowsOf(ChangedHits changed, std::span<const Rows> made) const;

    HitsByTarget m_hits;
    Shapes m_shapes;
    std::map<TargetId, TargetEffects> m_targets;
};

}  // namespace hitscope
