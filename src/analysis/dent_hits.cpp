// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/dent_hits.h"

#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "deform/dent_shape.h"
#include "session/shown_number.h"

namespace hitscope {

void DentHits::follow(const std::shared_ptr<const RenderMesh>& mesh, std::span<const Hit> hits) {
    if (m_mesh != mesh) {
        m_mesh = mesh;
        m_effects = std::make_unique<TargetEffects>(mesh);
        m_hits.clear();
    }
    const auto [before, after] = std::mismatch(m_hits.begin(), m_hits.end(), hits.begin(), hits.end());
    if (before == m_hits.end() && after == hits.end()) {
        return;
    }
    TargetHitsEdit edit;
    edit.first = static_cast<std::size_t>(before - m_hits.begin());
    edit.before.assign(before, m_hits.end());
    edit.after.assign(after, hits.end());
    m_hits.assign(hits.begin(), hits.end());
    const std::atomic<bool> stop = false;
    static_cast<void>(m_effects->follow({&edit, 1}, m_hits, stop));
}

std::optional<std::uint32_t> DentHits::deepestOf(std::size_t hit, std::span<const std::uint32_t> triangles,
                                                 std::span<const glm::vec3> before,
                                                 std::span<const glm::vec3> after) const {
    std::vector<bool> isCorner(before.size(), false);
    for (const std::uint32_t vertex : triangles) {
        isCorner[vertex] = true;
    }
    const HitEffect& effect = m_effects->effects()[hit];
    if (effect.affected > 0 && isCorner[effect.deepest]) {
        return effect.deepest;
    }
    std::optional<std::uint32_t> deepest;
    float most = 0.0f;
    for (const std::uint32_t vertex : m_effects->movedBy(hit, m_hits)) {
        const float moved = glm::distance(before[vertex], after[vertex]);
        if (isCorner[vertex] && moved > most) {
            most = moved;
            deepest = vertex;
        }
    }
    return deepest;
}

std::vector<std::size_t> DentHits::madeBy(std::span<const std::uint32_t> vertices, const Bounds& box) const {
    // On their way vertices leave the box by less than this.
    const auto reaches = [&box](const Hit& hit) {
        const HitReach reach = reachOf(hit);
        const glm::vec3 nearest = glm::clamp(reach.centre, box.min, box.max);
        return glm::distance(reach.centre, nearest) <= 2.0f * reach.radius;
    };
    const auto isIn = [vertices](std::uint32_t vertex) {
        return std::binary_search(vertices.begin(), vertices.end(), vertex);
    };
    std::vector<std::size_t> hits;
    for (std::size_t hit = 0; hit < m_hits.size(); ++hit) {
        const HitEffect& effect = m_effects->effects()[hit];
        if (effect.affected == 0) {
            continue;
        }
        bool isOne = isIn(effect.deepest);
        if (!isOne && reaches(m_hits[hit])) {
            // It may have moved vertices of two walls.
            const std::vector<std::uint32_t> moved = m_effects->movedBy(hit, m_hits);
            isOne = std::any_of(moved.begin(), moved.end(), isIn);
        }
        if (isOne) {
            hits.push_back(hit);
        }
    }
    return hits;
}

std::vector<Hit> DentHits::hitsAt(std::span<const std::size_t> indices) const {
    std::vector<Hit> hits;
    hits.reserve(indices.size());
    std::transform(indices.begin(), indices.end(), std::back_inserter(hits),
                   [this](std::size_t index) { return m_hits[index]; });
    return hits;
}

QString hitNumbersText(std::span<const std::size_t> rows) {
    constexpr std::size_t kMost = 4;  // named; two more are "and 2 more"
    const auto tr = [](const char* text) { return QCoreApplication::translate("hitscope::DentHits", text); };
    QStringList numbers;
    const std::size_t named = rows.size() > kMost + 1 ? kMost : rows.size();
    for (const std::size_t row : rows.first(named)) {
        numbers.append(shownCount(row + 1));
    }
    if (rows.size() == 1) {
        return tr("hit %1").arg(numbers.front());
    }
    if (named < rows.size()) {
        return tr("hits %1 and %2 more")
            .arg(numbers.join(numberSeparator()), shownCount(rows.size() - named));
    }
    const QString last = numbers.takeLast();
    return tr("hits %1 and %2").arg(numbers.join(numberSeparator()), last);
}

}  // namespace hitscope
