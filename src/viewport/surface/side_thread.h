// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QOffscreenSurface>
#include <QThread>
#include <memory>

#include "gl/side_context.h"

class QOpenGLContext;

namespace hitscope {

/// A side context of one of Qt's.
class SideThread : public gl::SideContext {
public:
    /// Beside `context`, which is current. Null where the platform or the driver has no GL on other threads.
    [[nodiscard]] static std::unique_ptr<SideThread> create(QOpenGLContext& context);
    ~SideThread() override;
    SideThread(const SideThread&) = delete;
    SideThread& operator=(const SideThread&) = delete;
    void start(std::function<void()> job) override;

private:
    SideThread();

    QOffscreenSurface m_surface;
    std::unique_ptr<QOpenGLContext> m_context;
    QObject m_there;  // on the thread
    QThread m_thread;
};

}  // namespace hitscope
