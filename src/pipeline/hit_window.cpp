// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_window.h"

namespace hitscope {

namespace {

bool hasCurve(const KeptHit& kept) {
    return kept.hit.form.profile == DentProfile::Curve;
}

}  // namespace

void HitWindow::push(const KeptHit& hit, std::vector<KeptHit>& dropped) {
    m_hits.push_back(hit);
    if (hasCurve(hit)) {
        ++m_curves[hit.hit.form.curve];
    }
    while (m_hits.size() > m_capacity || m_curves.size() > m_mostCurves) {
        dropOldest(dropped);
    }
}

void HitWindow::dropOldest(std::vector<KeptHit>& dropped) {
    if (hasCurve(m_hits.front())) {
        const auto curve = m_curves.find(m_hits.front().hit.form.curve);
        if (--curve->second == 0) {
            m_curves.erase(curve);
        }
    }
    dropped.push_back(m_hits.front());
    m_hits.pop_front();
}

}  // namespace hitscope
