// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/result.h"
#include "render/picked.h"
#include "session/session.h"
#include "view/camera.h"
#include "view/display_options.h"
#include "view/picture_detail.h"

namespace hitscope {

class ChangeValues;
class Comparison;
class PickPass;
class RefinedView;
namespace gl {
class SideContext;
}
struct MeshData;
struct RenderMesh;

/// A session on the GPU: buffers for its targets, the active pipeline, the renderer. Follows the session by
/// the history's revision; nothing in it is truth, so it can be thrown away with its context and made again.
/// A context is current for every call and the destructor.
class SceneGpu {
public:
    /// `session` outlives this.
    [[nodiscard]] static Result<std::unique_ptr<SceneGpu>> create(Session& session);
    ~SceneGpu();
    SceneGpu(const SceneGpu&) = delete;
    SceneGpu& operator=(const SceneGpu&) = delete;

    /// Brings the GPU to the session's state: new targets, pipeline, hits; then waits for what changed to be
    /// read back into the session.
    [[nodiscard]] Status sync();

    /// From now on bring() leaves the work to a context beside the current one, which `make` gives when it is
    /// first needed; null: there is none.
    void bringBeside(std::function<std::unique_ptr<gl::SideContext>()> make);
    /// Brings some of a mesh to the GPU that is about to be a target's, for some milliseconds: the frame that
    /// first shows it then does not have to. Returns whether all of it is there.
    bool bring(const std::shared_ptr<const MeshData>& mesh, const std::shared_ptr<const RenderMesh>& render);
    /// Gives up what was brought of meshes that no target has.
    void dropUnusedMeshes();

    struct View {
        int width = 0;   ///< pixels
        int height = 0;  ///< pixels
        float pixelRatio = 1.0f;
        PictureDetail detail;  ///< that draw() draws with
        Camera camera;
        DisplayOptions options;
        std::shared_ptr<const std::vector<glm::vec3>> ghost = nullptr;  ///< as in Frame
        std::shared_ptr<const SectionLines> section = nullptr;          ///< likewise
        std::shared_ptr<const SectionLines> otherSection = nullptr;     ///< of the second of two pipelines
        bool showsCutPlane = false;                                     ///< likewise
        /// What a colour map of change takes its range and some values from; it follows the quantity shown.
        const ChangeValues* changeValues = nullptr;
        Comparison* comparison = nullptr;  ///< with a second pipeline; null: none
        bool selectionMarks = true;        ///< vertices, the hit and the target that are selected, as such
        bool projectilesFly = false;       ///< as in Frame
        /// The picture is likely to be shown for a while: draw() keeps it for refine(), and to patch it.
        bool isAtRest = false;
    };
    /// As sync(), but waits for nothing: what changed comes to the session with one of the next frames. Then
    /// one picture into the framebuffer object of that name (0: the default framebuffer).
    ///
    /// refined: where it has enough samples of just this picture, or of a coarse one any picture, that is
    /// drawn, and it says so; else it forgets what it has of another one. Null: the picture is drawn as it
    /// is.
    ///
    /// Where the CPU draws, and `refined` has the same picture but for where vertices are, only the part of
    /// it where they have moved is drawn, with all pixels whatever the view's detail: it says so, too.
    [[nodiscard]] Status draw(const View& view, unsigned framebuffer, RefinedView* refined = nullptr);
    /// Begins to draw what draw() would, into a framebuffer of its own, and does not wait for it. False:
    /// there is no room for that. A picture of before that is not shown yet is dropped.
    [[nodiscard]] Result<bool> drawAhead(const View& view, RefinedView* refined = nullptr);
    /// Whether the GPU has finished it, or there is none.
    [[nodiscard]] bool isDrawnAhead() const;
    /// Width and height of the last one in pixels; zeros before there was one. Smaller than the view where
    /// its detail is.
    [[nodiscard]] std::pair<int, int> aheadSize() const;
    /// Reads it as rows from top to bottom of blue, green, red and alpha, one byte each, into 4 * width *
    /// height bytes. Waits until it is finished. False: there is none, or it was in another refined picture
    /// than this one.
    [[nodiscard]] bool readAhead(std::uint8_t* pixels, RefinedView* refined);
    /// Whether the last picture drew any target with fewer triangles; where one looks from close by it need
    /// not.
    [[nodiscard]] bool wasCoarse() const;
    /// Does a part of what draw() would do before it draws, so that an event need not wait for all of it:
    /// takes new targets over, applies new hits or takes what they moved, makes room for drawAhead(), builds
    /// programs, draws shadows. Returns whether no part is left.
    [[nodiscard]] Result<bool> prepare(const View& view, RefinedView* refined = nullptr);
    /// Adds a sample to `refined`, of what was drawn last, or draws a part of one: takes as long as a frame
    /// at most, follows nothing and shows nothing. Samples of another picture are forgotten first. Two
    /// pictures side by side are not refined: it has no samples then.
    [[nodiscard]] Status refine(const View& view, RefinedView& refined);
    /// Whether that would first wait for the samples before.
    [[nodiscard]] bool isBehindRefining(RefinedView& refined) const;
    /// Draws what `refined` has, which is a picture, and what marks the scene now over it.
    [[nodiscard]] Status drawRefined(const View& view, RefinedView& refined, unsigned framebuffer);
    /// Whether it has samples enough of this view, as the scene is now, to be shown; forgets those of
    /// another.
    [[nodiscard]] bool isRefined(const View& view, RefinedView& refined) const;
    /// What draw() last drew, into `pass`: what lies under the pixels of `area` of that view. Nothing before
    /// the first draw() or sync(). An error too where picking was tried and found wrong.
    [[nodiscard]] Status drawElements(const View& view, PickPass& pass, const PixelArea& area,
                                      PickElements elements);
    /// Tries what has not been tried yet of the pipelines and of picking on this renderer, one of them, in
    /// some ten milliseconds; ReadBack::verdict() has what came of it. False: nothing is left.
    bool tryNext();
    /// Whether the session is behind what was drawn: another draw() or sync() brings it on.
    [[nodiscard]] bool isReadBackPending() const;
    /// Whether many hits are being applied, some with each draw(), or what they moved is being read back.
    [[nodiscard]] bool isBehind() const;
    /// Whether so many hits have come or gone since that following them takes longer than a picture.
    [[nodiscard]] bool isFarBehind() const;
    /// Does some of that without a picture, for some ten milliseconds.
    [[nodiscard]] Status applyMore();
    /// on: only applyMore() and sync() do what takes longer than a picture; draw() shows what is there.
    void setAppliesBetweenPictures(bool on);
    [[nodiscard]] const Session& session() const;
    /// Tells the session's FrameCosts what the GPU has taken so far; draw() does so for all but the latest
    /// frames.
    void collectCosts();

private:
    explicit SceneGpu(Session& session);
    struct Private;
    std::unique_ptr<Private> d;
};

}  // namespace hitscope
