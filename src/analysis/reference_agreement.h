// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "session/session.h"

namespace hitscope {

/// How what the active pipeline made agrees with the reference deformation.
struct ReferenceAgreement {
    std::size_t vertices = 0;         ///< of the files of all targets
    std::size_t different = 0;        ///< of them, those whose position differs in any bit
    std::size_t differentNormal = 0;  ///< and those whose position is equal and the paper's normal is not
    double largest = 0.0;             ///< metres, between positions; infinite where one is not finite
    [[nodiscard]] bool isExact() const { return different + differentNormal == 0; }
};

enum class ReferenceMethod : std::uint8_t {
    Clusters,   ///< ReferenceDeformation, which goes to the clusters that a hit can reach
    Everywhere  ///< deformEverywhere(): every hit at every vertex, whatever it takes
};

/// Compares the session's read-back (SceneGpu::sync() has just been called) with what the reference makes of
/// the same hits: those that SessionHits::isApplied(). The pipeline of the reference is that same code: it is
/// worth comparing with ReferenceMethod::Everywhere only.
[[nodiscard]] ReferenceAgreement agreementWithReference(const Session& session, ReferenceMethod method);

/// hitsFingerprint() of the whole history, whatever the pipeline keeps or is shown of it.
[[nodiscard]] std::uint64_t hitsFingerprint(const Session& session);
/// positionsFingerprint() of all targets, hidden ones included; of the read-back, likewise.
[[nodiscard]] std::uint64_t positionsFingerprint(const Session& session);

}  // namespace hitscope
