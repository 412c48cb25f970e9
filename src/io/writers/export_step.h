// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/give_up.h"

namespace hitscope {

/// What an export does, in the order in which it comes; not every export does all of it.
enum class ExportStep : std::uint8_t {
    Counting,   ///< how many hits moved each vertex
    Replaying,  ///< the shapes between the original and the deformed one
    Gathering,  ///< what the writer is given
    Reading,    ///< the mesh's own file, of which a copy is made
    Preparing,  ///< what is worked out before the first byte is written
    Writing,
    Checking,   ///< reads what was written
    Comparing,  ///< holds it against what was meant
};
inline constexpr std::size_t kExportSteps = 8;

/// Told what is done now and how much of that, [0, 1]; false gives the export up. May be empty.
using ExportGoOn = std::function<bool(ExportStep step, double share)>;

/// Of one step alone; empty for nobody. `goOn` outlives it.
[[nodiscard]] inline std::function<bool(double)> within(const ExportGoOn& goOn, ExportStep step) {
    return goOn ? std::function<bool(double)>([&goOn, step](double share) { return goOn(step, share); })
                : std::function<bool(double)>();
}

/// Tells how many of so many small parts are done, now and then; throws GivenUp where it is given up.
inline void tellPart(const ExportGoOn& goOn, ExportStep step, std::size_t done, std::size_t all) {
    if (done % kStepsBetweenLooks != 0) {
        return;
    }
    if (goOn && !goOn(step, static_cast<double>(done) / static_cast<double>(all))) {
        throw GivenUp{};
    }
    mayGiveUp();
}

}  // namespace hitscope
