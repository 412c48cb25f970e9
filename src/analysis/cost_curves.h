// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/ring.h"
#include "deform/pipeline_kind.h"

namespace hitscope {

/// Costs at one length of the history, or one number of vertices. Seconds, medians.
struct CostPoint {
    double at = 0.0;  ///< hits in the history, or vertices; the mean where several share a point
    std::optional<double> frame = {};  ///< of a frame in which no hit arrives
    std::optional<double> hit = {};    ///< of applying one more
};

/// Which quantity of a CostPoint.
enum class CostOf {
    Frame,         ///< a frame in which no hit arrives
    Hit,           ///< applying one more
    FrameWithHit,  ///< both: a frame in which one hit arrives
};
[[nodiscard]] std::optional<double> costOf(const CostPoint& point, CostOf what);

/// What frames and hits cost against the number of hits in the history or of vertices, pipeline by pipeline.
/// Numbers that differ by an eighth or less share a point, and of each only the latest samples count.
class CostCurves {
public:
    void addFrame(PipelineKind pipeline, std::size_t at, double seconds);
    void addHit(PipelineKind pipeline, std::size_t at, double seconds);
    void clear() { m_curves.clear(); }
    [[nodiscard]] bool isEmpty() const { return m_curves.empty(); }

    /// In the order of their numbers.
    [[nodiscard]] std::vector<CostPoint> points(PipelineKind pipeline) const;

private:
    static constexpr std::size_t kSamples = 31;
    struct Bucket {
        Ring<double> at{kSamples};
        Ring<double> frames{kSamples};   ///< seconds
        Ring<double> applied{kSamples};  ///< seconds
    };
    [[nodiscard]] Bucket& bucket(PipelineKind pipeline, std::size_t at);

    std::map<PipelineKind, std::map<std::size_t, Bucket>> m_curves;
};

/// The number of hits, or vertices, from which on `a` costs more than `b`, the points joined by straight
/// lines; where it does so from the start, the first number that both have. Nothing where `a` does not cost
/// more at the last number that both have.
[[nodiscard]] std::optional<double> crossover(std::span<const CostPoint> a, std::span<const CostPoint> b,
                                              CostOf what);

}  // namespace hitscope
