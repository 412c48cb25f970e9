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

bool ViewportPicking::isAsked(const std::function<Status()>& ask) {
    const Status asked = m_viewport.scene().with([&ask](SceneGpu&) { return ask(); });
    if (!asked) {
        report(asked.error());
    }
    return asked.ok();
}

std::optional<VertexRef> ViewportPicking::vertexAt(const QPointF& position) {
    std::optional<VertexRef> vertex;
    if (m_picker && m_viewport.syncNow()) {
        isAsked([&]() -> Status {
            auto picked =
                m_picker->pick(m_viewport.view(), toPixels(position, m_viewport.devicePixelRatioF()));
            if (!picked) {
                return picked.error();
            }
            vertex = picked.value();
            return Done{};
        });
    }
    return vertex;
}

bool ViewportPicking::requestVertexAt(const QPointF& position) {
    return m_picker && isAsked([&] {
               return m_picker->request(m_viewport.view(),
                                        toPixels(position, m_viewport.devicePixelRatioF()));
           });
}

std::optional<std::optional<VertexRef>> ViewportPicking::requestedVertex() {
    std::optional<std::optional<VertexRef>> vertex = std::optional<VertexRef>();
    if (m_picker && m_picker->isPending()) {  // else the context went meanwhile, and the question with it
        isAsked([&]() -> Status {
            vertex = m_picker->arrived();
            return Done{};
        });
    }
    return vertex;
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
    const auto depth = hiddenToo ? ScenePicker::Depth::Through : ScenePicker::Depth::Visible;
    std::map<TargetId, std::vector<std::uint32_t>> changed;
    isAsked([&]() -> Status {
        auto found = m_picker->changedWithin(m_viewport.view(), corners, depth);
        if (!found) {
            return found.error();
        }
        changed = std::move(found).value();
        return Done{};
    });
    return changed;
}

}  // namespace hitscope
