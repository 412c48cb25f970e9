// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bench/bench_room.h"
#include "cli/bench/scene.h"

namespace hitscope::bench {

/// Which scene stands still while its history grows.
struct StillScene {
    std::function<void(Session&)> load;
    double vertices = 0.0;  ///< render vertices, all targets together
};
/// A row of the paper's scene; `row` indexes paperRows().
[[nodiscard]] StillScene paperRowScene(int row);
/// One sphere with about so many vertices. Making it takes seconds for millions.
[[nodiscard]] StillScene sphereScene(int vertices);
/// Memory that making it takes for each vertex, bytes.
inline constexpr double kSphereSceneBytes = 500.0;
/// Memory for each vertex and length of the history, bytes: a session, its copies of the vertices, and its
/// buffers. Measured with 1,000,000 vertices, and a little more.
inline constexpr double kHistorySceneBytes = 400.0;

struct HistoryOptions {
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    std::vector<int> hits;  ///< lengths of the history, each a variant
    bool gentle = false;    ///< hits too weak to be seen: the picture is the same in all variants
    std::uint32_t seed = 1;
    Plan plan;
    bool besideForm = false;  ///< each length also with a last hit of another form than the paper's
};

/// A history of one length.
struct HistoryFigure {
    int hits = 0;
    bool besideForm = false;  ///< the last of them has another form than the paper's
    std::size_t kept = 0;     ///< of them, by the pipeline
    Samples frames;           ///< seconds a frame
};

/// Frame times with histories of different lengths, interleaved; nothing moves meanwhile. `what` is for the
/// progress line.
[[nodiscard]] Result<std::vector<HistoryFigure>> measureHistories(const BenchRoom& room,
                                                                  const StillScene& scene,
                                                                  const HistoryOptions& options,
                                                                  const QString& what);

}  // namespace hitscope::bench
