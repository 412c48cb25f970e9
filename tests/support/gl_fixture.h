// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <memory>

#include "gl/context.h"

namespace hitscope::test {

/// The offscreen context of a test class.:
///
///     void initTestCase() { m_gl.open(); }
///     void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
class GlFixture {
public:
    /// Makes a context current. Skips the test class where the machine has no EGL at all, and fails it where
    /// EGL is there but gives no context; false in both cases.
    bool open();
    /// That a pixel can have; a context is current.
    [[nodiscard]] static int mostSamples();
    /// OpenGL errors since the last call, in words.
    [[nodiscard]] QStringList errors();

private:
    std::unique_ptr<gl::OffscreenContext> m_context;
};

/// In a test function that holds pictures against baselines, which have four samples a pixel: skips where the
/// renderer has fewer, and outlines are others.
#define HITSCOPE_NEEDS_SAMPLES()                                                          \
    do {                                                                                  \
        if (hitscope::test::GlFixture::mostSamples() < 4) {                               \
            QSKIP("this renderer has fewer samples a pixel than the pictures looked at"); \
        }                                                                                 \
    } while (false)

}  // namespace hitscope::test
