// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <span>
#include <vector>

#include "analysis/cost_curves.h"
#include "session/frame_costs.h"

namespace hitscope {

/// One line a frame under a line of names; times in milliseconds, empty where they are not known.
[[nodiscard]] QByteArray framesCsv(std::span<const FrameCost> frames);

struct NamedCurve {
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    std::vector<CostPoint> points;
};
/// What curves are drawn against.
enum class CostAxis : std::uint8_t { Hits, Vertices };
/// One line a point: pipeline, hits in the history or vertices, milliseconds of a frame and of a hit.
[[nodiscard]] QByteArray curvesCsv(std::span<const NamedCurve> curves, CostAxis axis);

}  // namespace hitscope
