// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picking_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "mesh/render_mesh.h"
#include "pipeline/target_buffers.h"
#include "render/original_shape.h"
#include "render/pick_pass.h"

namespace hitscope {
namespace {

constexpr std::uint32_t kCells = 65;  // of the plate in either direction: 8,450 triangles, 4,356 vertices
constexpr std::uint32_t kCorners = kCells + 1;
constexpr int kPictureSide = 144;  // pixels
constexpr TargetId kPlate{7};
constexpr double kNearEdge = 0.04;  // of a cell: there a ray cannot tell which triangle covers a pixel

/// From (0, 0, 0) to (kCells, kCells, 0), a metre a cell.
RenderMesh makePlate() {
    RenderMesh mesh;
    for (std::uint32_t i = 0; i < kCorners * kCorners; ++i) {
        const glm::vec3 position(static_cast<float>(i % kCorners), static_cast<float>(i / kCorners), 0.0f);
        mesh.vertices.push_back({position, {0.0f, 0.0f, 1.0f}});
        mesh.bounds.add(position);
        if (i % kClusterVertices == 0) {
            mesh.clusters.push_back({i, 0, {}});
        }
        ++mesh.clusters.back().count;
        mesh.clusters.back().bounds.add(position);
    }
    mesh.drawnVertices = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.texcoords.resize(mesh.vertices.size());
    for (std::uint32_t cell = 0; cell < kCells * kCells; ++cell) {
        const std::uint32_t low = cell / kCells * kCorners + cell % kCells;
        const std::uint32_t high = low + kCorners;
        for (const std::uint32_t corner : {low, low + 1, high, low + 1, high + 1, high}) {
            mesh.triangles.push_back(corner);
        }
    }
    mesh.draws.push_back({0, static_cast<std::uint32_t>(mesh.triangles.size()), kNoIndex});
    return mesh;
}

/// The plate turned a little, with room around it.
Frame frameOf(std::span<const DrawItem> items) {
    Frame frame;
    frame.width = frame.height = kPictureSide;
    const float middle = 0.5f * static_cast<float>(kCells);
    frame.camera.setPivot({middle, middle, 0.0f}, 0.15f, 0.1f, 1.2f * static_cast<float>(kCells));
    frame.camera.setSceneRadius(static_cast<float>(kCells));
    frame.targets = items;
    return frame;
}

/// What the pixel shows; nothing: it is too near to an edge to tell.
std::optional<PickedElement> seenBy(const Camera& camera, int x, int y) {
    const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const Ray ray = camera.rayThrough(2.0f * pixel / static_cast<float>(kPictureSide) - 1.0f, 1.0f);
    const double along = -static_cast<double>(ray.origin.z) / static_cast<double>(ray.direction.z);
    const glm::dvec2 at = glm::dvec2(ray.origin) + along * glm::dvec2(ray.direction);
    const glm::dvec2 part = at - glm::floor(at);
    const double diagonal = part.x + part.y - 1.0;
    for (const double edge : {part.x, 1.0 - part.x, part.y, 1.0 - part.y, std::abs(diagonal)}) {
        if (edge < kNearEdge) {
            return std::nullopt;
        }
    }
    if (std::min(at.x, at.y) < 0.0 || std::max(at.x, at.y) > static_cast<double>(kCells)) {
        return PickedElement{};
    }
    const auto cell = static_cast<std::uint32_t>(at.y) * kCells + static_cast<std::uint32_t>(at.x);
    return PickedElement{kPlate, 2 * cell + (diagonal > 0.0 ? 1u : 0u)};
}

void compareTriangles(PickingVerdict& verdict, const Camera& camera, std::span<const PickedElement> picked) {
    for (int i = 0; i < kPictureSide * kPictureSide; ++i) {
        const auto expected = seenBy(camera, i % kPictureSide, i / kPictureSide);
        if (expected) {
            ++verdict.pixels;
            verdict.wrong += picked[static_cast<std::size_t>(i)] == *expected ? 0 : 1;
        }
    }
}

/// On its pixel or one beside it: drivers differ in how they round points, and who points at one takes the
/// nearest about.
bool isAbout(const glm::ivec2& pixel, const PickedElement& element, std::span<const PickedElement> picked) {
    for (int i = 0; i < 9; ++i) {
        const glm::ivec2 beside = pixel + glm::ivec2(i % 3 - 1, i / 3 - 1);
        if (picked[static_cast<std::size_t>(beside.y * kPictureSide + beside.x)] == element) {
            return true;
        }
    }
    return false;
}

/// All of the plate is in the picture, and not at its border.
void compareVertices(PickingVerdict& verdict, const Camera& camera, const RenderMesh& mesh,
                     std::span<const PickedElement> picked) {
    const glm::dmat4 viewProjection = glm::dmat4(camera.projection(1.0f)) * glm::dmat4(camera.view());
    for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const glm::dvec4 clip = viewProjection * glm::dvec4(mesh.vertices[vertex].position, 1.0);
        const glm::ivec2 pixel((glm::dvec2(clip) / clip.w + 1.0) * (0.5 * kPictureSide));
        ++verdict.pixels;
        verdict.wrong += isAbout(pixel, {kPlate, vertex}, picked) ? 0 : 1;
    }
}

PickingVerdict tryWay(bool byGeometry, const gl::Defines& defines) {
    PickingVerdict verdict;
    verdict.byGeometry = byGeometry;
    const RenderMesh mesh = makePlate();
    const TargetBuffers buffers(mesh);
    DrawItem item;
    item.target = kPlate;
    item.buffers = &buffers;
    item.original = true;
    const Frame frame = frameOf(std::span(&item, 1));
    render::OriginalShape shape;
    PickPass pass;
    pass.setWay(byGeometry, defines);
    for (const PickElements elements : {PickElements::Triangles, PickElements::Points}) {
        const PixelArea all{0, 0, kPictureSide, kPictureSide};
        if (const Status drawn = pass.draw(frame, shape, all, elements); !drawn) {
            verdict.whyNot = drawn.error().what;
            return verdict;
        }
        const std::vector<PickedElement> picked = pass.read();
        if (elements == PickElements::Triangles) {
            compareTriangles(verdict, frame.camera, picked);
        } else {
            compareVertices(verdict, frame.camera, mesh, picked);
        }
    }
    return verdict;
}

}  // namespace

PickingVerdict tryPicking(const gl::Defines& defines) {
    const PickingVerdict plain = tryWay(false, defines);
    if (plain.isRight()) {
        return plain;
    }
    const PickingVerdict handedOn = tryWay(true, defines);
    const bool isBetter = handedOn.whyNot.empty() && (!plain.whyNot.empty() || handedOn.wrong < plain.wrong);
    return isBetter ? handedOn : plain;
}

}  // namespace hitscope
