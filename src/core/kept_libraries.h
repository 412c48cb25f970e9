// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Included once by each program that has a window. Under a sanitizer, plug-ins and graphics drivers stay
// loaded to the end: what they keep is then no leak, and the thread sanitizer ends a program (exit status 66)
// where a library goes whose locks it was told to pass over.
#include "core/sanitizers.h"

#ifdef HITSCOPE_SANITIZED
extern "C" int dlclose(void* library);
extern "C" int dlclose(void* /*library*/) {
    return 0;
}
#endif
