// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <optional>

#include "scene/picture.h"

namespace hitscope {

/// Pictures that belong together, drawn one at a time: a turntable, or the hits appearing one by one. A
/// context is current for every call and the destructor.
class PictureSequence {
public:
    /// Once around the pivot in `count` > 0 pictures; the first is the request's own, and the one after the
    /// last would be it again. `scene` outlives the sequence.
    [[nodiscard]] static PictureSequence turntable(SceneGpu& scene, const PictureRequest& request, int count);
    /// The targets as they were, then one enabled hit more in each picture. Works on a scene of its own,
    /// which shares the meshes: the session is left alone. Colours are over one range in all pictures, that
    /// of the request's values; there is no second pipeline. `until`: of the first so many hits; nothing: of
    /// all.
    [[nodiscard]] static Result<PictureSequence> replay(const Session& session, const PictureRequest& request,
                                                        std::optional<std::size_t> until = {});

    PictureSequence(PictureSequence&&) noexcept;
    PictureSequence& operator=(PictureSequence&&) noexcept;
    ~PictureSequence();

    [[nodiscard]] int count() const;
    /// Each of the pictures in turn; call it count() times at most.
    [[nodiscard]] Result<Image> next();
    /// Likewise, but draws one sample only; nothing: the picture needs more of them.
    [[nodiscard]] Result<std::optional<Image>> advance();

private:
    struct Private;
    explicit PictureSequence(std::unique_ptr<Private> parts);
    std::unique_ptr<Private> d;
};

/// "base-0007.png" in `folder`; with as many digits as `count` pictures need, four at least. 1 <= number.
[[nodiscard]] QString sequencePath(const QString& folder, const QString& base, int number, int count);

}  // namespace hitscope
