// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <functional>
#include <set>

#include "core/memory.h"

namespace hitscope {

struct MeshData;
class Session;

/// Hands memory to the system when a large mesh has left the session, and when all that is worked out of one
/// that has come is there. The C library keeps what is freed inside its heap: without this, 0.6 GB stay after
/// a mesh of 2,000,000 vertices, and 60 MB while it is there.
class FreedMemory : public QObject {
    Q_OBJECT
public:
    static constexpr std::size_t kLarge = 100'000;  ///< vertices
    /// Milliseconds: the mesh's buffers go with the next frame, background work that has it ends later.
    static constexpr int kSoon = 300;
    static constexpr int kLater = 1'500;

    /// `session` outlives this. Calls `giveBack` on a thread of the background pool.
    explicit FreedMemory(Session& session, std::function<void()> giveBack = giveBackFreedMemory,
                         QObject* parent = nullptr);

private:
    void follow();
    void giveBackInTheEnd();
    void giveBack();
    [[nodiscard]] std::set<const MeshData*> largeMeshes() const;

    const Session& m_session;
    std::function<void()> m_giveBack;
    std::set<const MeshData*> m_large;  ///< in the session when it was last looked at
    bool m_isNew = false;               ///< one of them has come since memory was handed back
    QTimer m_soon;
    QTimer m_later;
};

}  // namespace hitscope
