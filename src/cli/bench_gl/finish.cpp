// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench_gl/finish.h"

#include <epoxy/gl.h>

namespace hitscope::bench {

void finishGpu() {
    glFinish();
}

}  // namespace hitscope::bench
