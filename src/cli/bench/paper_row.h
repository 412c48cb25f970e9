// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "cli/bench/bench_room.h"
#include "cli/bench/scene.h"

namespace hitscope::bench {

/// Hits present in every scene of the paper's tables, spread over its targets: as many as its arrays hold.
inline constexpr std::size_t kPaperHits = 600;

/// How rows are measured.
struct RowOptions {
    std::vector<PipelineKind> pipelines;
    int hitEvery = 10;  ///< frames from one hit to the next; 0: none arrive
    std::uint32_t seed = 1;
    Plan plan;
    bool papersWay = false;  ///< transform feedback also with hits applied as the paper does (HitsBy::Paper)
};

/// One variant of a row: a pipeline, with hits arriving or without.
struct RowFigure {
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    HitsBy by = HitsBy::Pipeline;
    int hitEvery = 0;          ///< frames; 0: none arrived
    std::size_t hitsKept = 0;  ///< of kPaperHits
    Samples frames;            ///< seconds a frame; where hits arrive, the mean over hitEvery frames
};

/// The paper's rows, measured one at a time with all variants of a row interleaved. All of them show the same
/// 600 hits. Pipelines that keep few hits (uniform arrays) have them present and no more; the others have a
/// hit every so many frames and, to compare, none. A context is current for every call and the destructor.
class RowBench {
public:
    /// `room` outlives this.
    RowBench(const BenchRoom& room, const RowOptions& options);

    /// The pipelines that cannot run here, and why.
    [[nodiscard]] const std::map<PipelineKind, std::string>& unavailable() const { return m_unavailable; }

    /// `row` indexes paperRows(). materials: null: no texture. `what` is for the progress line.
    [[nodiscard]] Result<std::vector<RowFigure>> measure(int row,
                                                         const std::shared_ptr<const MaterialSet>& materials,
                                                         const QString& what);
    /// Uploads one texture for all targets.
    [[nodiscard]] Result<std::shared_ptr<const MaterialSet>> makeTextures(int size);

private:
    struct Entrant;
    [[nodiscard]] Result<Renderer*> rendererOf(PipelineKind pipeline);
    [[nodiscard]] Result<std::vector<std::unique_ptr<Entrant>>> enter(const RowParts& parts);
    [[nodiscard]] std::vector<RowFigure> figuresOf(PipelineKind kind) const;
    [[nodiscard]] Result<std::unique_ptr<Entrant>> makeEntrant(const RowParts& parts, const RowFigure& figure,
                                                               Renderer& renderer);

    const BenchRoom& m_room;
    RowOptions m_options;
    std::map<PipelineKind, std::string> m_unavailable;
    std::map<PipelineKind, bool> m_keepsFew;
    std::map<PipelineKind, std::unique_ptr<Renderer>> m_renderers;
};

/// The figure of a pipeline with hits arriving, or without; null: not measured. It applies its hits itself.
[[nodiscard]] const RowFigure* findFigure(const std::vector<RowFigure>& figures, PipelineKind pipeline,
                                          bool hitsArrive);
/// The one of hits that arrive and are applied as the paper does; null: not measured.
[[nodiscard]] const RowFigure* findPapersWay(const std::vector<RowFigure>& figures);
/// The one that stands for the pipeline: with hits arriving, where it was measured so.
[[nodiscard]] const RowFigure* findFigure(const std::vector<RowFigure>& figures, PipelineKind pipeline);

}  // namespace hitscope::bench
