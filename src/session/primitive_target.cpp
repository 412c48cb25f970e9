// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/primitive_target.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/geodesic_sphere.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "session/session.h"

namespace hitscope {

namespace {

constexpr float kTube = 0.25f;  // of a torus's outer radius

int clamped(const Primitive& primitive) {
    const PrimitiveTraits& traits = traitsOf(primitive.kind);
    return std::clamp(primitive.resolution, traits.least, traits.most);
}

/// Cells that are about square on the side of a cylinder as high as wide, and on its ends.
int rowsOfCylinder(int around) {
    return std::max(1, around / 3);
}
int ringsOfCylinder(int around) {
    return std::max(1, around / 6);
}
/// Likewise for a turntable, which is flat.
int rowsOfTurntable(int around) {
    return std::max(1, around / 40);
}
/// Likewise for the tube of a torus.
int tubeOfTorus(int around) {
    return std::max(3, around / 3);
}

MeshData makeMesh(PrimitiveKind kind, int n, float size) {
    const float half = 0.5f * size;
    switch (kind) {
        case PrimitiveKind::Cube:
            return makeCube(n, half);
        case PrimitiveKind::UvSphere:
            return makeUvSphere(n, n / 2, half);
        case PrimitiveKind::GeodesicSphere:
            return makeGeodesicSphere(n, half);
        case PrimitiveKind::Torus:
            return makeTorus(n, tubeOfTorus(n), half * (1.0f - kTube), half * kTube);
        case PrimitiveKind::Cylinder:
            return makeCylinder(n, rowsOfCylinder(n), ringsOfCylinder(n), half, size);
        case PrimitiveKind::Sheet:
            return makeSheet(n, n, size, size);
        case PrimitiveKind::Turntable:
            return makeCylinder(n, rowsOfTurntable(n), ringsOfCylinder(n), half, kTurntableFlatness * size);
    }
    return {};
}

MeshData makeTurntableStand(const Bounds& teapot) {
    constexpr float kRim = 1.15f;  // of the radius that the teapot just stands on
    return makeCylinder(120, 3, 20, kRim * 0.5f * std::max(teapot.size().x, teapot.size().z),
                        kTurntableHeight);
}

MeshData makeMesh(BuiltInMesh mesh) {
    constexpr int kTeapotDivisions = 32;  // fine enough that a dent of 0.5 m in radius shows its rim
    switch (mesh) {
        case BuiltInMesh::Teapot:
            return makeTeapot(kTeapotDivisions);
        case BuiltInMesh::LowPolyCube:
            return makeLowPolyCube(kPaperHalfExtent);
        case BuiltInMesh::HighPolyCube:
            return makeHighPolyCube(kPaperHalfExtent);
        case BuiltInMesh::LowPolySphere:
            return makeLowPolySphere(kPaperHalfExtent);
        case BuiltInMesh::HighPolySphere:
            return makeHighPolySphere(kPaperHalfExtent);
        case BuiltInMesh::TurntableStand:
            return makeTurntableStand(makeTeapot(kTeapotDivisions).bounds());
        case BuiltInMesh::FineTorus:
            return makeTorus(1600, 625, kFineTorusRadius, kFineTorusTube);  // two triangles a quad
    }
    return {};
}

}  // namespace

std::span<const PrimitiveTraits> allPrimitives() {
    static constexpr std::array<PrimitiveTraits, 7> kTraits = {
        {{PrimitiveKind::Cube, QT_TRANSLATE_NOOP("hitscope::Primitive", "Quads along an edge"), 1, 32, 408},
         {PrimitiveKind::UvSphere, QT_TRANSLATE_NOOP("hitscope::Primitive", "Segments around"), 4, 96, 1416},
         {PrimitiveKind::GeodesicSphere, QT_TRANSLATE_NOOP("hitscope::Primitive", "Triangles along an edge"),
          1, 24, 316},
         {PrimitiveKind::Torus, QT_TRANSLATE_NOOP("hitscope::Primitive", "Segments around"), 9, 120, 1732},
         {PrimitiveKind::Cylinder, QT_TRANSLATE_NOOP("hitscope::Primitive", "Segments around"), 6, 96, 1224},
         {PrimitiveKind::Sheet, QT_TRANSLATE_NOOP("hitscope::Primitive", "Quads along an edge"), 1, 64, 1000},
         {PrimitiveKind::Turntable, QT_TRANSLATE_NOOP("hitscope::Primitive", "Segments around"), 6, 120,
          1670}}};
    return kTraits;
}

const PrimitiveTraits& traitsOf(PrimitiveKind kind) {
    return allPrimitives()[static_cast<std::size_t>(kind)];
}

QString primitiveName(PrimitiveKind kind) {
    constexpr std::array<const char*, 7> kNames = {
        QT_TRANSLATE_NOOP("hitscope::Primitive", "Cube"),
        QT_TRANSLATE_NOOP("hitscope::Primitive", "UV sphere"),
        QT_TRANSLATE_NOOP("hitscope::Primitive", "Geodesic sphere"),
        QT_TRANSLATE_NOOP("hitscope::Primitive", "Torus"),
        QT_TRANSLATE_NOOP("hitscope::Primitive", "Cylinder"),
        QT_TRANSLATE_NOOP("hitscope::Primitive", "Sheet"),
        QT_TRANSLATE_NOOP("hitscope::Primitive", "Turntable")};
    return QCoreApplication::translate("hitscope::Primitive", kNames[static_cast<std::size_t>(kind)]);
}

std::size_t vertexCount(const Primitive& primitive) {
    const auto n = static_cast<std::size_t>(clamped(primitive));
    const int around = static_cast<int>(n);
    switch (primitive.kind) {
        case PrimitiveKind::Cube:
            return 6 * n * n + 2;
        case PrimitiveKind::UvSphere:
            return n * (n / 2 - 1) + 2;
        case PrimitiveKind::GeodesicSphere:
            return 10 * n * n + 2;
        case PrimitiveKind::Torus:
            return n * static_cast<std::size_t>(tubeOfTorus(around));
        case PrimitiveKind::Cylinder:
            return n * static_cast<std::size_t>(rowsOfCylinder(around) + 1 +
                                                2 * (ringsOfCylinder(around) - 1)) +
                   2;
        case PrimitiveKind::Sheet:
            return (n + 1) * (n + 1);
        case PrimitiveKind::Turntable:
            return n * static_cast<std::size_t>(rowsOfTurntable(around) + 1 +
                                                2 * (ringsOfCylinder(around) - 1)) +
                   2;
    }
    return 0;
}

float usualPrimitiveSize(const Session& session) {
    constexpr float kUsual = 2.0f * kPaperHalfExtent;
    constexpr float kOff = 10.0f;  // times
    float largest = 0.0f;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        largest = std::max(largest, target->visible ? target->extent() : 0.0f);
    }
    if (!(largest > 0.0f) || (largest > kUsual / kOff && largest < kUsual * kOff)) {
        return kUsual;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(static_cast<double>(largest))));
    const double digit = static_cast<double>(largest) / unit;
    return static_cast<float>(unit * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0));
}

TargetPlan planPrimitive(const Primitive& primitive) {
    TargetPlan plan = planMesh(makeMesh(primitive.kind, clamped(primitive), primitive.size));
    plan.name = primitiveName(primitive.kind);
    plan.source = Primitive{primitive.kind, clamped(primitive), primitive.size};
    if (primitive.kind == PrimitiveKind::Torus) {
        // Upright, so that shots go through its hole.
        plan.transform.rotation = glm::angleAxis(0.5f * std::numbers::pi_v<float>, glm::vec3(1, 0, 0));
    }
    plan.transform.position.y = -worldBounds(*plan.shape.render, plan.transform).min.y;
    if (primitive.kind == PrimitiveKind::Cube) {
        plan.collider = BoxCollider{glm::vec3(0.5f * primitive.size)};
    } else if (primitive.kind == PrimitiveKind::UvSphere || primitive.kind == PrimitiveKind::GeodesicSphere) {
        plan.collider = SphereCollider{0.5f * primitive.size};
    }
    return plan;
}

Status putOnTurntable(Session& session, TargetId id) {
    constexpr float kRim = 1.15f;      // of the width of what stands on it
    constexpr float kApart = 1.0e-4f;  // of its height, so that nothing is moved aside
    SessionTargets& targets = session.targets();
    const Target* target = targets.find(id);
    if (target == nullptr) {
        return Error{"The target is gone.", "", "Select another one."};
    }
    const Bounds box = target->worldBounds();
    const float size = kRim * std::max(box.size().x, box.size().z);
    if (!(size >= Primitive::kLeastSize && size <= Primitive::kMostSize)) {
        return Error{size > 1.0f ? "The target is too wide for a turntable."
                                 : "The target is too narrow for a turntable.",
                     "", "Select another one, or scale it."};
    }
    const float height = kTurntableFlatness * size;
    TargetPlan table =
        planPrimitive({PrimitiveKind::Turntable, traitsOf(PrimitiveKind::Turntable).usual, size});
    table.transform.position = {box.centre().x, box.min.y + 0.5f * height, box.centre().z};
    RigidTransform raised = target->transform;
    raised.position.y += height * (1.0f + kApart);
    targets.putUnder(id, raised, std::move(table));
    targets.select(id);
    return Done{};
}

TargetPlan planBuiltIn(BuiltInMesh mesh) {
    TargetPlan plan = planMesh(prepareMesh(makeMesh(mesh)), TargetSource(mesh));
    if (mesh == BuiltInMesh::LowPolyCube || mesh == BuiltInMesh::HighPolyCube) {
        plan.collider = BoxCollider{glm::vec3(kPaperHalfExtent)};
    } else if (mesh == BuiltInMesh::LowPolySphere || mesh == BuiltInMesh::HighPolySphere) {
        plan.collider = SphereCollider{kPaperHalfExtent};
    }
    return plan;
}

}  // namespace hitscope
