// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "core/result.h"
#include "scene/scene_gpu.h"

namespace hitscope {

inline constexpr int kMostSamples = 64;   ///< of a refined picture
inline constexpr int kShownSamples = 16;  ///< of the refined one in a window

/// A picture of a scene, apart from any window.
struct PictureRequest {
    int width = 1280;  ///< pixels
    int height = 720;  ///< pixels
    Camera camera;
    DisplayOptions options;  ///< transparent: what nothing covers is so in the picture
    std::shared_ptr<const SectionLines> section = nullptr;  ///< where options.cut cuts; null: worked out
    // As in SceneGpu::View; what the values wait with is done first.
    ChangeValues* changeValues = nullptr;
    Comparison* comparison = nullptr;
    std::shared_ptr<const SectionLines> otherSection = nullptr;
    /// The colour bar and the notes are written over it, as over the viewport (ChangeOverlay).
    bool labels = false;
    /// With what marks the selected vertices, hit and target, and with the crosshair where options have it.
    bool selectionMarks = false;
    /// How many pictures it is the mean of (render/refined/refined_picture.h), [1, kMostSamples]; 1: it is
    /// drawn once, as two pictures side by side are in any case.
    int samples = 1;
};

/// Pixels of a picture's height that count as one screen full: lines are as wide on a larger one as if the
/// screen had been enlarged.
inline constexpr int kScreenHeight = 1080;

/// Draws it and reads it, with the scene as it is now: waits for all that is on its way. Colours are
/// straight, not premultiplied. Fails, saying what the limit is, where the driver cannot draw that many
/// pixels. The scene's context is current.
[[nodiscard]] Result<Image> drawPicture(SceneGpu& scene, const PictureRequest& request);

/// The same made of the samples that a window shows, which are of the same view and size
/// (SceneGpu::isRefined()).
[[nodiscard]] Result<Image> drawPicture(SceneGpu& scene, const PictureRequest& request, RefinedView& shown);

/// Key of a picture's note with its camera, as parseCamera() takes it.
inline constexpr const char* kCameraNote = "Camera";

/// Key and text of what is saved with a picture of the session: program, renderer, and the active pipeline
/// with what came of trying it there. The scene's context is current.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> pictureNotes(const Session& session);

/// What a window shows, small: `framebuffer` is its OpenGL name, `width` x `height` its pixels. At most
/// `toWidth` pixels wide, in its own shape. A context is current; waits for the GPU.
[[nodiscard]] Image thumbnail(std::uint32_t framebuffer, int width, int height, int toWidth);

}  // namespace hitscope
