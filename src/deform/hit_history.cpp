// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/hit_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hitscope {

std::vector<Hit> HitHistory::hitsOn(TargetId target) const {
    std::vector<Hit> hits;
    std::copy_if(m_hits.begin(), m_hits.end(), std::back_inserter(hits),
                 [target](const Hit& hit) { return hit.target == target; });
    return hits;
}

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
