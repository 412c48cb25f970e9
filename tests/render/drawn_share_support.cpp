// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_share_support.h"

#include <QTest>

#include "gl/context.h"
#include "gl/objects.h"
#include "gl/render_target.h"
#include "secretive_pipeline.h"
#include "support/baseline.h"

namespace hitscope::test {

int blendedLevels() {
    return gl::rendererInfo().renderer.find("softpipe") != std::string::npos ? 1 : 0;
}

Drawn drawCounted(Renderer& renderer, const Frame& frame, DeformationPipeline& pipeline, int samples) {
    const gl::RenderTarget target(frame.left + frame.width, frame.height, samples);
    const gl::Query query = gl::Query::make();
    glBeginQuery(GL_PRIMITIVES_GENERATED, query.id());
    const Status status = renderer.draw(frame, pipeline, target.framebuffer());
    glEndQuery(GL_PRIMITIVES_GENERATED);
    if (!status) {
        QTest::qFail(status.error().message().c_str(), __FILE__, __LINE__);
        return {};
    }
    Drawn drawn;
    glGetQueryObjectuiv(query.id(), GL_QUERY_RESULT, &drawn.primitives);
    const Image image = target.read();
    const QRect own(frame.left, 0, frame.width, frame.height);
    drawn.picture = QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy(own);
    return drawn;
}

double drawnShare(Renderer& renderer, const Frame& frame, DeformationPipeline& pipeline, int samples) {
    Secretive secretive(pipeline);
    const Drawn all = drawCounted(renderer, frame, secretive, samples);
    const Drawn some = drawCounted(renderer, frame, pipeline, samples);
    if (differing(some.picture, all.picture, blendedLevels()) > 0) {
        return -1.0;
    }
    return all.primitives > 0 ? static_cast<double>(some.primitives) / static_cast<double>(all.primitives)
                              : 0.5;
}

}  // namespace hitscope::test
