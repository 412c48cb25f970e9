// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/picking_support.h"

#include <QTest>
#include <glm/geometric.hpp>
#include <limits>

#include "scene/screen_space.h"
#include "session/primitive_target.h"
#include "session/shots/demo_shots.h"

namespace hitscope::test {

namespace {

/// Möller and Trumbore, in double. The distance along the ray; nothing: it passes by.
std::optional<double> meets(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a,
                            const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 e1 = b - a;
    const glm::dvec3 e2 = c - a;
    const glm::dvec3 p = glm::cross(direction, e2);
    const double det = glm::dot(e1, p);
    if (det == 0.0) {
        return std::nullopt;
    }
    const glm::dvec3 s = (origin - a) / det;
    const double u = glm::dot(s, p);
    const double v = glm::dot(glm::cross(s, e1), direction);
    const double t = glm::dot(glm::cross(s, e1), e2);
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? std::optional(t) : std::nullopt;
}

struct Met {
    const Target* target = nullptr;
    std::size_t triangle = 0;
    double distance = std::numeric_limits<double>::infinity();
};

Met castRay(const Session& session, const Ray& ray, const Shown& shown = {}, const CuttingPlane& cut = {}) {
    Met nearest;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const glm::dquat back = glm::conjugate(glm::dquat(target->transform.rotation));
        const glm::dvec3 origin = back * (glm::dvec3(ray.origin) - glm::dvec3(target->transform.position));
        const glm::dvec3 direction = back * glm::dvec3(ray.direction);
        const RenderMesh& mesh = target->deformed.render();
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            const auto met = meets(origin, direction, shown.placeOf(*target, mesh.triangles[i]),
                                   shown.placeOf(*target, mesh.triangles[i + 1]),
                                   shown.placeOf(*target, mesh.triangles[i + 2]));
            if (met && *met < nearest.distance &&
                !cut.hides(ray.origin + static_cast<float>(*met) * ray.direction)) {
                nearest = {target.get(), i / 3, *met};
            }
        }
    }
    return nearest;
}

std::optional<VertexRef> cornerNearest(const SceneGpu::View& view, const Met& met, const glm::vec2& at,
                                       const Shown& shown) {
    if (met.target == nullptr) {
        return std::nullopt;
    }
    const ScreenSpace screen(view, met.target->transform);
    const RenderMesh& mesh = met.target->deformed.render();
    std::optional<VertexRef> nearest;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = mesh.triangles[3 * met.triangle + corner];
        const glm::vec3 place = shown.placeOf(*met.target, vertex);
        const auto point = screen.project(place);
        if (point && glm::distance(point->at, at) < least &&
            !view.options.cut.hides(met.target->transform.toWorld(place))) {
            least = glm::distance(point->at, at);
            nearest = VertexRef{met.target->id, mesh.fileVertices[vertex]};
        }
    }
    return nearest;
}

Ray rayAt(const SceneGpu::View& view, const glm::vec2& at) {
    const glm::vec2 size(static_cast<float>(view.width), static_cast<float>(view.height));
    return view.camera.rayThrough({2.0f * at.x / size.x - 1.0f, 1.0f - 2.0f * at.y / size.y},
                                  size.x / size.y);
}

}  // namespace

glm::vec3 Shown::placeOf(const Target& target, std::uint32_t renderVertex) const {
    const std::uint32_t vertex = target.deformed.render().fileVertices[renderVertex];
    const glm::vec3 was = target.deformed.original().positions[vertex];
    return original ? was : was + factor * target.deformed.displacement(vertex);
}

void PickedScene::start() {
    Result<std::unique_ptr<gl::OffscreenContext>> made = gl::OffscreenContext::create();
    QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
    m_context = std::move(made).value();
    gl::collectDebugMessages();
}

void PickedScene::close() {
    m_picker.reset();
    m_gpu.reset();
    m_session.reset();
    const std::vector<std::string> errors = gl::takeErrors();
    QVERIFY2(errors.empty(), errors.empty() ? "" : errors.front().c_str());
}

void PickedScene::open(PipelineKind kind) {
    m_session = std::make_unique<Session>();
    ScenePlan plan;
    plan.targets.push_back(planPrimitive({PrimitiveKind::UvSphere, 64, 5.0f}));
    plan.targets.push_back(planPrimitive({PrimitiveKind::Torus, 48, 5.0f}));
    plan.targets.push_back(planPrimitive({PrimitiveKind::Cube, 24, 5.0f}));
    plan.targets[1].transform.position = {3.5f, 0.5f, -3.0f};
    plan.targets[1].transform.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    plan.targets[2].transform.position = {-4.5f, 0.0f, 1.0f};
    m_session->loadScene(std::move(plan));
    m_session->settings().setPipeline(kind);
    auto made = SceneGpu::create(*m_session);
    QVERIFY(made.ok());
    m_gpu = std::move(made).value();
    m_picker = std::make_unique<ScenePicker>(*m_session, *m_gpu);
    shootAll(*m_session, demoShots(*m_session, 120, 11));
    QVERIFY(m_session->hits().history().size() > 30);
    QVERIFY(m_gpu->sync().ok());
}

SceneGpu::View PickedScene::viewOf(float ratio) const {
    SceneGpu::View view;
    view.width = static_cast<int>(640 * ratio);
    view.height = static_cast<int>(480 * ratio);
    view.pixelRatio = ratio;
    const Bounds bounds = m_session->targets().bounds();
    view.camera.setSceneRadius(bounds.diagonal());
    view.camera.frame(bounds, 640.0f / 480.0f);
    view.camera.zoom(0.5f);
    return view;
}

/// The rasterizer rounds corners to a fraction of a pixel: rays a little beside the pixel's middle count.
bool PickedScene::isSeenAt(SceneGpu::View view, glm::vec2 at, const std::optional<VertexRef>& picked) const {
    if (view.options.sideBySide) {
        view.width /= 2;
        at.x -= at.x < static_cast<float>(view.width) ? 0.0f : static_cast<float>(view.width);
    }
    const BeforeAfterOptions& options = view.options.beforeAfter;
    const Shown shown{options.wipe && at.x < options.wipeAt * static_cast<float>(view.width),
                      options.exaggeration};
    const glm::vec2 middle = glm::floor(at) + 0.5f;
    for (const glm::vec2& off : {glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(-1.0f, 0.0f),
                                 glm::vec2(0.0f, 1.0f), glm::vec2(0.0f, -1.0f)}) {
        const Met met = castRay(*m_session, rayAt(view, middle + off / 128.0f), shown, view.options.cut);
        if (cornerNearest(view, met, at, shown) == picked) {
            return true;
        }
    }
    return false;
}

bool PickedScene::isInView(const SceneGpu::View& view, const VertexRef& vertex) const {
    const Target& target = *m_session->targets().find(vertex.target);
    const glm::vec3 world = target.transform.toWorld(target.deformed.positions()[vertex.vertex]);
    const glm::vec3 eye = view.camera.eye();
    const double distance = static_cast<double>(glm::distance(world, eye));
    if (view.options.cut.hides(world)) {
        return false;
    }
    const Met met = castRay(*m_session, {eye, glm::normalize(world - eye)}, {}, view.options.cut);
    return met.distance > distance * (1.0 - 2.0e-3);
}

}  // namespace hitscope::test
