// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "cli/bench/bench_room.h"
#include "cli/bench/random_hits.h"

namespace hitscope::bench {

struct HitOptions {
    std::vector<PipelineKind> pipelines;
    std::vector<int> hitsAFrame{1};
    double affected = 80.0;  ///< vertices a hit is to reach
    bool readBack = true;    ///< measure with what changed read back as well
    /// The last hit of each frame has another form than the paper's.
    bool besideForm = false;
    bool yardsticks = true;  ///< measure the paper's own way and memcpy as well
    std::uint32_t seed = 1;
};

/// What was measured on one mesh.
struct HitFigure {
    enum class Method : std::uint8_t {
        Pipeline,      ///< append(), until the GPU is done
        WithReadBack,  ///< and what changed read back, frame after frame as in the window, until all is there
        PaperFeedback,  ///< the paper's own way, see paper_feedback.h
        Copy            ///< memcpy of the affected vertices' bytes: nothing that moves them can be faster
    };
    Method method = Method::Pipeline;
    PipelineKind pipeline = PipelineKind::TransformFeedback;  ///< of the first two
    int hitsAFrame = 1;
    double affected = 0.0;  ///< vertices a hit moved, counted; the mean over a sample's hits
    Samples hits;           ///< seconds a hit
};

/// A sphere of one size, hit in all ways; hits as in constantsReaching(), all over it. Before each sample it
/// is whole again. A context is current for every call and the destructor.
class HitSizeBench {
public:
    /// About so many vertices. The error says why it cannot be: memory, or the driver.
    [[nodiscard]] static Result<std::unique_ptr<HitSizeBench>> create(const BenchRoom& room, int vertices,
                                                                      const HitOptions& options);
    ~HitSizeBench();
    HitSizeBench(const HitSizeBench&) = delete;
    HitSizeBench& operator=(const HitSizeBench&) = delete;

    [[nodiscard]] std::size_t vertexCount() const;  ///< of the buffers
    [[nodiscard]] const DeformationConstants& constants() const;
    /// Pipelines that cannot run here, with the reason.
    [[nodiscard]] const QStringList& notes() const;

    /// To be measured, alone or with those of other sizes; they are of this object.
    [[nodiscard]] std::vector<Variant> variants();
    /// `samples` is what they gave, in their order.
    [[nodiscard]] std::vector<HitFigure> figures(std::span<const Samples> samples) const;
    /// Whether something that hits changed is not on the CPU yet.
    [[nodiscard]] bool isReadBackPending() const;

private:
    HitSizeBench();
    struct Private;
    std::unique_ptr<Private> d;
};

/// Null: not measured. Pipeline and hits a frame count where the method has them.
[[nodiscard]] const HitFigure* findFigure(const std::vector<HitFigure>& figures, HitFigure::Method method,
                                          PipelineKind pipeline = PipelineKind::TransformFeedback,
                                          int hitsAFrame = 1);

}  // namespace hitscope::bench
