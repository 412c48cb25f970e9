// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <functional>

#include "view/display_options.h"

class QAction;
class QMenu;

namespace hitscope {

class ShadingActions;
class TextureChooser;
class Viewport;

/// How surfaces are drawn, and when: wireframe, shading, normals, textures, floor, crosshair, continuously.
class DisplayActions : public QObject {
    Q_OBJECT
public:
    /// Both outlive this.
    DisplayActions(Viewport& viewport, TextureChooser& textures, QObject* parent = nullptr);

    /// `fillMiddle` adds what stands between the targets' looks and the floor. Once.
    void fill(QMenu& menu, const std::function<void(QMenu&)>& fillMiddle);
    void fillEnd(QMenu& menu);  ///< once; drawing without a cause
    [[nodiscard]] QAction* continuous() const { return m_continuous; }
    [[nodiscard]] QMenu* wireframeMenu() const { return m_wireframeMenu; }
    void cycleWireframe();

    /// Somebody else has set the viewport's options.
    void follow();

Q_SIGNALS:
    void normalsChanged();  ///< other ones are on the screen

private:
    void makeWireframeMenu(QMenu& menu);
    void makeNormalsMenu(QMenu& menu);
    void makeMaterialMenu(QMenu& menu);
    void change(const std::function<void(DisplayOptions&)>& how);

    Viewport& m_viewport;
    TextureChooser& m_textureChooser;
    ShadingActions* m_shading = nullptr;
    QMenu* m_wireframeMenu = nullptr;
    std::array<QAction*, 3> m_wireframes{};         ///< by WireframeMode
    std::array<QAction*, 2> m_normals{};            ///< by NormalMode
    std::array<QAction*, kSurfaceLooks> m_looks{};  ///< by SurfaceLook
    QAction* m_textures = nullptr;
    QAction* m_floor = nullptr;
    QAction* m_crosshair = nullptr;
    QAction* m_continuous = nullptr;
};

}  // namespace hitscope
