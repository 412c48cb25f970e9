// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/take_over.h"

#include "io/mesh_stream.h"

namespace hitscope {

void TakeOver::run() {
    const ProgressSink progress = [this](double fraction, const char* doing) {
        Q_EMIT progressed(fraction, doing);
    };
    m_taken.emplace(readMeshStream(m_answer->path(), progress, &m_stop, m_memoryBytes));
    if (m_stop) {
        m_taken.reset();
    }
    m_answer->close();
}

}  // namespace hitscope
