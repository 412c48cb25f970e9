// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "view/picture_detail.h"

namespace hitscope {

/// How much of a picture is drawn while it moves, so that frames follow each other fast enough on a renderer
/// that cannot hold all of it: first fewer triangles, where there are many, then fewer pixels. Knows times
/// only; who draws tells it about every frame in motion.
///
/// Where fewer triangles or pixels do not make frames faster, they stay; they are tried again later, and less
/// and less often, as something else may have taken the time.
class MotionDetail {
public:
    /// Seconds that a frame in motion may take where a GPU draws: one that waits for the display takes 1/60 s
    /// itself.
    static constexpr double kLongestFrame = 1.0 / 30.0;
    /// The same where a CPU draws, which waits for no display.
    static constexpr double kLongestSoftwareFrame = 1.0 / 60.0;

    /// seconds: those that a frame in motion may take, kLongestFrame at first. Forgets the times so far.
    void setLongestFrame(double seconds);
    /// Of the next frame in motion; scale: 1, 0.707 or 0.5.
    [[nodiscard]] PictureDetail detail() const;
    /// A frame of detail() took so many seconds, until it was shown.
    void frameTook(double seconds);
    /// part: of the triangles, those in coarse pictures, (0, 1]; 1: there is nothing to leave out.
    void setCoarsePart(float part);
    [[nodiscard]] float coarsePart() const { return m_coarsePart; }
    [[nodiscard]] bool hasCoarse() const { return m_coarsePart < 1.0f; }
    /// Frames take another time from now on: another scene, size or way to draw.
    void forget();
    /// What was no help may be some from now on: from close by it is pixels that take long.
    void tryAgain();
    /// Frames have fewer triangles whatever their times; only pixels are left to choose.
    void takeCoarse();

private:
    void settle();  ///< a step was made
    void judge(double mean);
    void goBack();
    void drawLess(double mean);
    void drawMore(double mean);
    void wait();

    double m_longest = kLongestFrame;
    float m_coarsePart = 1.0f;
    bool m_coarse = false;
    std::size_t m_level = 0;        ///< how often the number of pixels was halved
    std::size_t m_levelBefore = 0;  ///< the last step
    double m_before = 0.0;          ///< seconds of a frame then; 0: not known
    int m_patience = 20;            ///< how often frames are judged too slow until steps are tried again
    int m_waited = 0;               ///< how often they were
    double m_sum = 0.0;             ///< seconds of the frames counted
    int m_frames = 0;               ///< counted since they were judged last
    bool m_isSettling = false;      ///< the next frame is a step's first, which makes buffers
    bool m_areFewTrianglesNoHelp = false;
    bool m_areFewPixelsNoHelp = false;
};

}  // namespace hitscope
