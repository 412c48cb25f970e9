// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/scattered_hits.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace hitscope {

namespace {

std::vector<std::uint32_t> fileTriangles(const RenderMesh& mesh) {
    std::vector<std::uint32_t> triangles(mesh.triangles.size());
    std::transform(mesh.triangles.begin(), mesh.triangles.end(), triangles.begin(),
                   [&mesh](std::uint32_t vertex) { return mesh.fileVertices[vertex]; });
    return triangles;
}

/// The triangles that are scattered over: selected ones, and those that a given direction meets from outside.
std::vector<std::uint32_t> chosenTriangles(const ScatterSurface& surface, const ScatterPlan& plan,
                                           std::span<const std::uint32_t> triangles) {
    const glm::dvec3 along(plan.direction);
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t number = 0; std::size_t{3} * number < triangles.size(); ++number) {
        const std::span<const std::uint32_t> corners = triangles.subspan(std::size_t{3} * number, 3);
        const bool isSelected =
            surface.selected.empty() ||
            std::all_of(corners.begin(), corners.end(), [&surface](std::uint32_t vertex) {
                return std::binary_search(surface.selected.begin(), surface.selected.end(), vertex);
            });
        if (!isSelected) {
            continue;
        }
        const glm::dvec3 a(surface.positions[corners[0]]);
        const glm::dvec3 outwards = glm::cross(glm::dvec3(surface.positions[corners[1]]) - a,
                                               glm::dvec3(surface.positions[corners[2]]) - a);
        if (plan.isInward || glm::dot(outwards, along) < 0.0) {
            chosen.push_back(number);
        }
    }
    return chosen;
}

/// Against the mesh's own normals, which are smooth where it is meant to be: those of dented triangles would
/// scatter directions all over.
glm::dvec3 inwardAt(const RenderMesh& mesh, const SurfaceSample& sample) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh.triangles[std::size_t{3} * sample.triangle + i];
        normal += sample.weights[i] * glm::dvec3(mesh.vertices[vertex].normal);
    }
    constexpr double kTooShort = 1.0e-6;
    const double length = glm::length(normal);
    return length > kTooShort ? -normal / length : -glm::dvec3(sample.normal);
}

/// A direction within the cone about `middle` (unit), evenly over it. `widest`: the cosine of its angle.
glm::dvec3 withinCone(const glm::dvec3& middle, double widest, RepeatableRandom& random) {
    double x = 0.0;
    double y = 0.0;
    double square = 2.0;
    while (square > 1.0) {  // evenly in a circle, without a sine, which is not the same everywhere
        x = 2.0 * random.next() - 1.0;
        y = 2.0 * random.next() - 1.0;
        square = x * x + y * y;
    }
    const double along = 1.0 - square * (1.0 - widest);
    const double beside = std::sqrt(std::max(0.0, 1.0 - along * along));
    const double scale = square > 0.0 ? beside / std::sqrt(square) : 0.0;
    const bool isUpright = std::abs(middle.y) > 0.9;
    const glm::dvec3 other = isUpright ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 right = glm::normalize(glm::cross(other, middle));
    return along * middle + scale * (x * right + y * glm::cross(middle, right));
}

Result<std::size_t> countOf(const ScatterPlan& plan, double area) {
    if (!(area > 0.0)) {
        return Error{"There is no surface to scatter hits over.", "",
                     "Select vertices around whole faces, or turn the direction towards the surface."};
    }
    const double wanted = plan.byDensity ? std::round(plan.density * area) : static_cast<double>(plan.count);
    if (!(wanted >= 1.0)) {
        return Error{"So few hits a square metre are none here.", "", "Raise the density."};
    }
    if (wanted > static_cast<double>(kMostScattered)) {
        return Error{"These would be more than 100,000 hits.", "", "Lower the number or the density."};
    }
    return static_cast<std::size_t>(wanted);
}

}  // namespace

DeformationConstants resized(const DeformationConstants& constants, double factor) {
    DeformationConstants other = scaled(constants, static_cast<float>(factor));
    for (std::size_t i = 0; i < hitParameters().size(); ++i) {
        setParameterValue(
            other, i,
            std::clamp(parameterValue(other, i), hitParameters()[i].minimum, hitParameters()[i].maximum));
    }
    return other;
}

void resize(Hit& hit, double factor) {
    hit.constants = resized(hit.constants, factor);
    if (hit.form.presses()) {
        hit.form.radius *= static_cast<float>(factor);
    }
}

Result<ScatteredHits> scatteredHits(const ScatterSurface& surface, const ScatterPlan& plan, const Hit& model,
                                    const GoOn& goOn) {
    const std::vector<std::uint32_t> triangles = fileTriangles(surface.mesh);
    const std::vector<std::uint32_t> chosen = chosenTriangles(surface, plan, triangles);
    const SurfaceView view{surface.positions, triangles, chosen};
    ScatteredHits scattered;
    scattered.area = surfaceArea(view);
    const Result<std::size_t> count = countOf(plan, scattered.area);
    if (!count) {
        return count.error();
    }
    // To float: the last bit of a library's cosine is its own affair.
    const auto widest = static_cast<double>(static_cast<float>(std::cos(plan.cone)));
    constexpr std::uint64_t kOther = 0x9e3779b97f4a7c15U;  // sizes and directions do not go by the places'
    RepeatableRandom random(plan.seed ^ kOther);
    for (const SurfaceSample& sample : sampleSurface(view, count.value(), plan.seed, goOn)) {
        Hit hit = model;
        hit.point = sample.point;
        hit.normal = sample.normal;
        hit.triangle = sample.triangle;
        const glm::dvec3 middle =
            plan.isInward ? inwardAt(surface.mesh, sample) : glm::normalize(glm::dvec3(plan.direction));
        hit.direction = glm::vec3(withinCone(middle, widest, random));
        const double size = 1.0 + plan.sizeSpread * (2.0 * random.next() - 1.0);
        resize(hit, size);
        scattered.hits.push_back(hit);
    }
    return scattered;
}

}  // namespace hitscope
