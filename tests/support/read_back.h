// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/session.h"

namespace hitscope::test {

struct ReadBackInTests {
    static ReadBack& of(Session& session) { return session.readBack(ReadBackAccess()); }
};

/// To report what a renderer would.
inline ReadBack& readBackOf(Session& session) {
    return ReadBackInTests::of(session);
}

}  // namespace hitscope::test
