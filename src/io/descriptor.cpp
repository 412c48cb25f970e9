// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <vector>

namespace hitscope {

Descriptor::~Descriptor() {
    if (m_number >= 0) {
        ::close(m_number);
    }
}

bool writeAll(int descriptor, const char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t written = ::write(descriptor, data, size);
        if (written < 0 && errno != EINTR) {
            return false;
        }
        data += std::max<ssize_t>(written, 0);
        size -= static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
    return true;
}

bool readAt(int descriptor, std::uint64_t offset, char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t got = ::pread(descriptor, data, size, static_cast<off_t>(offset));
        if (got == 0 || (got < 0 && errno != EINTR)) {
            errno = got == 0 ? EIO : errno;
            return false;
        }
        const auto bytes = static_cast<std::size_t>(std::max<ssize_t>(got, 0));
        data += bytes;
        offset += bytes;
        size -= bytes;
    }
    return true;
}

bool copyRange(int from, std::uint64_t offset, std::uint64_t size, int to) {
    constexpr std::uint64_t kPiece = 64 << 20;
    while (size > 0) {
        auto position = static_cast<off_t>(offset);
        const ssize_t copied = ::copy_file_range(from, &position, to, nullptr,
                                                 static_cast<std::size_t>(std::min(size, kPiece)), 0);
        if (copied <= 0) {
            break;  // between these file systems it cannot; the rest goes through this process
        }
        offset += static_cast<std::uint64_t>(copied);
        size -= static_cast<std::uint64_t>(copied);
    }
    std::vector<char> piece(static_cast<std::size_t>(std::min<std::uint64_t>(size, 1 << 20)));
    while (size > 0) {
        const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(size, piece.size()));
        if (!readAt(from, offset, piece.data(), part) || !writeAll(to, piece.data(), part)) {
            return false;
        }
        offset += part;
        size -= part;
    }
    return true;
}

void waitUntilWritten(int descriptor, std::uint64_t offset, std::uint64_t size) {
    const int before = errno;
    static_cast<void>(
        ::sync_file_range(descriptor, static_cast<off64_t>(offset), static_cast<off64_t>(size),
                          SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER));
    errno = before;
}

void startToWrite(int descriptor, std::uint64_t offset, std::uint64_t size) {
    const int before = errno;
    // What goes wrong is told by the sync.
    static_cast<void>(::sync_file_range(descriptor, static_cast<off64_t>(offset), static_cast<off64_t>(size),
                                        SYNC_FILE_RANGE_WRITE));
    errno = before;
}

}  // namespace hitscope
