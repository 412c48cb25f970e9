// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/exactness.h"

#include "core/grouped.h"

namespace hitscope {

std::string describe(const Exactness& exactness) {
    if (!exactness.isExact()) {
        return "not bit-exact: " + describe(exactness.compared);
    }
    std::string text = "bit-exact in " + grouped(exactness.compared.vertices) + " vertices compared";
    if (exactness.byFma) {
        text += ", with division and square root corrected";
    }
    return text;
}

}  // namespace hitscope
