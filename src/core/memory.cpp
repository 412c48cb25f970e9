// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory.h"

#include <cstdlib>  // says whether this is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace hitscope {

void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int kKept = 256 << 20;   // bytes at the heap's end
    constexpr int kMapped = 32 << 20;  // the most that glibc takes; larger blocks go to the system at once
    constexpr int kStep = 16 << 20;
    mallopt(M_TRIM_THRESHOLD, kKept);
    mallopt(M_MMAP_THRESHOLD, kMapped);
    mallopt(M_TOP_PAD, kStep);
#endif
}

void giveBackFreedMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

}  // namespace hitscope
