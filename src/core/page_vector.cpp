// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/page_vector.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <map>
#include <mutex>
#endif

namespace hitscope::pages {

#ifdef __linux__

namespace {

constexpr std::size_t kLarge = std::size_t{1} << 20;  // bytes: copying less takes less than a millisecond

/// The files in memory, by where they are mapped.
struct Files {
    std::mutex mutex;
    std::map<const void*, int> descriptors;
};

Files& files() {
    static auto* const all = new Files;  // never destroyed: vectors may last longer
    return *all;
}

void* mapped(int descriptor, std::size_t bytes, int flags) {
    void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, flags, descriptor, 0);
    return memory == MAP_FAILED ? nullptr : memory;
}

}  // namespace

void* allocate(std::size_t bytes) {
    if (bytes < kLarge) {
        return nullptr;
    }
    const int descriptor = ::memfd_create("hitscope", MFD_CLOEXEC);
    if (descriptor < 0) {
        return nullptr;
    }
    void* memory = nullptr;
    if (::ftruncate(descriptor, static_cast<off_t>(bytes)) == 0) {
        memory = mapped(descriptor, bytes, MAP_SHARED);
    }
    if (memory == nullptr) {
        ::close(descriptor);
        return nullptr;
    }
    const std::lock_guard lock(files().mutex);
    files().descriptors.emplace(memory, descriptor);
    return memory;
}

bool deallocate(void* memory, std::size_t bytes) noexcept {
    if (bytes < kLarge) {
        return false;
    }
    int descriptor = -1;
    {
        const std::lock_guard lock(files().mutex);
        const auto file = files().descriptors.find(memory);
        if (file == files().descriptors.end()) {
            return false;
        }
        descriptor = file->second;
        files().descriptors.erase(file);
    }
    ::munmap(memory, bytes);
    ::close(descriptor);  // copies keep the file
    return true;
}

void* copyOf(const void* memory, std::size_t bytes) {
    if (bytes < kLarge) {
        return nullptr;
    }
    const std::lock_guard lock(files().mutex);
    const auto file = files().descriptors.find(memory);
    return file != files().descriptors.end() ? mapped(file->second, bytes, MAP_PRIVATE) : nullptr;
}

void dropCopy(void* memory, std::size_t bytes) noexcept {
    ::munmap(memory, bytes);
}

#else

void* allocate(std::size_t /*bytes*/) {
    return nullptr;
}

bool deallocate(void* /*memory*/, std::size_t /*bytes*/) noexcept {
    return false;
}

void* copyOf(const void* /*memory*/, std::size_t /*bytes*/) {
    return nullptr;
}

void dropCopy(void* /*memory*/, std::size_t /*bytes*/) noexcept {}

#endif

}  // namespace hitscope::pages
