// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces the program's operator new, which std::vector and libraries use: large blocks ask for huge pages,
// where the system gives them on request (transparent_hugepage/enabled is "madvise"). A mesh of 2,000,000
// vertices fills a gigabyte, and page faults of 4 KiB each took a fifth of the time to open it.
#include "core/sanitizers.h"

#ifndef HITSCOPE_SANITIZED  // these have their own

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kLarge = 4 << 20;  // bytes: holds a huge page of 2 MiB wherever it begins

void askForHugePages([[maybe_unused]] void* block, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const std::uintptr_t beforeBlock = reinterpret_cast<std::uintptr_t>(block) % page;  // the allocator's
    // Fails where the system has none: all stays as it is.
    ::madvise(static_cast<char*>(block) - beforeBlock, bytes + beforeBlock, MADV_HUGEPAGE);
#endif
}

}  // namespace

void* operator new(std::size_t bytes) {
    void* block = std::malloc(std::max<std::size_t>(bytes, 1));
    while (block == nullptr) {
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) {
            throw std::bad_alloc();
        }
        handler();
        block = std::malloc(std::max<std::size_t>(bytes, 1));
    }
    if (bytes >= kLarge) {
        askForHugePages(block, bytes);
    }
    return block;
}

void operator delete(void* block) noexcept {
    std::free(block);
}

void operator delete(void* block, std::size_t /*bytes*/) noexcept {
    std::free(block);
}

#endif
