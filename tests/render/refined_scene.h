// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <memory>
#include <vector>

#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "open_renderer.h"
#include "render/refined/refined_picture.h"
#include "render_support.h"
#include "support/gl_fixture.h"

namespace hitscope::test {

/// A dented sphere of 12,000 triangles, for tests of refined pictures.
struct RefinedScene {
    GlFixture gl;
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<TestScene> scene;
    std::unique_ptr<DeformationPipeline> pipeline;

    void open() {
        renderer = openRenderer(gl);
        if (!renderer) {
            return;
        }
        std::vector<Hit> hits = dents({1}, 1);
        hits[0].constants = {1.0f, 0.5f, 0.7f};
        scene = std::make_unique<TestScene>();
        scene->add(*renderer, makeUvSphere(96, 64, 2.5f), glm::vec3(0.0f, 2.5f, 0.0f));
        scene->showTrueNormals(hits);
        pipeline = scene->pipeline(PipelineKind::TransformFeedback, hits);
    }
    void close() {
        pipeline.reset();
        scene.reset();
        renderer.reset();
    }
    [[nodiscard]] Frame frame(int width, int height, const DisplayOptions& options) const {
        Frame made = frameOf(*scene, width, height);
        made.camera.zoom(0.8f);
        made.options = options;
        made.meshRevision = 1;
        return made;
    }
    [[nodiscard]] QImage shown(const Frame& frame, RefinedPicture& picture) {
        const ::hitscope::gl::RenderTarget target(frame.width, frame.height, 1);
        if (const Status drawn = renderer->drawRefined(frame, *pipeline, picture, target.framebuffer());
            !drawn) {
            QTest::qFail(drawn.error().message().c_str(), __FILE__, __LINE__);
            return {};
        }
        const Image image = target.read();
        return QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
    }
};

}  // namespace hitscope::test
