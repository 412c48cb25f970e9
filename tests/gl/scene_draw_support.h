// SPDX-License-Identifier: GPL-3.0-or-later
// For tests of pictures that SceneGpu draws.
#pragma once

#include <epoxy/gl.h>

#include <QTest>
#include <functional>
#include <vector>

#include "core/bounds.h"
#include "gl/render_target.h"
#include "scene/scene_gpu.h"
#include "session/primitive_target.h"

namespace hitscope::test {

constexpr int kSmallWidth = 240;
constexpr int kSmallHeight = 120;

/// Two cubes side by side, far enough apart that neither shades the other.
inline std::vector<TargetPlan> twoCubes() {
    std::vector<TargetPlan> made(2, planPrimitive({PrimitiveKind::Cube, 4, 4.0f}));
    made[0].transform.position.x = -5.0f;
    made[1].transform.position.x = 5.0f;
    return made;
}

/// From the front, however little of the scene is visible.
inline SceneGpu::View smallView(const Session& session, bool withFloor) {
    SceneGpu::View view;
    view.width = kSmallWidth;
    view.height = kSmallHeight;
    Bounds bounds;
    for (const auto& target : session.targets()) {
        bounds.add(target->worldBounds());
    }
    view.camera.frame(bounds, 2.0f);
    view.options.floor = withFloor;
    view.options.shadows = withFloor;
    return view;
}

/// Empty where it failed, and the test with it.
inline Image drawn(SceneGpu& gpu, const SceneGpu::View& view, RefinedView* refined = nullptr) {
    const gl::RenderTarget into(view.width, view.height);
    if (const Status status = gpu.draw(view, into.framebuffer(), refined); !status) {
        QTest::qFail(status.error().message().c_str(), __FILE__, __LINE__);
        return {};
    }
    return into.read();
}

/// Triangles and lines that were drawn meanwhile.
inline GLuint primitivesOf(const std::function<void()>& act) {
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    act();
    glEndQuery(GL_PRIMITIVES_GENERATED);
    GLuint primitives = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &primitives);
    glDeleteQueries(1, &query);
    return primitives;
}

}  // namespace hitscope::test
