// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/attribution.h"

namespace hitscope {

bool Attribution::add(std::size_t index, const Hit& hit) {
    const std::optional<Contribution> made = contributionTo(m_vertex.position, hit);
    if (!made) {
        return false;
    }
    deform(m_vertex.position, m_vertex.normal, hit);
    m_contributions.push_back({index, *made, m_vertex.position});
    return true;
}

void Attribution::append(const Attribution& further) {
    m_vertex = further.m_vertex;
    m_contributions.insert(m_contributions.end(), further.m_contributions.begin(),
                           further.m_contributions.end());
}

}  // namespace hitscope
