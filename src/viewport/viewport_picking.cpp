// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport_picking.h"

#include <utility>

#include "scene/scene_picker.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

glm::vec2 toPixels(const QPointF& position, qreal ratio) {
    return {static_cast<float>(position.x() * ratio), static_cast<float>(position.y() * ratio)};
}

}  // namespace

ViewportPicking::ViewportPicking(Viewport& viewport) : m_viewport(viewport) {}

ViewportPicking::~ViewportPicking() = default;

void ViewportPicking::setPicker(std::unique_ptr<ScenePicker> picker) {
    m_picker = std::move(picker);
}

/// Once: whoever moves the cursor asks again and again.
void ViewportPicking::report(const Error& error) {
    if (error.message() != m_told) {
        m_told = error.message();
        QMetaObject::invokeMethod(
            &m_viewport, [&viewport = m_viewport, error] { Q_EMIT viewport.failed(error); },
            Qt::QueuedConnection);
    }
}

std::optional<VertexRef> ViewportPicking::vertexAt(const QPointF& position) {
    if (!m_picker || !m_viewport.syncNow()) {
        return std::nullopt;
    }
    m_viewport.surface().makeCurrent();
    const auto picked = m_picker->pick(m_viewport.view(), toPixels(position, m_viewport.devicePixelRatioF()));
    m_viewport.surface().doneCurrent();
    if (!picked) {
        report(picked.error());
        return std::nullopt;
    }
    return picked.value();
}

bool ViewportPicking::requestVertexAt(const QPointF& position) {
    if (!m_picker) {
        return false;
    }
    m_viewport.surface().makeCurrent();
    const Status asked =
        m_picker->request(m_viewport.view(), toPixels(position, m_viewport.devicePixelRatioF()));
    m_viewport.surface().doneCurrent();
    if (!asked) {
        report(asked.error());
    }
    return asked.ok();
}

std::optional<std::optional<VertexRef>> ViewportPicking::requestedVertex() {
    if (!m_picker || !m_picker->isPending()) {
        return std::optional<VertexRef>();  // the context went meanwhile, and the question with it
    }
    m_viewport.surface().makeCurrent();
    const auto arrived = m_picker->arrived();
    m_viewport.surface().doneCurrent();
    return arrived;
}

std::map<TargetId, std::vector<std::uint32_t>> ViewportPicking::changedWithin(const QPolygonF& outline,
                                                                              bool hiddenToo) {
    if (!m_picker || !m_viewport.syncNow()) {
        return {};
    }
    std::vector<glm::vec2> corners;
    for (const QPointF& corner : outline) {
        corners.push_back(toPixels(corner, m_viewport.devicePixelRatioF()));
    }
    m_viewport.surface().makeCurrent();
    auto found = m_picker->changedWithin(
        m_viewport.view(), corners, hiddenToo ? ScenePicker::Depth::Through : ScenePicker::Depth::Visible);
    m_viewport.surface().doneCurrent();
    if (!found) {
        report(found.error());
        return {};
    }
    return std::move(found).value();
}

}  // namespace hitscope
