// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// HITSCOPE_ADDRESS_SANITIZER: built with the sanitizer of addresses; HITSCOPE_SANITIZED: with this one or
// that of threads. GCC has a macro for each, clang a feature.
#if defined(__SANITIZE_ADDRESS__)
#define HITSCOPE_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HITSCOPE_ADDRESS_SANITIZER
#endif
#endif

#if defined(HITSCOPE_ADDRESS_SANITIZER) || defined(__SANITIZE_THREAD__)
#define HITSCOPE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define HITSCOPE_SANITIZED
#endif
#endif
