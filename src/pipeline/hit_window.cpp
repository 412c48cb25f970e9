// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_window.h"

#include <algorithm>

#include "pipeline/hit_arrays.h"

namespace hitscope {

void HitWindow::push(const KeptHit& hit, std::vector<KeptHit>& dropped) {
    m_hits.push_back(hit);
    const auto colour = std::find_if(m_palette.begin(), m_palette.end(), [&hit](const Colour& known) {
        return known.constants == hit.hit.constants;
    });
    if (colour != m_palette.end()) {
        ++colour->hits;
    } else {
        m_palette.push_back({hit.hit.constants, 1});
    }
    while (m_hits.size() > m_capacity || m_palette.size() > kHitConstants) {
        dropOldest(dropped);
    }
}

void HitWindow::dropOldest(std::vector<KeptHit>& dropped) {
    const auto colour = std::find_if(m_palette.begin(), m_palette.end(), [this](const Colour& known) {
        return known.constants == m_hits.front().hit.constants;
    });
    if (--colour->hits == 0) {
        m_palette.erase(colour);
    }
    dropped.push_back(m_hits.front());
    m_hits.pop_front();
}

}  // namespace hitscope
