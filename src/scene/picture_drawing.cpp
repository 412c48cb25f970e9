// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture_drawing.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cstdint>
#include <string>

#include "analysis/change_values.h"
#include "analysis/scene_section.h"
#include "render/refined/refined_picture.h"
#include "scene/change_overlay.h"
#include "view/camera_text.h"

namespace hitscope {

namespace {

constexpr int kEdgeSamples = 4;                          // of a pixel, where the picture is drawn once
constexpr std::int64_t kMostSmoothPixels = 40'000'000;   // with kEdgeSamples these take 1.3 GB
constexpr std::int64_t kMostRefinedPixels = 40'000'000;  // the sum and its parts: about as much
constexpr std::int64_t kMostPixels = 150'000'000;        // with one sample about as much
constexpr int kMostRestarts = 3;
static_assert(kMostSamples == RefinedPicture::kMostSamples && kShownSamples == RefinedPicture::kUsualSamples);

std::string sizeText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

std::int64_t pixelsOf(const PictureRequest& request) {
    return std::int64_t{request.width} * request.height;
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
    if (pixelsOf(request) > kMostPixels) {
        return Error{"A picture of " + size + " pixels takes too much memory.", "",
                     "Choose one of up to " + std::to_string(kMostPixels / 1'000'000) + " million pixels."};
    }
    if (request.samples > 1 && pixelsOf(request) > kMostRefinedPixels) {
        return Error{"A picture of " + size + " pixels takes too much memory with more than one sample.", "",
                     "Choose one of up to " + std::to_string(kMostRefinedPixels / 1'000'000) +
                         " million pixels, or one sample."};
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

PictureDrawing::PictureDrawing(SceneGpu& scene, const PictureRequest& request)
    : m_scene(scene), m_request(request) {
    m_request.samples = std::clamp(request.samples, 1, kMostSamples);
}

Status PictureDrawing::begin() {
    if (Status possible = checkSize(m_request); !possible) {
        return possible;
    }
    if (Status current = m_scene.sync(); !current) {
        return current;
    }
    if (m_request.changeValues != nullptr) {
        m_request.changeValues->finish();
    }
    m_view.width = m_request.width;
    m_view.height = m_request.height;
    m_view.pixelRatio = std::max(1.0f, static_cast<float>(m_request.height) / kScreenHeight);
    m_view.camera = m_request.camera;
    m_view.options = m_request.options;
    m_view.section = m_request.section ? m_request.section
                                       : sectionLines(m_scene.session(), m_request.options.cut,
                                                      m_request.options.beforeAfter.exaggeration);
    m_view.otherSection = m_request.otherSection;
    m_view.changeValues = m_request.changeValues;
    m_view.comparison = m_request.comparison;
    m_view.selectionMarks = m_request.selectionMarks;
    m_view.options.crosshair = m_view.options.crosshair && m_request.selectionMarks;
    m_begun = true;
    return Done{};
}

Result<bool> PictureDrawing::step() {
    if (!m_begun || m_refined.restarts() >= kMostRestarts) {
        if (Status begun = begin(); !begun) {
            return begun.error();
        }
    }
    if (m_request.samples == 1) {
        return true;
    }
    do {
        if (Status drawn = m_scene.refine(m_view, m_refined); !drawn) {
            return drawn.error();
        }
    } while (m_refined.restarts() >= kMostRestarts && m_refined.isPossible() &&
             m_refined.samples() < m_request.samples);
    return !m_refined.isPossible() || m_refined.samples() >= m_request.samples;
}

Result<Image> PictureDrawing::take() {
    return draw(m_refined);
}

Result<Image> PictureDrawing::takeOf(RefinedView& shown) {
    const Status begun = begin();
    return begun ? draw(shown) : Result<Image>(begun.error());
}

Result<Image> PictureDrawing::draw(RefinedView& refined) {
    const bool isRefined = refined.samples() > 0;
    const bool smooth = !isRefined && pixelsOf(m_request) <= kMostSmoothPixels;
    const gl::RenderTarget target(m_request.width, m_request.height, smooth ? kEdgeSamples : 1);
    if (!target.isComplete()) {
        return Error{"The graphics driver has no room for a picture of " +
                         sizeText(m_request.width, m_request.height) + " pixels.",
                     "", "Choose a smaller size."};
    }
    if (Status drawn = isRefined ? m_scene.drawRefined(m_view, refined, target.framebuffer())
                                 : m_scene.draw(m_view, target.framebuffer());
        !drawn) {
        return drawn.error();
    }
    Image image = target.read();
    if (m_request.options.transparent) {
        makeStraight(image);
    }
    if (m_request.labels && ChangeOverlay::isNeeded(m_view)) {
        writeLabels(image, m_view);
    }
    image.notes = pictureNotes(m_scene.session());
    image.notes.emplace_back(kCameraNote, cameraText(m_request.camera));
    if (isRefined) {
        image.notes.emplace_back("Samples", std::to_string(refined.samples()));
    }
    return image;
}

}  // namespace hitscope
