// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QThread>
#include <atomic>
#include <memory>
#include <optional>

#include "core/result.h"
#include "io/nameless_file.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// Reads the import worker's answer back and checks it, in a thread, since large meshes take a moment. It
/// shares nothing with who started it: where nobody wants the mesh any more, it is left to itself.
class TakeOver : public QThread {
    Q_OBJECT
public:
    TakeOver(std::shared_ptr<NamelessFile> answer, std::uint64_t memoryBytes)
        : m_answer(std::move(answer)), m_memoryBytes(memoryBytes) {}

    void cancel() { m_stop = true; }
    /// Once, after finished().
    [[nodiscard]] Result<MeshData> take() { return std::move(*m_taken); }

Q_SIGNALS:
    void progressed(double fraction, const char* doing);

protected:
    void run() override;

private:
    std::shared_ptr<NamelessFile> m_answer;
    std::uint64_t m_memoryBytes;
    std::atomic_bool m_stop = false;
    std::optional<Result<MeshData>> m_taken;
};

}  // namespace hitscope
