// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <functional>

class QOpenGLContext;
class QPaintDevice;
class QWidget;

namespace hitscope {

/// What shows a viewport's pictures: a widget that fills the viewport below all that lies over the picture,
/// and leaves all input to it. Has the OpenGL context that the pictures are drawn in.
class PictureSurface {
public:
    struct Hooks {
        std::function<void()> made;  ///< there is a context, perhaps another one than before; it is current
        std::function<void()> resized;  ///< to the size of the widget; the context is current
        /// Draws a picture into the framebuffer object of that name; the context is current.
        std::function<void(unsigned framebuffer)> draw;
        /// Where pictures are kept in memory: the one to show, null where there is none. byWindow: its
        /// window paints itself, and may show one of before; else somebody grabs what there is now.
        std::function<QImage(bool byWindow)> kept;
        std::function<void(QPaintDevice& picture)> paintOver;  ///< what lies over the picture, as part of it
        std::function<void()> shown;                           ///< the window has painted itself
    };

    virtual ~PictureSurface() = default;

    [[nodiscard]] virtual QWidget& widget() = 0;
    /// Null before the widget was visible.
    [[nodiscard]] virtual QOpenGLContext* context() const = 0;
    virtual void makeCurrent() = 0;
    virtual void doneCurrent() = 0;
    /// The picture as it is now, drawn for that.
    [[nodiscard]] virtual QImage grab() = 0;
    /// Whether pictures are kept in memory; else they are in framebuffer().
    [[nodiscard]] virtual bool keepsPictures() const = 0;
    /// The OpenGL name of the framebuffer object that pictures are drawn into; 0 where there is none.
    [[nodiscard]] virtual unsigned framebuffer() const = 0;
    /// Shows at once that there is another picture in memory; false where its window does not show it now.
    virtual bool showNow() { return false; }

protected:
    PictureSurface() = default;
    PictureSurface(const PictureSurface&) = default;
    PictureSurface& operator=(const PictureSurface&) = default;
};

/// A child of `viewport`, which owns it: a QOpenGLWidget where a GPU draws (ComposedSurface) or kComposes is
/// set, else RasterSurface. Asks the driver once (isDrawnByCpu()).
[[nodiscard]] PictureSurface& makePictureSurface(QWidget& viewport, PictureSurface::Hooks hooks);

}  // namespace hitscope
