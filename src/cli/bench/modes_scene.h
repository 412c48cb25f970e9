// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "analysis/change_values.h"
#include "analysis/comparison.h"
#include "cli/bench/bench_room.h"
#include "cli/bench/painted_row.h"
#include "cli/bench/view_modes.h"
#include "scene/scene_gpu.h"
#include "scene/scene_picker.h"

namespace hitscope::bench {

/// A row of the paper's tables, dented, looked at in one mode after the other. A context is current for every
/// call and the destructor.
class ModesScene {
public:
    /// `picture` outlives the scene.
    explicit ModesScene(const gl::RenderTarget& picture);
    ~ModesScene();
    ModesScene(const ModesScene&) = delete;
    ModesScene& operator=(const ModesScene&) = delete;

    /// 0 <= row < paperRows().size().
    [[nodiscard]] Status open(int row, PipelineKind pipeline, std::uint32_t seed);
    /// Draws until nothing is on its way.
    [[nodiscard]] Status prepare(const ViewMode& mode);
    /// A frame as the window draws it, finished.
    [[nodiscard]] Status draw();
    [[nodiscard]] qulonglong vertices() const;

    /// A mode to be measured among others.
    [[nodiscard]] Variant variant(const ViewMode& mode);

private:
    void look(ViewMode::Place place);
    void select(bool on);
    void preview(bool on);

    const gl::RenderTarget& m_picture;
    Session m_session;
    ChangeValues m_values;
    Comparison m_comparison;
    std::unique_ptr<SceneGpu> m_gpu;
    std::unique_ptr<ScenePicker> m_picker;
    std::vector<Hit> m_hits;
    MetalCoat m_metal;
    SceneGpu::View m_view;
    const ViewMode* m_mode = nullptr;
};

/// 6 high-poly cubes, 10 high-poly spheres: the row with the most vertices to look at.
inline constexpr int kFullestRow = 6;

/// A frame in this mode over a plainly shaded one from the same place: the fullest row, transform feedback.
[[nodiscard]] Result<TimeRatio> modeCost(const BenchRoom& room, const Plan& plan, const ViewMode& mode);

}  // namespace hitscope::bench
