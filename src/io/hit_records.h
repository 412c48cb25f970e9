// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "deform/effects.h"
#include "deform/hit.h"

namespace hitscope {

/// Hits apart from a session: targets and pipelines by name.
struct HitRecords {
    std::vector<Hit> hits;
    std::vector<std::size_t> numbers;               ///< one a hit, its place in the history from 1; or empty
    std::map<TargetId, std::string> targets;        ///< names of those that hits are on
    std::vector<std::string> pipelines;             ///< keys, by Hit::pipeline
    std::vector<std::optional<HitEffect>> effects;  ///< one a hit, or empty; written, never read
};

/// A header and a line a hit, fields as RFC 4180 has them; numbers have a point, and as many digits as bring
/// the same bits back.
[[nodiscard]] std::string toCsv(const HitRecords& table);
/// An object with an array "hits" of objects, one a line; numbers likewise, but that readers of JSON take the
/// sign from a zero.
[[nodiscard]] std::string toJson(const HitRecords& table);

/// Either of them, told by its first character: '{' or '[' begin JSON. Strict: the error names the line (in
/// JSON the line where the hit begins) for whatever is not known, missing, repeated, not finite or out of
/// range; hits have passed checkedHit(). `pipelines` are the keys there are. In the result targets are
/// numbered from 1 as they first occur.
[[nodiscard]] Result<HitRecords> readHitRecords(std::string_view bytes, std::vector<std::string> pipelines);

inline constexpr std::size_t kMostRecordBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMostRecordHits = 1'000'000;

}  // namespace hitscope
