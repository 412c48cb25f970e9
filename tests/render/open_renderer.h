// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <memory>

#include "render/renderer.h"
#include "support/gl_fixture.h"

namespace hitscope::test {

/// A renderer in the fixture's context; null where there is none, and the test class skipped or failed.
[[nodiscard]] inline std::unique_ptr<Renderer> openRenderer(GlFixture& gl) {
    std::unique_ptr<Renderer> renderer;
    [&] {
        if (!gl.open()) {
            return;
        }
        auto made = Renderer::create();
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
        renderer = std::move(made).value();
    }();
    return renderer;
}

}  // namespace hitscope::test
