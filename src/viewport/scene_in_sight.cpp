// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/scene_in_sight.h"

#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec4.hpp>

namespace hitscope {

namespace {

constexpr float kCore = 0.55f;          // of a box: the corners of this part are within its sphere
constexpr float kLeastDepth = 1.0e-6f;  // of the camera's distance, before the eye
constexpr int kHalvings = 24;

using Polygon = std::vector<glm::vec3>;

/// What lies where dot(plane.xyz, p) + plane.w >= 0.
Polygon clipped(const Polygon& polygon, const glm::vec4& plane) {
    const auto side = [&plane](const glm::vec3& p) { return glm::dot(glm::vec3(plane), p) + plane.w; };
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec3& from = polygon[i];
        const glm::vec3& to = polygon[(i + 1) % polygon.size()];
        const float a = side(from);
        const float b = side(to);
        if (a >= 0.0f) {
            kept.push_back(from);
        }
        if ((a >= 0.0f) != (b >= 0.0f)) {
            kept.push_back(from + (a / (a - b)) * (to - from));
        }
    }
    return kept;
}

/// Of what the picture shows, in the camera's own axes: right, up, forward from the eye.
std::vector<glm::vec4> planesOf(const Camera& camera, float aspect, float part) {
    if (camera.isOrthographic()) {
        const float high = 0.5f * part * camera.heightAt(camera.distance());
        const float wide = high * aspect;
        return {{1, 0, 0, wide}, {-1, 0, 0, wide}, {0, 1, 0, high}, {0, -1, 0, high}};
    }
    const float high = 0.5f * part * camera.heightAt(1.0f);
    const float wide = high * aspect;
    return {{0, 0, 1, -kLeastDepth * camera.distance()},
            {1, 0, wide, 0},
            {-1, 0, wide, 0},
            {0, 1, high, 0},
            {0, -1, high, 0}};
}

bool contains(const Bounds& box, const glm::vec3& point) {
    return glm::all(glm::greaterThanEqual(point, box.min)) && glm::all(glm::lessThanEqual(point, box.max));
}

}  // namespace

bool isInPicture(const Bounds& box, const Camera& camera, float aspect, float part) {
    if (box.empty()) {
        return false;
    }
    if (!camera.isOrthographic() && contains(box, camera.eye())) {
        return true;
    }
    std::array<glm::vec3, 8> corners;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 away =
            glm::vec3((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                      (corner & 4) != 0 ? box.max.z : box.min.z) -
            camera.eye();
        corners[static_cast<std::size_t>(corner)] = {
            glm::dot(away, camera.right()), glm::dot(away, camera.up()), glm::dot(away, camera.forward())};
    }
    const std::vector<glm::vec4> planes = planesOf(camera, aspect, part);
    constexpr std::array<std::array<std::size_t, 4>, 6> kFaces{
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    for (const auto& face : kFaces) {
        Polygon left{corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]};
        for (const glm::vec4& plane : planes) {
            left = clipped(left, plane);
        }
        if (!left.empty()) {
            return true;
        }
    }
    return false;
}

Bounds coreOf(const Bounds& box) {
    Bounds core;
    if (!box.empty()) {
        core.add(box.centre() - 0.5f * kCore * box.size());
        core.add(box.centre() + 0.5f * kCore * box.size());
    }
    return core;
}

std::optional<glm::vec3> centreInSight(const SceneInSight& scene, const Camera& camera, float aspect) {
    const auto centre = [&](const Bounds& box) -> std::optional<glm::vec3> {
        Bounds point;
        point.add(box.centre());
        return !box.empty() && isInPicture(point, camera, aspect, 1.0f) ? std::optional(box.centre())
                                                                        : std::nullopt;
    };
    if (scene.selected) {
        if (const auto found = centre(scene.targets[*scene.selected])) {
            return found;
        }
    }
    Bounds all;
    for (const Bounds& target : scene.targets) {
        if (isInPicture(coreOf(target), camera, aspect, 1.0f)) {
            all.add(target);
        }
    }
    return centre(all);
}

Camera raisedAbove(float floor, const Camera& camera, const glm::vec3& about) {
    const auto pitched = [&](float by) {
        Camera turned = camera;
        turned.orbitAbout(about, 0.0f, by);
        return turned;
    };
    float low = 0.0f;
    float high = glm::half_pi<float>() - camera.pitch();
    if (pitched(high).eye().y < floor) {
        return camera;
    }
    for (int i = 0; i < kHalvings; ++i) {
        const float middle = 0.5f * (low + high);
        (pitched(middle).eye().y < floor ? low : high) = middle;
    }
    return pitched(high);
}

}  // namespace hitscope
