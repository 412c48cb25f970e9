// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/hit_effects.h"
#include "io/hit_records.h"

namespace hitscope {

/// The pipeline that was active when the hit was made; nothing: not known.
[[nodiscard]] std::optional<PipelineKind> pipelineOf(const Hit& hit);

/// Hits of a session as a table, in this order; rows out of range are passed over. `effects` may be null.
[[nodiscard]] HitRecords recordsOf(const Session& session, const HitEffects* effects,
                                   std::span<const std::size_t> rows);
/// All of them.
[[nodiscard]] HitRecords recordsOf(const Session& session, const HitEffects* effects);

/// The keys that pipelines have in a table.
[[nodiscard]] std::vector<std::string> pipelineKeys();

/// A file of hits as the window exports them: readHitRecords() of its bytes. The error names it.
[[nodiscard]] Result<HitRecords> readHitFile(const QString& path);
/// As JSON where the name says so, else as CSV; whole or not at all. Of any thread, as the above.
[[nodiscard]] Status writeHitFile(const HitRecords& table, const QString& path);

/// Of a table with hits on one target, of a name that the scene does not have: the name of the scene's only
/// target, to which they go. So hits made on one version of a mesh can be tried on another. Else empty.
[[nodiscard]] QString otherTargetFor(const Session& session, const HitRecords& table);

/// Appends the table's hits, on the targets of the same names or on otherTargetFor(), as one step to undo;
/// its groups become new ones. All or none: the error says which names no target of the scene has, or which
/// hit is on a triangle that its target does not have.
[[nodiscard]] Status appendRecords(Session& session, const HitRecords& table);

}  // namespace hitscope
