// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "usage/invocation.h"
#include "usage/usage.h"

namespace hitscope::cli {

/// A verb of hitscope-cli: what it takes, and what it does. `run` gives the exit status; what it was given
/// wrongly it says by Invocation::complain().
struct Verb {
    Usage usage;
    std::function<int(Invocation&)> run;
    bool needsFonts = false;    ///< it may write text into pictures
    std::vector<Verb> verbs{};  ///< those of `usage.verbs`; where there are some, `run` is none
};

// In the order of help.
[[nodiscard]] Verb infoVerb();
[[nodiscard]] Verb shootVerb();
[[nodiscard]] Verb replayVerb();
[[nodiscard]] Verb verifyVerb();
[[nodiscard]] Verb pictureVerb();
[[nodiscard]] Verb sequenceVerb();
[[nodiscard]] Verb exportVerb();
[[nodiscard]] Verb convertVerb();
[[nodiscard]] Verb compareVerb();
[[nodiscard]] Verb changesVerb();
[[nodiscard]] Verb explainVerb();
[[nodiscard]] Verb dentsVerb();
[[nodiscard]] Verb sectionVerb();
[[nodiscard]] Verb sweepVerb();
[[nodiscard]] Verb collectVerb();
[[nodiscard]] Verb demoVerb();
[[nodiscard]] Verb benchVerb();
[[nodiscard]] Verb helpVerb();

/// All of them.
[[nodiscard]] const std::vector<Verb>& verbs();
/// What hitscope-cli takes, from which help, manual page and completion are made.
[[nodiscard]] const ProgramUsage& programUsage();

}  // namespace hitscope::cli
