// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

namespace hitscope {

struct FrameParts;
struct PicturePatch;
class RefinedPicture;

/// A refined picture, and what it is a picture of: everything but the marks over it, so that these can change
/// while it stays. A context is current for every call and the destructor, once it has a sample.
class RefinedView {
public:
    /// UntilSettled: where the CPU draws, pixels whose first samples are alike get no more.
    enum class Pixels { AllSamples, UntilSettled };
    explicit RefinedView(Pixels pixels = Pixels::AllSamples);
    ~RefinedView();
    RefinedView(const RefinedView&) = delete;
    RefinedView& operator=(const RefinedView&) = delete;

    /// Fewer samples are not shown: their noise would be seen.
    static constexpr int kFewestShown = 4;

    [[nodiscard]] int samples() const;
    /// Whether it has a picture: there is one before the first sample.
    [[nodiscard]] bool hasPicture() const;
    /// Whether it was drawn at the last SceneGpu::draw().
    [[nodiscard]] bool wasShown() const { return m_shown; }
    /// Whether it was drawn for another picture: where vertices have moved since, with what moves over it, or
    /// its plain picture in place of too few samples.
    [[nodiscard]] bool wasPatched() const { return m_patched; }
    /// Whether part of it has fewer triangles since: the next sample begins with all of them.
    [[nodiscard]] bool isRough() const;
    /// Whether it has a picture with all triangles everywhere.
    [[nodiscard]] bool isWhole() const { return hasPicture() && !isRough(); }
    /// Has no picture from now on.
    void forget();
    /// False: two pictures are side by side.
    [[nodiscard]] bool isPossible() const;
    /// How often samples were forgotten because the picture had become another.
    [[nodiscard]] int restarts() const { return m_restarts; }

    // What follows is SceneGpu's.

    /// Whether it has this picture but for where vertices are, or has it and is rough, where all triangles
    /// are wanted. No other is side by side.
    [[nodiscard]] bool isPatchable(const FrameParts& parts, bool inFull) const;
    /// Whether it is this one, and good enough to be shown; no other is side by side.
    [[nodiscard]] bool has(const FrameParts& parts, bool inFull) const;
    /// What `find` returns, which is called again only for another frame, or once the picture is another:
    /// what comes before a picture asks for the same patch as the picture itself.
    [[nodiscard]] std::optional<PicturePatch> patchFor(
        const FrameParts& parts, bool isHurried, const std::function<std::optional<PicturePatch>()>& find);
    /// It was drawn as it is. isMoving: something was over it that is elsewhere in the next picture.
    void keptShown(bool isMoving);
    /// Its plain picture was drawn, in place of too few samples.
    void plainShown();
    /// Now it is this one.
    void patched(const FrameParts& parts);
    /// Forgets the samples where they are of another picture than this.
    void follow(const FrameParts& parts, bool isSideBySide);
    /// Likewise; returns whether there are samples enough to be shown, or, where anything is better than what
    /// would be drawn, a picture.
    [[nodiscard]] bool show(const FrameParts& parts, bool isSideBySide, bool anythingIsBetter);
    /// Whether it has a picture without samples, and none of them is being drawn.
    [[nodiscard]] bool isPlain() const;
    [[nodiscard]] RefinedPicture& picture();

private:
    struct Private;
    std::unique_ptr<Private> d;
    bool m_shown = false;
    bool m_patched = false;
    int m_restarts = 0;
};

}  // namespace hitscope
