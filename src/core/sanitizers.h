// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// HITSCOPE_SANITIZED: built with the sanitizer of addresses or of threads. GCC has a macro for each, clang a
// feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HITSCOPE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HITSCOPE_SANITIZED
#endif
#endif
