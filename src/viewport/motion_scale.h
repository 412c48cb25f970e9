// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace hitscope {

/// How large a picture is drawn while it moves, so that frames follow each other fast enough on a renderer
/// that cannot hold its full size. Knows times only; who draws tells it about every frame in motion.
///
/// The first frame of a motion has its full size: a jump is one frame. Where fewer pixels do not make frames
/// faster, as with very many vertices, the size stays.
class MotionScale {
public:
    static constexpr double kLongestFrame = 1.0 / 30.0;  ///< seconds that a frame in motion may take

    /// Part of the width and height that the next frame in motion has: 1, 0.707 or 0.5.
    [[nodiscard]] float scale() const;
    /// A frame at scale() took so many seconds, until it was shown.
    void frameTook(double seconds);
    /// Frames take another time from now on: another scene, size or way to draw.
    void forget();

private:
    void setLevel(std::size_t level);
    void judge(double mean);

    std::size_t m_level = 0;    ///< how often the number of pixels was halved
    double m_before = 0.0;      ///< seconds of a frame at the level above; 0: not known
    double m_sum = 0.0;         ///< seconds of the frames counted
    int m_frames = 0;           ///< counted at this level since it was judged last
    bool m_isSettling = false;  ///< the next frame is the level's first, which makes buffers
    bool m_isNoHelp = false;    ///< fewer pixels did not make frames faster
};

}  // namespace hitscope
