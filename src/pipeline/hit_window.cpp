// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_window.h"

namespace hitscope {

void HitWindow::push(const KeptHit& hit, std::vector<KeptHit>& dropped) {
    m_hits.push_back(hit);
    if (m_hits.size() > m_capacity) {
        dropped.push_back(m_hits.front());
        m_hits.pop_front();
    }
}

}  // namespace hitscope
