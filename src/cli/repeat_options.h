// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/result.h"
#include "session/session.h"
#include "usage/invocation.h"

namespace hitscope::cli {

/// Hits that come after the shots: spread over a target, and mirrored.
struct RepeatWish {
    std::uint32_t scatter = 0;  ///< how many; 0: by density, or none
    double density = 0.0;       ///< per square metre; 0: by number, or none
    double sizeSpread = 0.0;    ///< share by which sizes differ at most, [0, 0.95]
    std::optional<int> mirror;  ///< 0 to 2: along x, y, z

    [[nodiscard]] bool scatters() const { return scatter > 0 || density > 0.0; }
};

/// --scatter, --density, --size-spread and --mirror; --seed is of all shots.
[[nodiscard]] QList<UsageOption> repeatOptions();
[[nodiscard]] RepeatWish givenRepeat(Invocation& given);
/// Spreads hits over the first target as it is read back now; none where that is not wished.
[[nodiscard]] Status scatterHits(Session& session, const RepeatWish& wish, std::uint32_t seed);
/// Repeats all hits on the other side of their target's centre; likewise.
[[nodiscard]] Status mirrorHits(Session& session, const RepeatWish& wish);

}  // namespace hitscope::cli
