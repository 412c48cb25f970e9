// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/bringing.h"

#include <QElapsedTimer>
#include <chrono>
#include <cstddef>
#include <exception>
#include <limits>
#include <new>
#include <utility>

#include "gl/context.h"
#include "mesh/mesh_data.h"

namespace hitscope {

namespace {

constexpr std::size_t kBroughtAtOnce = std::size_t{1} << 20;  // bytes between two looks at clock or flag
constexpr qint64 kBringing = 8;                               // milliseconds

}  // namespace

Bringing::Bringing(const MeshData& mesh, std::shared_ptr<const RenderMesh> render, gl::SideContext* side)
    : m_mesh(std::move(render)),
      m_buffers(std::make_unique<TargetBuffers>(*m_mesh, mesh.colours, TargetBuffers::Later{})) {
    if (side == nullptr) {
        return;
    }
    auto done = std::make_shared<std::promise<void>>();  // a std::function can be copied
    m_beside = done->get_future();
    side->start([this, done] {
        try {
            while (!m_stop && !m_buffers->fillMore(kBroughtAtOnce)) {
            }
            if (!m_stop) {
                m_buffers->bringClusterNumbers();
            }
            gl::finish();
            done->set_value();
        } catch (const std::bad_alloc&) {
            done->set_exception(std::current_exception());  // who asks for the buffers gets it
        }
    });
}

Bringing::~Bringing() {
    m_stop = true;
    if (m_beside.valid()) {
        m_beside.wait();
    }
}

bool Bringing::more() {
    if (m_beside.valid()) {
        if (m_beside.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
            return false;
        }
        m_beside.get();
    }
    QElapsedTimer clock;
    clock.start();
    while (!m_buffers->fillMore(kBroughtAtOnce)) {
        if (clock.elapsed() >= kBringing) {
            return false;
        }
    }
    return true;
}

std::unique_ptr<TargetBuffers> Bringing::take() {
    if (m_beside.valid()) {
        m_beside.get();
    }
    m_buffers->fillMore(std::numeric_limits<std::size_t>::max());
    return std::move(m_buffers);
}

}  // namespace hitscope
