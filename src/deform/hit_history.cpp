// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/hit_history.h"

#include <utility>

namespace hitscope {

void HitHistory::append(const Hit& hit) {
    m_hits.push_back(hit);
}

void HitHistory::removeLast() {
    m_hits.pop_back();
    ++m_revision;
}

void HitHistory::remove(std::size_t index) {
    m_hits.erase(m_hits.begin() + static_cast<std::ptrdiff_t>(index));
    ++m_revision;
}

void HitHistory::removeTarget(TargetId target) {
    if (std::erase_if(m_hits, [target](const Hit& hit) { return hit.target == target; }) > 0) {
        ++m_revision;
    }
}

void HitHistory::setConstantsOfAll(const DeformationConstants& constants) {
    for (Hit& hit : m_hits) {
        hit.constants = constants;
    }
    ++m_revision;
}

void HitHistory::assign(std::vector<Hit> hits) {
    m_hits = std::move(hits);
    ++m_revision;
}

void HitHistory::clear() {
    m_hits.clear();
    ++m_revision;
}

}  // namespace hitscope
