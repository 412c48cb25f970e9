// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "session/session.h"

namespace hitscope {

/// Which hits a person wants to see.
struct HitFilter {
    QString text = {};       ///< part of the hit's number or of the name of its target, pipeline or group
    TargetId target = {};    ///< none: on any
    bool isEnabled = false;  ///< enabled ones only

    bool operator==(const HitFilter&) const = default;
    [[nodiscard]] bool isAll() const { return *this == HitFilter(); }
};

/// The hits of the history in [first, end) that it lets through, ascending.
[[nodiscard]] std::vector<std::uint32_t> acceptedHits(const Session& session, const HitFilter& filter,
                                                      std::uint32_t first, std::uint32_t end);
/// Whether that depends on one of these columns of HitHistoryModel.
[[nodiscard]] bool isFilteredBy(int firstColumn, int lastColumn);

}  // namespace hitscope
