// SPDX-License-Identifier: GPL-3.0-or-later
// What the viewport shows where: the questions its tools ask.
#include <vector>

#include "analysis/hit_at.h"
#include "pipeline/graphics_report.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

glm::vec2 toPixels(const QPointF& position, qreal ratio) {
    return {static_cast<float>(position.x() * ratio), static_cast<float>(position.y() * ratio)};
}

}  // namespace

/// Once: whoever moves the cursor asks again and again.
void Viewport::reportPicking(const Error& error) {
    if (error.message() != m_pickingError) {
        m_pickingError = error.message();
        QMetaObject::invokeMethod(
            this, [this, error] { Q_EMIT failed(error); }, Qt::QueuedConnection);
    }
}

std::optional<VertexRef> Viewport::vertexAt(const QPointF& position) {
    if (!m_picker || !syncNow()) {
        return std::nullopt;
    }
    makeCurrent();
    const auto picked = m_picker->pick(view(), toPixels(position, devicePixelRatioF()));
    doneCurrent();
    if (!picked) {
        reportPicking(picked.error());
        return std::nullopt;
    }
    return picked.value();
}

bool Viewport::requestVertexAt(const QPointF& position) {
    if (!m_picker) {
        return false;
    }
    makeCurrent();
    const Status asked = m_picker->request(view(), toPixels(position, devicePixelRatioF()));
    doneCurrent();
    if (!asked) {
        reportPicking(asked.error());
    }
    return asked.ok();
}

std::optional<std::optional<VertexRef>> Viewport::requestedVertex() {
    if (!m_picker || !m_picker->isPending()) {
        return std::optional<VertexRef>();  // the context went meanwhile, and the question with it
    }
    makeCurrent();
    const auto arrived = m_picker->arrived();
    doneCurrent();
    return arrived;
}

std::map<TargetId, std::vector<std::uint32_t>> Viewport::changedWithin(const QPolygonF& outline,
                                                                       bool hiddenToo) {
    if (!m_picker || !syncNow()) {
        return {};
    }
    std::vector<glm::vec2> corners;
    for (const QPointF& corner : outline) {
        corners.push_back(toPixels(corner, devicePixelRatioF()));
    }
    makeCurrent();
    auto found = m_picker->changedWithin(
        view(), corners, hiddenToo ? ScenePicker::Depth::Through : ScenePicker::Depth::Visible);
    doneCurrent();
    if (!found) {
        reportPicking(found.error());
        return {};
    }
    return std::move(found).value();
}

Result<QString> Viewport::graphicsReport() {
    QString text;
    const Status asked = withScene([this, &text](SceneGpu& scene) -> Status {
        while (scene.tryNext()) {
        }
        const auto why = [this](PipelineKind kind) {
            return m_session.readBack().whyUnavailable(kind).toStdString();
        };
        text = QString::fromStdString(toText(
            hitscope::graphicsReport(m_session.readBack().exactness(), m_session.readBack().verdict(), why)));
        return Done{};
    });
    if (!asked) {
        return asked.error();
    }
    return text;
}

void Viewport::lookAt(const VertexRef& vertex) {
    if (const Target* target = m_session.targets().find(vertex.target)) {
        m_navigation.recentre(target->transform.toWorld(target->deformed.positions()[vertex.vertex]));
        update();
    }
}

void Viewport::selectHitAt(const std::optional<VertexRef>& vertex) {
    m_session.hits().select(vertex ? hitThatMovedMost(m_session, *vertex) : std::nullopt);
}

void Viewport::selectTargetOf(const VertexRef& vertex) {
    if (m_session.targets().size() > 1) {
        m_session.targets().select(vertex.target);
    }
}

}  // namespace hitscope
