// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/render_target.h"
#include "scene/picture.h"
#include "scene/refined_view.h"

namespace hitscope {

/// drawPicture() a sample at a time, for who has something else to do in between. A context is current for
/// every call and the destructor.
class PictureDrawing {
public:
    /// `scene` and what the request points to outlive this.
    PictureDrawing(SceneGpu& scene, const PictureRequest& request);

    /// Draws one more sample. True: all are there. Where the scene has changed since the one before it begins
    /// anew, and the third time waits no more in between. Errors are drawPicture()'s.
    [[nodiscard]] Result<bool> step();
    /// After step() has said that all is there, once.
    [[nodiscard]] Result<Image> take();
    /// Instead of steps: with the samples that a window shows, of the same view and size.
    [[nodiscard]] Result<Image> takeOf(RefinedView& shown);

private:
    [[nodiscard]] Status begin();
    [[nodiscard]] Result<Image> draw(RefinedView& refined);
    [[nodiscard]] Status refine();

    SceneGpu& m_scene;
    PictureRequest m_request;
    SceneGpu::View m_view;
    RefinedView m_refined;
    bool m_begun = false;
};

}  // namespace hitscope
