// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Included by the main file of a program with a window. It ends without its graphics driver, which has been
// unloaded by then: of what the driver leaks the sanitizer can no longer tell whose it is. The tests look for
// leaks in the same code, with the driver loaded.
#include "core/sanitizers.h"

#ifdef HITSCOPE_ADDRESS_SANITIZER
extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() {
    return 1;
}
#endif
