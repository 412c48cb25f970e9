// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace hitscope {

/// An open file of the system's, closed at the end.
class Descriptor {
public:
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] bool isOpen() const { return m_number >= 0; }
    [[nodiscard]] int get() const { return m_number; }

private:
    int m_number;
};

/// All of it; false with errno where it fails.
[[nodiscard]] bool writeAll(int descriptor, const char* data, std::size_t size);

/// Exactly `size` bytes from `offset` on; false where there are fewer, or it fails.
[[nodiscard]] bool readAt(int descriptor, std::uint64_t offset, char* data, std::size_t size);

/// Appends bytes [offset, offset + size) of one file to another, within the kernel where it can; false with
/// errno where it fails, EIO if there are fewer.
[[nodiscard]] bool copyRange(int from, std::uint64_t offset, std::uint64_t size, int to);

/// Lets the system write a file's bytes [offset, offset + size) to the disk while more are made, so that the
/// sync at the end need not wait for all of it. Does nothing where there is no such thing.
void startToWrite(int descriptor, std::uint64_t offset, std::uint64_t size);
/// Waits until the disk has these bytes; a sync is needed all the same.
void waitUntilWritten(int descriptor, std::uint64_t offset, std::uint64_t size);

}  // namespace hitscope
