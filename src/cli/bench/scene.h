// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cli/bench/random_hits.h"
#include "deform/pipeline_kind.h"
#include "gl/render_target.h"
#include "render/renderer.h"
#include "session/scene_presets.h"
#include "session/session.h"

namespace hitscope::bench {

/// A scene under one pipeline, as one variant of a measurement has it. It looks at all its targets, with the
/// paper's normals. A context is current for every call and the destructor.
class Scene {
public:
    virtual ~Scene() = default;
    Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// Hits that the next frame applies.
    virtual void append(std::span<const Hit> hits) = 0;
    /// A whole frame: hits applied, what they changed read back, the picture drawn, all of it finished.
    [[nodiscard]] virtual Status draw() = 0;
    [[nodiscard]] virtual std::vector<HitTarget> hitTargets() const = 0;
    /// Hits so far that the pipeline no longer keeps.
    [[nodiscard]] virtual std::size_t droppedHits() const = 0;
};

/// A scene as the window has it: a session, followed by SceneGpu. `load` fills the session; `picture`
/// outlives the scene.
[[nodiscard]] Result<std::unique_ptr<Scene>> makeSessionScene(const std::function<void(Session&)>& load,
                                                              PipelineKind pipeline,
                                                              const gl::RenderTarget& picture);

/// What scenes of the same row have in common.
struct RowParts {
    std::vector<TargetPlan> plans;
    std::shared_ptr<const MaterialSet> materials;  ///< of all targets; null: the default one
    DisplayOptions options{.normals = NormalMode::Paper};
};
/// Targets with or without room for a texture.
[[nodiscard]] std::vector<TargetPlan> planRow(const PaperRow& row, bool textured);

/// Who applies hits in a scene.
enum class HitsBy : std::uint8_t {
    Pipeline,
    Paper  ///< PaperFeedback, hit by hit; the pipeline draws what it left in the buffers, and keeps vertices
};

/// The targets straight on pipeline and renderer, without a session: so they can have textures, which a row
/// of the paper's scene has not. `parts`, `renderer` and `picture` outlive the scene. `deformDefines`:
/// as for PaperFeedback.
[[nodiscard]] Result<std::unique_ptr<Scene>> makeEngineScene(const RowParts& parts,
                                                             std::unique_ptr<DeformationPipeline> pipeline,
                                                             Renderer& renderer,
                                                             const gl::RenderTarget& picture, HitsBy by,
                                                             const gl::Defines& deformDefines);

}  // namespace hitscope::bench
