// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cstdint>
#include <string>

#include "analysis/change_values.h"
#include "analysis/scene_section.h"
#include "gl/context.h"
#include "gl/render_target.h"
#include "gl/shrunk.h"
#include "scene/change_overlay.h"

namespace hitscope {

namespace {

constexpr int kSamples = 4;
constexpr std::int64_t kMostSmoothPixels = 40'000'000;  // with kSamples samples these take 1.3 GB
constexpr std::int64_t kMostPixels = 150'000'000;       // with one sample about as much

std::string sizeText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

Status checkSize(const PictureRequest& request) {
    const std::string size = sizeText(request.width, request.height);
    if (request.width < 1 || request.height < 1) {
        return Error{"A picture of " + size + " pixels has none.", "", "Choose a size of at least 1 x 1."};
    }
    const int longest = gl::RenderTarget::longestSide();
    if (request.width > longest || request.height > longest) {
        return Error{"This graphics driver draws pictures of up to " + sizeText(longest, longest) +
                         " pixels, not " + size + ".",
                     "", "Choose a smaller size."};
    }
    if (std::int64_t{request.width} * request.height > kMostPixels) {
        return Error{"A picture of " + size + " pixels takes too much memory.", "",
                     "Choose one of up to " + std::to_string(kMostPixels / 1'000'000) + " million pixels."};
    }
    return Done{};
}

void makeStraight(Image& image) {
    constexpr int kOpaque = 255;
    for (std::size_t at = 0; at + 3 < image.pixels.size(); at += 4) {
        const int opacity = image.pixels[at + 3];
        for (std::size_t channel = at; opacity > 0 && opacity < kOpaque && channel < at + 3; ++channel) {
            const int straight = (image.pixels[channel] * kOpaque + opacity / 2) / opacity;
            image.pixels[channel] = static_cast<std::uint8_t>(std::min(straight, kOpaque));
        }
    }
}

void writeLabels(Image& image, const SceneGpu::View& view) {
    QImage pixels(image.pixels.data(), image.width, image.height, 4 * qsizetype{image.width},
                  QImage::Format_RGBA8888);
    pixels.setDevicePixelRatio(static_cast<double>(view.pixelRatio));
    QPainter painter(&pixels);
    ChangeOverlay().paint(painter, view);
}

}  // namespace

Result<Image> drawPicture(SceneGpu& scene, const PictureRequest& request) {
    if (Status possible = checkSize(request); !possible) {
        return possible.error();
    }
    if (Status current = scene.sync(); !current) {
        return current.error();
    }
    if (request.changeValues != nullptr) {
        request.changeValues->finish();
    }
    const bool smooth = std::int64_t{request.width} * request.height <= kMostSmoothPixels;
    const gl::RenderTarget target(request.width, request.height, smooth ? kSamples : 1);
    if (!target.isComplete()) {
        return Error{"The graphics driver has no room for a picture of " +
                         sizeText(request.width, request.height) + " pixels.",
                     "", "Choose a smaller size."};
    }
    SceneGpu::View view;
    view.width = request.width;
    view.height = request.height;
    view.pixelRatio = std::max(1.0f, static_cast<float>(request.height) / kScreenHeight);
    view.camera = request.camera;
    view.options = request.options;
    view.section = request.section ? request.section
                                   : sectionLines(scene.session(), request.options.cut,
                                                  request.options.beforeAfter.exaggeration);
    view.otherSection = request.otherSection;
    view.changeValues = request.changeValues;
    view.comparison = request.comparison;
    view.selectionMarks = request.selectionMarks;
    view.options.crosshair = view.options.crosshair && request.selectionMarks;
    if (Status drawn = scene.draw(view, target.framebuffer()); !drawn) {
        return drawn.error();
    }
    Image image = target.read();
    if (request.options.transparent) {
        makeStraight(image);
    }
    if (request.labels && ChangeOverlay::isNeeded(view)) {
        writeLabels(image, view);
    }
    image.notes = pictureNotes(scene.session());
    return image;
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
