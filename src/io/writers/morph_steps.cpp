// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/morph_steps.h"

#include <algorithm>

#include "core/give_up.h"
#include "deform/reference.h"
#include "mesh/same_bits.h"

namespace hitscope {

namespace {

/// One target as the hits so far have left it.
class MorphReplay {
public:
    explicit MorphReplay(const RenderMesh& render) : m_render(render), m_deformation(render) {
        for (const DynamicVertex& vertex : render.vertices) {
            mayGiveUp(m_known.size());
            m_known.push_back(vertex.position);
        }
    }

    /// goesOn: told how many of the hits are applied; false: the rest is not wanted.
    std::vector<MovedVertex> apply(std::span<const Hit> hits,
                                   const std::function<bool(std::size_t)>& goesOn) {
        constexpr std::size_t kAtOnce = 8;  // hits
        std::vector<VertexRange> ranges;
        for (std::size_t first = 0; first < hits.size() && goesOn(first); first += kAtOnce) {
            const std::size_t count = std::min(kAtOnce, hits.size() - first);
            const std::vector<VertexRange> reached = m_deformation.apply(hits.subspan(first, count));
            ranges.insert(ranges.end(), reached.begin(), reached.end());
        }
        std::vector<MovedVertex> moved;
        for (const VertexRange& range : merged(std::move(ranges))) {
            for (std::uint32_t r = range.first; r < range.first + range.count; ++r) {
                mayGiveUp(r);
                take(r, moved);
            }
        }
        return moved;
    }

private:
    /// All render vertices of a file vertex are at one place: the first one tells.
    void take(std::uint32_t renderVertex, std::vector<MovedVertex>& moved) {
        const std::uint32_t vertex = m_render.fileVertices[renderVertex];
        const glm::vec3& now = m_deformation.vertices()[renderVertex].position;
        if (m_render.renderVerticesOf(vertex).front() == renderVertex &&
            !sameBits(m_known[renderVertex], now)) {
            m_known[renderVertex] = now;
            moved.push_back({vertex, now});
        }
    }

    const RenderMesh& m_render;
    ReferenceDeformation m_deformation;
    std::vector<glm::vec3> m_known;  ///< positions of render vertices
};

/// "Hit 5", "Hits 5-8", "Hits 5-8 (scatter 2)" where all are of one group: by their rows in the history,
/// from 1.
std::string nameOfStep(std::span<const Hit> hits, std::span<const std::size_t> rows) {
    const std::string first = std::to_string(rows.front() + 1);
    const std::string name =
        rows.size() == 1 ? "Hit " + first : "Hits " + first + "-" + std::to_string(rows.back() + 1);
    const HitGroup& group = hits[rows.front()].group;
    const bool isOne =
        group && std::ranges::all_of(rows, [&](std::size_t row) { return hits[row].group == group; });
    return isOne ? name + " (" + groupText(group) + ")" : name;
}

/// Where each unit begins in `rows`.
std::vector<std::size_t> unitStarts(std::span<const Hit> hits, std::span<const std::size_t> rows,
                                    MorphUnit unit) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const HitGroup& group = hits[rows[i]].group;
        if (unit == MorphUnit::Hit || i == 0 || !group || hits[rows[i - 1]].group != group) {
            starts.push_back(i);
        }
    }
    return starts;
}

}  // namespace

std::size_t morphUnitCount(std::span<const Hit> hits, std::span<const std::size_t> rows, MorphUnit unit) {
    return unitStarts(hits, rows, unit).size();
}

std::optional<std::vector<std::vector<MorphStep>>> morphSteps(std::span<const Hit> hits,
                                                              std::span<const MorphedTarget> targets,
                                                              const MorphGrouping& grouping,
                                                              const std::function<bool(double)>& goOn) {
    std::vector<MorphReplay> replays;
    replays.reserve(targets.size());
    for (const MorphedTarget& target : targets) {
        replays.emplace_back(*target.render);
    }
    std::vector<std::size_t> rows;
    for (std::size_t h = 0; h < hits.size(); ++h) {
        const bool isOurs =
            std::any_of(targets.begin(), targets.end(),
                        [&hits, h](const MorphedTarget& target) { return target.id == hits[h].target; });
        if (hits[h].enabled && isOurs) {
            rows.push_back(h);
        }
    }
    std::vector<std::vector<MorphStep>> steps(targets.size());
    bool isWanted = true;
    std::size_t applied = 0;
    const auto goesOn = [&](std::size_t done) {
        isWanted = isWanted &&
                   (!goOn || goOn(static_cast<double>(applied + done) / static_cast<double>(rows.size())));
        return isWanted;
    };
    std::vector<std::size_t> starts = unitStarts(hits, rows, grouping.unit);
    const std::size_t units = starts.size();
    starts.push_back(rows.size());
    const std::size_t parts = std::min(units, grouping.most);
    for (std::size_t p = 0; p < parts; ++p) {
        const std::size_t first = starts[p * units / parts];
        const std::size_t end = starts[(p + 1) * units / parts];
        const auto part = std::span<const std::size_t>(rows).subspan(first, end - first);
        for (std::size_t t = 0; t < targets.size(); ++t) {
            MorphStep& step = steps[t].emplace_back(MorphStep{nameOfStep(hits, part), {}});
            std::vector<Hit> own;
            for (const std::size_t row : part) {
                if (hits[row].target == targets[t].id) {
                    own.push_back(hits[row]);
                }
            }
            step.moved = replays[t].apply(own, goesOn);
            applied += own.size();
            if (!isWanted) {
                return std::nullopt;
            }
        }
    }
    return steps;
}

}  // namespace hitscope
