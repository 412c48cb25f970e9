// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "analysis/reference_agreement.h"
#include "cli/command_line.h"
#include "cli/json_report.h"
#include "scene/scene_gpu.h"
#include "session/export/export_target.h"

namespace hitscope::cli {

/// The pipeline's own error, or that this driver cannot run it.
[[nodiscard]] Status usePipeline(Session& session, SceneGpu& gpu, PipelineKind kind);

/// Likewise the pipeline that was asked for; nothing: the usual one, or, where that is not exact on this
/// renderer, one that is. Says on the standard error what is not exact, and what is used.
[[nodiscard]] Status useAskedPipeline(Session& session, SceneGpu& gpu, std::optional<PipelineKind> asked);

/// How the active pipeline agrees with the reference, to the last bit; the reference itself is held against
/// every hit at every vertex. Nothing: it is the reference, and that would take too long. SceneGpu::sync()
/// has just been called.
[[nodiscard]] std::optional<ReferenceAgreement> agreementOfActive(const Session& session);

/// "Transform feedback: as the reference in every bit". Says too how many hits the pipeline keeps, if not
/// all.
[[nodiscard]] QString agreementLine(const Session& session,
                                    const std::optional<ReferenceAgreement>& agreement);

/// exportTarget(), in the format that the suffix says, OBJ for an unknown one. Notes go to the standard
/// error.
[[nodiscard]] Status exportNamed(const Session& session, const Target& target, const QString& path,
                                 NormalMode normals);

/// An error that says by how much what was written to `path` is not what the reference makes of the hits.
[[nodiscard]] Outcome exportAgrees(const Session& session, const std::optional<ReferenceAgreement>& agreement,
                                   const QString& path);

/// "5 shots, 4 hits"; "1 shot, 0 hits; 5 hits in all", where the session has others than those of these
/// shots; "0 shots, 5 hits". `shotHits`: of these shots.
[[nodiscard]] QString shotsAndHits(std::size_t shots, std::size_t shotHits, const Session& session);

/// Two lines: of the hits, and of the positions as the active pipeline made them.
[[nodiscard]] QString fingerprintLines(const Session& session);

// The same for programs: "pipeline", "dropped_hits", "agreement"; "hits_fingerprint",
// "positions_fingerprint"; "targets", with what hits did to each.
void addAgreement(JsonReport& report, const Session& session,
                  const std::optional<ReferenceAgreement>& agreement);
void addFingerprints(JsonReport& report, const Session& session);
void addTargets(JsonReport& report, const Session& session);

/// The target whose hits changed most vertices; the first, if none changed any. There is one at least.
[[nodiscard]] const Target& mostChangedTarget(const Session& session);

}  // namespace hitscope::cli
