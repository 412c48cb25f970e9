// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/side_thread.h"

#include <QOpenGLContext>
#include <utility>

#include "analysis/background_pool.h"

namespace hitscope {

SideThread::SideThread() : m_context(std::make_unique<QOpenGLContext>()) {}

std::unique_ptr<SideThread> SideThread::create(QOpenGLContext& context) {
    if (!QOpenGLContext::supportsThreadedOpenGL()) {
        return nullptr;
    }
    std::unique_ptr<SideThread> side(new SideThread);
    side->m_context->setFormat(context.format());
    side->m_context->setShareContext(&context);
    side->m_surface.setFormat(context.format());
    side->m_surface.create();  // only the window's thread may
    if (!side->m_context->create() || side->m_context->shareContext() == nullptr ||
        !side->m_surface.isValid()) {
        return nullptr;
    }
    side->m_context->moveToThread(&side->m_thread);
    side->m_there.moveToThread(&side->m_thread);
    side->m_thread.start();
    bool isCurrent = false;
    QMetaObject::invokeMethod(
        &side->m_there,
        [&] {
            giveWay();
            isCurrent = side->m_context->makeCurrent(&side->m_surface);
        },
        Qt::BlockingQueuedConnection);
    return isCurrent ? std::move(side) : nullptr;
}

SideThread::~SideThread() {
    if (!m_thread.isRunning()) {
        return;
    }
    QThread* const here = QThread::currentThread();
    QMetaObject::invokeMethod(
        &m_there,
        [this, here] {
            m_context->doneCurrent();
            m_context->moveToThread(here);
            m_there.moveToThread(here);
        },
        Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
}

void SideThread::start(std::function<void()> job) {
    QMetaObject::invokeMethod(&m_there, std::move(job), Qt::QueuedConnection);
}

}  // namespace hitscope
