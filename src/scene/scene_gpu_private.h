// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The inside of SceneGpu: scene_gpu_draw.cpp draws, scene_gpu_follow.cpp brings the GPU to the session's
// state.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "deform/history_prefix.h"
#include "gl/fence.h"
#include "gl/render_target.h"
#include "render/renderer.h"
#include "scene/bringing.h"
#include "scene/change_upload.h"
#include "scene/frame_meter.h"
#include "scene/frame_parts.h"
#include "scene/reapplication.h"
#include "scene/scene_gpu.h"
#include "scene/scene_marks.h"
#include "scene/second_scene.h"
#include "session/history_edits.h"

namespace hitscope {

struct SceneGpu::Private {
    explicit Private(Session& followed)
        : session(followed),
          readBack(followed.readBack(ReadBackAccess())),
          meter(followed.frameCosts()),
          second(followed) {}

    struct GpuTarget {
        std::unique_ptr<TargetBuffers> buffers;
        std::shared_ptr<const MaterialSet> materials;
        ChangedParts changed;
        std::shared_ptr<const MeshData> dressed = nullptr;  ///< whose materials these are
        std::uint64_t settled = 0;                          ///< as DrawItem::settled
    };

    Session& session;
    ReadBack& readBack;  ///< the session's
    FrameMeter meter;
    std::unique_ptr<Renderer> renderer;
    std::unordered_map<TargetId, GpuTarget> targets;
    std::function<std::unique_ptr<gl::SideContext>()> makeSide;  // empty: done, or nobody can
    std::unique_ptr<gl::SideContext> side;                       // null: none; above what it works on
    std::vector<std::unique_ptr<Bringing>> coming;
    std::unique_ptr<DeformationPipeline> pipeline;  // below the buffers it is given, so that it goes first
    std::unordered_map<const MeshData*, std::weak_ptr<const MaterialSet>> materials;
    std::shared_ptr<const Image> coverImage;  // what `cover` was made of
    std::shared_ptr<const MaterialSet> cover;
    SceneMarks marks;
    std::uint64_t seenRevision = 0;  // of the history
    /// The edits until then that the pipeline has not got; nothing: they are not known.
    std::optional<std::vector<HistoryEdit>> unapplied = std::vector<HistoryEdit>();
    HistoryPrefix applied;  // of the history before those edits
    std::uint64_t meshRevision = 1;
    std::uint64_t dataRevision = 1;     ///< another one when buffers or materials of targets have changed
    std::uint64_t normalsRevision = 1;  ///< when shading normals have
    gl::Defines deformDefines;
    ChangeUpload changeUpload;
    SecondScene second;
    // For pictures that are drawn smaller than they are shown, or before they are shown; null: none so far.
    std::unique_ptr<gl::RenderTarget> ownTarget;
    std::optional<gl::Fence> ahead;           // after the picture ahead that is not shown yet
    const RefinedView* aheadIn = nullptr;     // it is in this one, with nothing over it; null: in ownTarget
    std::unique_ptr<TaskProgress> appending;  // null: no long row of new hits is applied in slices
    std::unique_ptr<Reapplication> reapplication;  // null: nothing is applied again in slices

    bool appliesBetweenPictures = false;
    bool isWarm = false;       ///< the programs of these targets, with this pipeline, are there
    bool isFollowed = false;   ///< for the next picture, before it is drawn
    bool isFetchNext = false;  ///< then a slice reads back what the one before has moved

    enum class Delivery { WhatHasArrived, All };
    void followTargets();
    [[nodiscard]] std::unique_ptr<TargetBuffers> buffersFor(const Target& target);
    void followMaterials(const Target& target, GpuTarget& gpu);
    void followCover();
    [[nodiscard]] const MaterialSet* materialsToDraw(const Target& target) const;
    [[nodiscard]] std::vector<DrawItem> drawItems() const;
    [[nodiscard]] Result<std::unique_ptr<DeformationPipeline>> newPipeline();
    [[nodiscard]] PipelineOptions options() const;
    void tryOut(PipelineKind kind);
    void tryDefault();
    [[nodiscard]] const PickingVerdict& pickingVerdict();
    Status followPipeline(bool& startOver);
    void seeHistory();
    [[nodiscard]] bool hasToStartOver() const;
    Status followReapplication(Delivery delivery);
    void takeReapplied();
    /// Returns whether the pipeline started over.
    bool followHistory(bool startOver, Delivery delivery);
    [[nodiscard]] bool isWorthSlicing(Delivery delivery) const;
    void applySlice();
    void fetch(Delivery delivery);
    /// Shading normals follow all that has moved until now.
    void noteSettled();
    Status follow(Delivery delivery);
    /// Follows all but what is left to applyMore().
    Status followForPicture();
    [[nodiscard]] bool isFarBehind() const;
    /// Whether there are new targets, or draw() would apply hits or read back what they moved.
    [[nodiscard]] bool hasNewTargets() const;
    [[nodiscard]] bool hasToFollow() const;
    /// Whether the pipeline is another one than is wanted, or has not got all hits.
    [[nodiscard]] bool isBehindSession() const;
    std::shared_ptr<const MaterialSet> materialsOf(const DeformedMesh& mesh);
    void followComparison(const View& view);
    [[nodiscard]] bool isSideBySide(const View& view) const {
        return second.isReady() && view.options.sideBySide;
    }
    /// What a view shows, as it is on the GPU.
    [[nodiscard]] std::unique_ptr<FrameParts> frameOf(const View& view);
    /// The picture, or two of them side by side.
    Status drawAll(Frame& frame, const View& view, unsigned framebuffer);
    /// The view as it is drawn, in the pixels that its detail asks for.
    [[nodiscard]] static View drawnView(const View& shown);
    /// Whether `ownTarget` is of that many pixels.
    [[nodiscard]] bool hasOwn(const View& drawn) const;
    /// Has it so; false: the driver cannot give that much.
    [[nodiscard]] bool makeOwn(const View& drawn);
    /// Whether `refined` has the frame without samples, drawn here where refine() will need it.
    [[nodiscard]] bool hasPlain(const FrameParts& parts, const View& view, RefinedView& refined);
    /// How the next picture is drawn.
    struct Choice {
        View view;                          ///< with all pixels, where it is patched or kept
        std::optional<PicturePatch> patch;  ///< of `refined`; nothing: it is drawn anew
        bool isKept = false;                ///< `refined` has it
        bool isAhead = false;  ///< it is read later, wherever it is: `refined` need not be copied
    };
    [[nodiscard]] Choice choose(const View& shown, RefinedView* refined);
    /// Follows the session; the meter measures until drawPicture() has ended.
    [[nodiscard]] Result<Choice> beginPicture(const View& shown, RefinedView* refined);
    /// What draw() says, with the pixels of `choice.view`.
    [[nodiscard]] Status drawPicture(const Choice& choice, unsigned framebuffer, RefinedView* refined);
    [[nodiscard]] Status drawScene(const Choice& choice, unsigned framebuffer, RefinedView* refined);
    [[nodiscard]] Status showRefined(const Choice& choice, const FrameParts& parts, RefinedView& refined,
                                     unsigned framebuffer);
    [[nodiscard]] Status drawPatched(const Choice& choice, unsigned framebuffer, RefinedView& refined);
};

}  // namespace hitscope
