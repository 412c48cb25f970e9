// SPDX-License-Identifier: GPL-3.0-or-later
// What others have the viewport's scene and context do: pictures of it, what else is drawn in it, what can be
// told of the renderer, and a wait until all has been read back.
#include <QOpenGLContext>
#include <algorithm>
#include <utility>

#include "pipeline/graphics_report.h"
#include "scene/picture.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr std::size_t kLargeMesh = 50'000;  // vertices: fewer are on the GPU in some milliseconds

}  // namespace

Status Viewport::withScene(const std::function<Status(SceneGpu&)>& work) {
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

bool Viewport::bringMeshes(const ScenePlan& scene) {
    bool isAll = true;
    static_cast<void>(withScene([&](SceneGpu& gpu) -> Status {
        isAll = std::all_of(scene.targets.begin(), scene.targets.end(), [&gpu](const TargetPlan& plan) {
            return plan.shape.render->vertices.size() < kLargeMesh ||
                   gpu.bring(plan.shape.mesh, plan.shape.render);
        });
        return Done{};
    }));
    return isAll;
}

void Viewport::dropUnusedMeshes() {
    static_cast<void>(withScene([](SceneGpu& gpu) -> Status {
        gpu.dropUnusedMeshes();
        return Done{};
    }));
}

Status Viewport::syncNow() {
    Status status = withScene([](SceneGpu& scene) { return scene.sync(); });
    wantPicture();  // normals may have come with it
    return status;
}

PictureRequest Viewport::pictureRequest() const {
    const SceneGpu::View shown = view();
    return {.width = shown.width,
            .height = shown.height,
            .camera = m_navigation.goal(),
            .options = m_options,
            .changeValues = m_changeValues,
            .comparison = m_comparison,
            .otherSection = m_decorations.otherSection(),
            .labels = true};
}

Result<Image> Viewport::drawPicture(const PictureRequest& request) {
    return takePicture([&request](SceneGpu& scene) { return hitscope::drawPicture(scene, request); });
}

Result<Image> Viewport::drawShown() {
    return takePicture([this](SceneGpu& scene) -> Result<Image> {
        if (const Status current = scene.sync(); !current) {
            return current.error();
        }
        RefinedView* const refined = m_refiner.view();
        return refined != nullptr && scene.isRefined(view(), *refined)
                   ? hitscope::drawPicture(scene, pictureRequest(), *refined)
                   : hitscope::drawPicture(scene, pictureRequest());
    });
}

Result<Image> Viewport::takePicture(const std::function<Result<Image>(SceneGpu&)>& draw) {
    Image image;
    Status status = withScene([&](SceneGpu& scene) -> Status {
        Result<Image> drawn = draw(scene);
        if (!drawn) {
            return drawn.error();
        }
        image = std::move(drawn).value();
        return Done{};
    });
    if (!status) {
        return status.error();
    }
    wantPicture();
    return image;
}

QImage Viewport::thumbnail(int width) {
    if (!m_kept.isNull()) {
        return m_kept.scaledToWidth(std::min(width, m_kept.width()), Qt::SmoothTransformation);
    }
    QImage small;
    static_cast<void>(withScene([&](SceneGpu&) -> Status {
        const SceneGpu::View shown = view();
        const Image read = hitscope::thumbnail(m_surface.framebuffer(), shown.width, shown.height, width);
        small = QImage(read.pixels.data(), read.width, read.height, 4 * read.width, QImage::Format_RGBX8888)
                    .copy();
        return Done{};
    }));
    return small;
}

PictureRefiner::Hooks Viewport::refinerHooks() {
    return {.mayRefine =
                [this] {
                    return m_scene && !wantsFrames() && isVisible() && !m_motion.isReduced() &&
                           !m_ahead.isUnderWay();
                },
            .isBehind =
                [this](RefinedView& refined) {
                    bool isBehind = false;
                    static_cast<void>(withScene([&](SceneGpu& scene) -> Status {
                        isBehind = scene.isBehindRefining(refined);
                        return Done{};
                    }));
                    return isBehind;
                },
            .addSample =
                [this](RefinedView& refined) {
                    return withScene([&](SceneGpu& scene) { return scene.refine(view(), refined); });
                },
            .isCoarse = [this] { return m_motion.lastDetail().coarse; },
            .show = [this] { wantPicture(); }};
}

/// What is measured is drawn anew each time, in full.
void Viewport::followQuality() {
    const auto follow = [this] {
        m_refiner.setOn(!m_continuous);
        m_refiner.setWanted(m_options.refine ? kShownSamples : 0);
    };
    if (m_scene) {
        static_cast<void>(withScene([&follow](SceneGpu&) -> Status {
            follow();
            return Done{};
        }));
    } else {
        follow();
    }
    m_motion.setOn(m_options.reduceInMotion && !m_continuous);
    m_ahead.setOn(m_surface.keepsPictures() && !m_continuous);
    // Only software renderers draw in parts, and only one picture.
    m_motion.setRefined(!m_continuous && m_isSoftware && !m_options.sideBySide &&
                        m_refiner.whyNot().isEmpty());
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

}  // namespace hitscope
