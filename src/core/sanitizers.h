// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// HITSCOPE_ADDRESS_SANITIZER: built with the sanitizer of addresses. GCC has a macro for it, clang a feature.
#if defined(__SANITIZE_ADDRESS__)
#define HITSCOPE_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HITSCOPE_ADDRESS_SANITIZER
#endif
#endif
