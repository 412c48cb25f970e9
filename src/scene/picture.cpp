// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture.h"

#include <algorithm>
#include <cstdint>

#include "gl/context.h"
#include "gl/shrunk.h"
#include "scene/picture_drawing.h"

namespace hitscope {

Result<Image> drawPicture(SceneGpu& scene, const PictureRequest& request) {
    PictureDrawing drawing(scene, request);
    while (true) {
        const Result<bool> done = drawing.step();
        if (!done) {
            return done.error();
        }
        if (done.value()) {
            return drawing.take();
        }
    }
}

Result<Image> drawPicture(SceneGpu& scene, const PictureRequest& request, RefinedView& shown) {
    return PictureDrawing(scene, request).takeOf(shown);
}

std::vector<std::pair<std::string, std::string>> pictureNotes(const Session& session) {
    const gl::RendererInfo info = gl::rendererInfo();
    return {{"Software", "Hitscope " HITSCOPE_VERSION},
            {"Renderer", info.renderer + ", OpenGL " + info.version},
            {"Pipeline", describe(session.readBack().verdict(), session.settings().pipeline())}};
}

Image thumbnail(std::uint32_t framebuffer, int width, int height, int toWidth) {
    const int small = std::clamp(toWidth, 1, width);
    const int high = static_cast<int>(static_cast<std::int64_t>(small) * height / width);
    return gl::shrunk(framebuffer, width, height, small, std::max(high, 1));
}

}  // namespace hitscope
