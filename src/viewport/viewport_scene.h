// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

#include "scene/scene_gpu.h"

namespace hitscope {

class PictureSurface;

/// A session on the GPU, in the OpenGL context of what shows a viewport's pictures: comes and goes with that
/// context.
class ViewportScene : public QObject {
    Q_OBJECT
public:
    /// Both outlive it; nothing is asked of the surface yet.
    ViewportScene(Session& session, PictureSurface& surface);
    ~ViewportScene() override;

    /// The surface has a context, perhaps another one than before; it is current. Fails where nothing can be
    /// drawn in it.
    [[nodiscard]] Status make();
    /// Gives up all GL objects.
    void release();
    [[nodiscard]] bool exists() const { return m_scene != nullptr; }
    /// Null while there is none. Its functions need the context to be current: see with().
    [[nodiscard]] const SceneGpu* get() const { return m_scene.get(); }
    /// Does something with it while its context is current; fails when there is none.
    [[nodiscard]] Status with(const std::function<Status(SceneGpu&)>& work);

    /// Has some of the large meshes of a scene brought to the GPU before the session gets it: called in turns
    /// of the event loop until it returns true.
    bool bringMeshes(const ScenePlan& scene);
    void dropUnusedMeshes();  ///< gives up those that the session has not got

    /// "llvmpipe (LLVM 15.0.6, 256 bits)"; empty before the first context.
    [[nodiscard]] const QString& rendererName() const { return m_rendererName; }
    [[nodiscard]] const QString& rendererVersion() const { return m_rendererVersion; }
    /// Whether the CPU draws.
    [[nodiscard]] bool isSoftware() const { return m_isSoftware; }
    /// hitscope::graphicsReport() as text, with what the session knows; fails when there is no GL.
    [[nodiscard]] Result<QString> graphicsReport();

Q_SIGNALS:
    /// There is a context, and its renderer is known; exists() says whether it can be drawn in. The context
    /// is current.
    void made();
    /// The context goes, and with it all GL objects; it is current. The scene is built anew from the session
    /// when there is another.
    void aboutToRelease();

private:
    Session& m_session;
    PictureSurface& m_surface;
    std::unique_ptr<SceneGpu> m_scene;
    QString m_rendererName;
    QString m_rendererVersion;
    bool m_isSoftware = false;
};

}  // namespace hitscope
