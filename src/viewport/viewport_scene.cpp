// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport_scene.h"

#include <QOpenGLContext>
#include <algorithm>
#include <utility>

#include "gl/context.h"
#include "pipeline/graphics_report.h"
#include "viewport/surface/picture_surface.h"
#include "viewport/surface/side_thread.h"

namespace hitscope {

namespace {

constexpr std::size_t kLargeMesh = 50'000;  // vertices: fewer are on the GPU in some milliseconds

}  // namespace

ViewportScene::ViewportScene(Session& session, PictureSurface& surface)
    : m_session(session), m_surface(surface) {}

ViewportScene::~ViewportScene() = default;

Status ViewportScene::make() {
    // The context may go when the widget is moved to another window, and takes all GL objects with it.
    connect(m_surface.context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewportScene::release,
            Qt::DirectConnection);
    const gl::RendererInfo info = gl::rendererInfo();
    m_rendererName = QString::fromStdString(info.renderer);
    m_rendererVersion = QString::fromStdString(info.version);
    m_isSoftware = info.isSoftware();
    Result<std::unique_ptr<SceneGpu>> scene = SceneGpu::create(m_session);
    if (scene) {
        m_scene = std::move(scene).value();
        m_scene->setAppliesBetweenPictures(m_isSoftware);
        if (m_isSoftware) {  // it clears whole buffers at once; not every GPU's driver bears two threads
            m_scene->bringBeside([this] { return SideThread::create(*m_surface.context()); });
        }
    }
    Q_EMIT made();
    return scene ? Status(Done{}) : Status(scene.error());
}

void ViewportScene::release() {
    if (m_surface.context() != nullptr) {
        disconnect(m_surface.context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewportScene::release);
    }
    if (m_scene) {
        m_surface.makeCurrent();
        Q_EMIT aboutToRelease();
        m_scene.reset();
        m_surface.doneCurrent();
    }
}

Status ViewportScene::with(const std::function<Status(SceneGpu&)>& work) {
    if (!m_scene) {
        return Error{"There is no picture: nothing can be drawn here.", "",
                     "Start Hitscope where OpenGL 3.3 is available."};
    }
    // The context may be current already: while it is being given back, or in the middle of a frame.
    const bool current = QOpenGLContext::currentContext() == m_surface.context();
    if (!current) {
        m_surface.makeCurrent();
    }
    Status status = work(*m_scene);
    if (!current) {
        m_surface.doneCurrent();
    }
    return status;
}

bool ViewportScene::bringMeshes(const ScenePlan& scene) {
    bool isAll = true;
    static_cast<void>(with([&](SceneGpu& gpu) -> Status {
        isAll = std::all_of(scene.targets.begin(), scene.targets.end(), [&gpu](const TargetPlan& plan) {
            return plan.shape.render->vertices.size() < kLargeMesh ||
                   gpu.bring(plan.shape.mesh, plan.shape.render);
        });
        return Done{};
    }));
    return isAll;
}

void ViewportScene::dropUnusedMeshes() {
    static_cast<void>(with([](SceneGpu& gpu) -> Status {
        gpu.dropUnusedMeshes();
        return Done{};
    }));
}

Result<QString> ViewportScene::graphicsReport() {
    QString text;
    const Status asked = with([this, &text](SceneGpu& scene) -> Status {
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

}  // namespace hitscope
