// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <limits>

#include "document/session_document.h"
#include "view/camera_text.h"

namespace hitscope::test {

inline Hit exampleHit(std::uint32_t target, float x) {
    Hit hit;
    hit.target = TargetId{target};
    hit.point = {x, 0.1f, -2.5f};
    hit.direction = {0.0f, 0.6f, -0.8f};
    hit.constants = {0.25f, 0.07f, 0.2f};
    hit.time = 1.0 / 3.0;
    hit.speed = 29.9f;
    hit.impulse = 41.0f;
    hit.normal = {0.0f, 0.0f, 1.0f};
    hit.triangle = 77;
    hit.pipeline = static_cast<std::uint8_t>(PipelineKind::Compute);
    return hit;
}

/// A session with one of everything.
inline SessionDocument exampleDocument() {
    SessionDocument document;
    document.scene = {QStringLiteral("Ünder “test”\n"), -0.25f, {{1.0f, 2.0f, 3.0f}, 12.5f}, 1024};
    SavedTarget file;
    file.id = TargetId{1};
    file.name = QStringLiteral("Löwe");
    file.source.mesh = MeshFile{QStringLiteral("/home/me/lion.obj"), 123'456'789'012, std::string(64, 'a')};
    file.source.relativePath = QStringLiteral("../lion.obj");
    file.placement = {{0.1, 0.2, 0.3}, 1.0 / 3.0};
    file.textures = {{"skin.png", QStringLiteral("/tmp/skin.png"), QStringLiteral("maps/skin.png")}};
    file.transform = {{0.1f, 2.0f, -3.0f}, {0.8f, 0.0f, 0.6f, 0.0f}};
    SavedTarget primitive;
    primitive.id = TargetId{7};
    primitive.name = QStringLiteral("Torus");
    primitive.source.mesh = Primitive{PrimitiveKind::Torus, 60, 2.5f};
    primitive.physics = {true, 12.0f, 0.5f, 0.25f};
    primitive.steps = {
        RefineOptions{.method = RefineMethod::LongestEdge,
                      .edgeLength = 0.3f,
                      .keepQuads = false,
                      .region = {MeshRegion::Kind::Balls, {}, {{{0.1f, -2.0f, 3.0f}, 1.0f / 3.0f}}}},
        MergedHits{{exampleHit(7, 0.25f)}},
        SimplifyOptions{.share = 0.7f, .region = {MeshRegion::Kind::Vertices, {3, 4, 4'000'000'000}, {}}},
        SmoothOptions{.passes = 7, .keepBorders = false, .region = {}}};
    SavedTarget builtIn;
    builtIn.id = TargetId{3};
    builtIn.source.mesh = BuiltInMesh::HighPolySphere;
    builtIn.visible = false;
    document.targets = {file, primitive, builtIn};
    document.cameras.current = cameraText(Camera());
    document.cameras.kept = {"", cameraText(Camera()), ""};
    document.selection.target = TargetId{7};
    document.selection.hit = 1;
    document.selection.shown = 2;
    document.selection.picked = VertexRef{TargetId{1}, 12};
    document.selection.vertices = {{TargetId{7}, {1, 2, 5}}};
    document.positions = {{TargetId{1}, 0x0123456789abcdefu}, {TargetId{7}, 5}};
    document.hits = {exampleHit(1, 0.5f), exampleHit(7, -1.5f), exampleHit(1, 3.0e-5f)};
    document.hits[1].enabled = false;
    document.hits[2].flight = {1.0f, 0.0f, 0.0f};
    return document;
}

/// Equal, and where they are numbers in every bit.
template <class Value>
bool isSame(const Value& a, const Value& b) {
    return a == b;
}
inline bool isSame(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
inline bool isSame(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool isSame(const glm::vec3& a, const glm::vec3& b) {
    return isSame(a.x, b.x) && isSame(a.y, b.y) && isSame(a.z, b.z);
}
inline bool isSame(const Hit& a, const Hit& b) {
    return a == b && isSame(a.point, b.point) && isSame(a.direction, b.direction) &&
           isSame(a.normal, b.normal) && isSame(a.flight, b.flight) && isSame(a.time, b.time) &&
           isSame(a.speed, b.speed) && isSame(a.impulse, b.impulse);
}

}  // namespace hitscope::test
