// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/reference.h"

#include <algorithm>
#include <iterator>

#include "core/give_up.h"
#include "core/offset.h"
#include "deform/deform.h"
#include "deform/deform_all.h"

namespace hitscope {

namespace {

constexpr std::size_t kClustersBetweenLooks = 64;  // 4,096 vertices, about 0.1 ms

}  // namespace

void deformEverywhere(std::span<DynamicVertex> vertices, std::span<const Hit> hits) {
    std::vector<DentShape> dents;
    dents.reserve(hits.size());
    std::transform(hits.begin(), hits.end(), std::back_inserter(dents), dentShapeOf);
    for (DynamicVertex& vertex : vertices) {
        for (const DentShape& dent : dents) {
            deform(vertex.position, vertex.normal, dent);
        }
    }
}

ReferenceDeformation::ReferenceDeformation(const RenderMesh& mesh)
    : m_mesh(mesh), m_vertices(mesh), m_reach(mesh) {}

Hit ReferenceDeformation::hit(std::size_t index) const {
    const Dent& dent = m_dents[index];
    if (dent.formed != nullptr) {
        return *dent.formed;
    }
    return {.target = {}, .point = dent.point, .direction = dent.direction, .constants = dent.constants};
}

std::vector<VertexRange> ReferenceDeformation::apply(std::span<const Hit> hits) {
    std::transform(hits.begin(), hits.end(), std::back_inserter(m_dents), Dent::of);
    advance();
    return takeChanged();
}

void ReferenceDeformation::edit(const TargetHitsEdit& edit) {
    const bool isApplied = edit.first < m_applied;
    if (isApplied) {
        finishHit();
        // Where the vertices have been so far is enough to tell: those in other clusters went, and go, the
        // same way without these hits.
        concern(edit.before);
        concern(edit.after);
        const std::size_t end = edit.first + edit.before.size();
        m_applied = m_applied - (std::min(end, m_applied) - edit.first) + edit.after.size();
    }
    const auto at = m_dents.erase(m_dents.begin() + offset(edit.first),
                                  m_dents.begin() + offset(edit.first + edit.before.size()));
    std::vector<Dent> after(edit.after.size());
    std::transform(edit.after.begin(), edit.after.end(), after.begin(), Dent::of);
    m_dents.insert(at, after.begin(), after.end());
    if (isApplied) {
        restartConcerned();
    }
}

/// Adds the clusters that these may ever have reached.
void ReferenceDeformation::concern(std::span<const Hit> hits) {
    const std::vector<std::uint32_t> reached = m_reach.everReached(hits);
    m_concerned.insert(m_concerned.end(), reached.begin(), reached.end());
    std::sort(m_concerned.begin(), m_concerned.end());
    m_concerned.erase(std::unique(m_concerned.begin(), m_concerned.end()), m_concerned.end());
}

void ReferenceDeformation::restartConcerned() {
    for (const std::uint32_t index : m_concerned) {
        m_vertices.restore(index);
    }
    m_reach.restart(m_concerned);
    m_changed.add(m_reach.rangesOf(m_concerned));
    m_redone = 0;
}

/// What an edit changes must not be a hit that is applied in part.
void ReferenceDeformation::finishHit() {
    if (!m_progress.isDone()) {
        const std::size_t last = m_concerned.empty() ? m_applied : m_redone;
        continueHit(hit(last - 1), {});
    }
}

/// Returns whether all of it has been applied.
bool ReferenceDeformation::continueHit(const Hit& hit, const IsTimeUp& isTimeUp) {
    const DentShape dent = dentShapeOf(hit);
    while (!m_progress.isDone()) {
        const std::size_t end = std::min(m_progress.next + kClustersBetweenLooks, m_progress.reached.size());
        const std::span<const std::uint32_t> some =
            std::span(m_progress.reached).subspan(m_progress.next, end - m_progress.next);
        for (const std::uint32_t index : some) {
            const std::span<DynamicVertex> vertices = m_vertices.cluster(index);
            deformAll(vertices, dent);
            m_reach.placeCluster(index, vertices);
        }
        m_changed.add(m_reach.rangesOf(some));
        m_progress.next = end;
        mayGiveUp();
        if (isTimeUp && isTimeUp()) {
            break;
        }
    }
    return m_progress.isDone();
}

/// Takes the clusters concerned through the hits that the others have had.
bool ReferenceDeformation::redo(const IsTimeUp& isTimeUp) {
    while (!m_concerned.empty()) {
        if (m_redone > 0 && !continueHit(hit(m_redone - 1), isTimeUp)) {
            return false;
        }
        if (m_redone == m_applied) {
            m_concerned.clear();
            m_redone = 0;
        } else {
            m_progress = {};
            m_reach.findWithin(m_concerned, hit(m_redone), m_progress.reached);
            ++m_redone;
            if (isTimeUp && isTimeUp()) {
                return false;
            }
        }
    }
    return true;
}

bool ReferenceDeformation::advance(const IsTimeUp& isTimeUp) {
    if (!redo(isTimeUp)) {
        return false;
    }
    if (m_applied > 0 && !continueHit(hit(m_applied - 1), isTimeUp)) {
        return false;
    }
    while (m_applied < m_dents.size()) {
        m_progress = {};
        m_reach.find(hit(m_applied), m_progress.reached);
        ++m_applied;
        if (!continueHit(hit(m_applied - 1), isTimeUp)) {
            return false;
        }
        if (m_applied < m_dents.size() && isTimeUp && isTimeUp()) {
            return false;
        }
    }
    return true;
}

}  // namespace hitscope
