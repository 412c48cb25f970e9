// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: whatever bytes the import worker hands over, they are refused with a message, or are a mesh that
// is whole and the same when it is handed over again; and whatever line it says is understood or left.
#include <QBuffer>
#include <QTemporaryFile>
#include <cstdint>
#include <cstdlib>

#include "io/mesh_stream.h"
#include "io/worker_protocol.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hitscope;
    constexpr std::uint64_t kMemory = 64 << 20;
    QByteArray bytes(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
    (void)parseWorkerLine(bytes);
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    const Result<MeshData> read = readMeshStream(buffer, {}, nullptr, kMemory);
    if (!read) {
        if (read.error().what.empty()) {
            std::abort();
        }
        return 0;
    }
    static QTemporaryFile file;
    if (!validate(read.value()).ok() || !file.open() || !file.resize(0)) {
        std::abort();
    }
    if (!writeMeshStream(read.value(), file) || !file.flush() || !file.seek(0) || file.readAll() != bytes) {
        std::abort();
    }
    file.close();
    return 0;
}
