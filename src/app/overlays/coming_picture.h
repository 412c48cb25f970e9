// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include "view/camera.h"

namespace hitscope {

class SceneFiles;
class Viewport;
struct MeshData;

/// Shows a large mesh that is being opened over the viewport, drawn coarsely and as it is going to be seen,
/// from when it is read until it can be drawn. Takes the clicks meanwhile: what is below is about to go.
class ComingPicture : public QWidget {
    Q_OBJECT
public:
    /// Both outlive this.
    ComingPicture(SceneFiles& files, Viewport& over);

    /// Meshes of fewer faces are there before a picture would be.
    static constexpr std::size_t kLeastFaces = 200'000;

    /// How to draw coarsely what a viewport is going to frame. Copied to the thread that draws.
    struct Look {
        Camera camera;                       ///< its angles and field of view
        QSize size;                          ///< pixels of the viewport
        glm::vec3 light{0.0f, -1.0f, 0.0f};  ///< the way it travels, world
    };
    /// On any thread. Null: the mesh is small, or there is no viewport to speak of.
    [[nodiscard]] static QImage draw(const MeshData& mesh, const Look& look);
    [[nodiscard]] Look look() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void showPicture(const QImage& picture);
    void hideAfterFrame();

    Viewport& m_viewport;
    QImage m_picture;
};

}  // namespace hitscope
