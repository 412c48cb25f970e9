// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result.h"

namespace hitscope {

std::string Error::message() const {
    std::string text;
    if (!where.empty()) {
        text += where + ": ";
    }
    text += what;
    if (!advice.empty()) {
        text += " " + advice;
    }
    return text;
}

}  // namespace hitscope
