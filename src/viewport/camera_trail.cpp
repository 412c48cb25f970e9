// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_trail.h"

#include "view/camera_text.h"
#include "viewport/navigation.h"

namespace hitscope {

CameraTrail::CameraTrail(Navigation& navigation, QObject* parent)
    : QObject(parent), m_navigation(navigation) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (m_navigation.isMoving()) {
            m_rest.start();
        } else {
            note();
        }
    });
    connect(&navigation, &Navigation::cameraChanged, &m_rest, qOverload<>(&QTimer::start));
    m_rest.start();
}

bool CameraTrail::isElsewhere() const {
    return m_views.empty() || cameraText(m_views[m_at]) != cameraText(m_navigation.goal());
}

bool CameraTrail::canGoBack() const {
    return m_at > 0 || (!m_views.empty() && isElsewhere());
}

void CameraTrail::note() {
    if (!isElsewhere()) {
        return;
    }
    if (!m_views.empty()) {
        m_views.resize(m_at + 1, m_views[m_at]);
    }
    if (m_views.size() == kMost) {
        m_views.erase(m_views.begin());
    }
    m_views.push_back(m_navigation.goal());
    m_at = m_views.size() - 1;
    Q_EMIT changed();
}

/// A view that did not come to rest yet is one to come forward to again.
void CameraTrail::goBack() {
    note();
    if (m_at > 0) {
        go(m_at - 1);
    }
}

void CameraTrail::goForward() {
    note();
    if (canGoForward()) {
        go(m_at + 1);
    }
}

void CameraTrail::go(std::size_t to) {
    m_at = to;
    m_navigation.setCamera(m_views[to]);
    Q_EMIT changed();
}

void CameraTrail::clear() {
    m_views.clear();
    m_at = 0;
    m_rest.start();
    Q_EMIT changed();
}

}  // namespace hitscope
