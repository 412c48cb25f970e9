// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "core/ids.h"
#include "core/result.h"
#include "mesh/mesh_data.h"
#include "pipeline/deformation_pipeline.h"
#include "pipeline/target_buffers.h"
#include "render/changed_parts.h"
#include "render/pixel_area.h"
#include "render/vertex_marks.h"
#include "view/camera.h"
#include "view/display_options.h"
#include "view/lights.h"

namespace hitscope {

/// A target's materials and textures on the GPU. A context is current for the destructor.
class MaterialSet;
/// See refined_picture.h.
class RefinedPicture;

/// One target to draw.
struct DrawItem {
    TargetId target;
    const TargetBuffers* buffers = nullptr;
    const MaterialSet* materials = nullptr;  ///< null: the default material
    glm::mat4 model{1.0f};                   ///< rigid
    bool selected = false;
    /// Where it is not as it was; null: anywhere.
    const ChangedParts* changedParts = nullptr;
    bool original = false;  ///< drawn as it was, whatever the pipeline
    /// ClusterReach::moment() at which the shading normals followed all that has moved; 0: not known.
    std::uint64_t settled = 0;
    /// Where its vertices were then, or later; none: not known.
    std::span<const DynamicVertex> vertices{};
};

/// The triangles of a target that a frame draws: the coarse ones where it may and there are any.
[[nodiscard]] inline std::span<const DrawRange> drawsOf(const DrawItem& item, bool coarse) {
    const std::span<const DrawRange> few = item.buffers->coarseDraws();
    return coarse && !few.empty() ? few : item.buffers->draws();
}

/// One projectile to draw. World, metres.
struct ProjectileItem {
    Sphere sphere;
    glm::vec3 colour{1.0f};            ///< sRGB
    std::span<const glm::vec3> trail;  ///< where it came by, oldest first
};

/// One picture, in full.
struct Frame {
    int left = 0;             ///< pixels, where in the framebuffer the picture starts
    int width = 0;            ///< pixels
    int height = 0;           ///< pixels
    float pixelRatio = 1.0f;  ///< device pixels a logical pixel: line widths, crosshair
    Camera camera;
    Lights lights;
    DisplayOptions options;
    float floorHeight = 0.0f;           ///< metres, world y
    std::optional<ShownChange> change;  ///< the colour map that surfaces have; nothing: they are shaded
    /// Another number when a mesh has changed; 0: any may have. Shadows are kept as long as it is the same.
    std::uint64_t meshRevision = 0;
    /// Large targets have fewer triangles: see RenderMesh::coarseTriangles.
    bool coarse = false;
    std::span<const DrawItem> targets;
    std::span<const ProjectileItem> projectiles;
    bool projectilesFly = false;         ///< a kept picture does not have them: they are drawn over it
    std::span<const VertexMarks> marks;  ///< drawn in this order
    /// Corners of triangles, world: a surface that is not there yet, drawn over everything. Null: none.
    std::shared_ptr<const std::vector<glm::vec3>> ghost;
    std::shared_ptr<const SectionLines> section;  ///< where options.cut cuts; null: nothing to draw there
    bool showsCutPlane = false;                   ///< the plane too, as a pane: it is being moved
    std::optional<Sphere>
        highlightedHit;  ///< world: a selected hit's point and max_distance; drawn as a ring
};

/// What of a kept picture is drawn again where vertices have moved since.
struct PicturePatch {
    PixelArea area;                ///< where they and their shadows were and are
    std::vector<PixelArea> parts;  ///< of it, where just these are; they do not overlap
    /// Where a refined picture differs, for soft shadows and occlusion reach farther; nothing: anywhere.
    std::optional<PixelArea> refined;
    bool isCoarse = false;  ///< as Frame::coarse
};

/// Draws frames by the paper's equations 5-14. Knows buffers and cameras, not sessions.
class Renderer {
public:
    /// A context is current. The error names the shader that does not build.
    [[nodiscard]] static Result<std::unique_ptr<Renderer>> create();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    [[nodiscard]] std::shared_ptr<const MaterialSet> makeMaterials(const MeshData& mesh);
    /// One material for everything, with this texture.
    [[nodiscard]] std::shared_ptr<const MaterialSet> makeCover(const Image& texture);
    /// Does a part of what a picture of this frame would do first and keep: makes room for its shadows, draws
    /// them. Errors are draw()'s.
    [[nodiscard]] Status prepare(const Frame& frame, DeformationPipeline& pipeline);
    /// Whether nothing of that is left.
    [[nodiscard]] bool isPrepared(const Frame& frame, const DeformationPipeline& pipeline);
    /// Builds one of the programs that this frame needs, or that projectiles and a ghost of a dent in the
    /// next frames will need. Draws a pixel into that framebuffer. Returns whether all are built; otherwise
    /// call it again.
    [[nodiscard]] bool warmUp(const Frame& frame, DeformationPipeline& pipeline, GLuint framebuffer);
    /// Programs are built for the pipeline when it first draws; the error is the driver's.
    [[nodiscard]] Status draw(const Frame& frame, DeformationPipeline& pipeline, GLuint framebuffer);
    /// Whether the last draw() put coarse shapes in the picture.
    [[nodiscard]] bool wasCoarse() const;

    /// Adds a sample to a picture of this frame, of the same one until the picture is cleared; or what has to
    /// be known before the first one; or of either, or of its buffers, the next part, where a software
    /// renderer would take long: picture.samples() tells. The frame starts at the framebuffer's left. The
    /// error says what the driver lacks.
    [[nodiscard]] Status refine(const Frame& frame, DeformationPipeline& pipeline, RefinedPicture& picture);
    /// Draws into `picture` what draw() would draw of the scene: drawRefined() then shows it, and refine()
    /// need not draw it. Where the driver has no room, or makes it first, the picture has nothing.
    [[nodiscard]] Status drawPlain(const Frame& frame, DeformationPipeline& pipeline,
                                   RefinedPicture& picture);
    /// What of `picture`, which is plain or refined, is drawn again so that it is of this frame: it is of the
    /// same one but for where vertices are. Nothing: the frame is better drawn anew.
    /// isHurried: the patch is coarse where it has many triangles.
    [[nodiscard]] std::optional<PicturePatch> patchFor(const Frame& frame,
                                                       const DeformationPipeline& pipeline,
                                                       const RefinedPicture& picture, bool isHurried);
    /// Draws it: the picture is plain then, without samples, and without projectiles that fly. What is coarse
    /// is left to refine(), which begins with that. frame.coarse: as the patch.
    [[nodiscard]] Status patch(const Frame& frame, DeformationPipeline& pipeline, RefinedPicture& picture,
                               const PicturePatch& patch);
    /// Whether refine() would first wait for what it was called for before.
    [[nodiscard]] bool isBehindRefining(const RefinedPicture& picture) const;
    /// As draw(), but of the scene what `picture` has; hasPicture() holds. What marks the scene is drawn
    /// anew: it may be other than it was. Fewer than `fewest` samples, 1 or more, are not shown.
    [[nodiscard]] Status drawRefined(const Frame& frame, DeformationPipeline& pipeline,
                                     RefinedPicture& picture, GLuint framebuffer, int fewest = 1);
    /// Whether that would draw what picture.plainFramebuffer() has from now on, and nothing over it.
    [[nodiscard]] Result<bool> isPlainShown(const Frame& frame, RefinedPicture& picture, int fewest);

private:
    Renderer();
    struct Private;
    std::unique_ptr<Private> d;
};

}  // namespace hitscope
