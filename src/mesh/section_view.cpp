// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/section_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/bounds.h"

namespace hitscope {

namespace {

constexpr float kUpright = 0.999f;     // cosine; beyond it the normal counts as the world's y
constexpr float kAlong = 1.0e-6f;      // off an axis, below which a direction counts as it
constexpr std::size_t kSegments = 16;  // in a box

SectionView::Axis axisAlong(const glm::vec3& direction) {
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 unit(0.0f);
        unit[axis] = 1.0f;
        if (glm::distance(glm::abs(direction), unit) < kAlong) {
            return {unit, direction[axis] < 0.0f, static_cast<char>('x' + axis)};
        }
    }
    return {direction, false, 0};
}

glm::vec3 nearestOn(const glm::vec3& a, const glm::vec3& b, const glm::vec3& point) {
    const glm::vec3 way = b - a;
    const float length2 = glm::dot(way, way);
    const float along = length2 > 0.0f ? std::clamp(glm::dot(point - a, way) / length2, 0.0f, 1.0f) : 0.0f;
    return along >= 1.0f ? b : a + along * way;
}

float distance2(const Bounds& box, const glm::vec3& point) {
    const glm::vec3 off = point - glm::clamp(point, box.min, box.max);
    return glm::dot(off, off);
}

/// Lines in boxes of a few segments each, which are neighbours.
class NearestOnLines {
public:
    explicit NearestOnLines(std::span<const SectionCurve> curves) {
        for (const SectionCurve& curve : curves) {
            const std::size_t count = curve.points.size();
            const std::size_t segments = curve.closed ? count : count - std::min<std::size_t>(count, 1);
            for (std::size_t i = 0; i < segments; ++i) {
                m_segments.push_back({curve.points[i], curve.points[(i + 1) % count]});
            }
        }
        for (std::size_t i = 0; i < m_segments.size(); ++i) {
            if (i % kSegments == 0) {
                m_boxes.emplace_back();
            }
            m_boxes.back().add(m_segments[i][0]);
            m_boxes.back().add(m_segments[i][1]);
        }
    }

    [[nodiscard]] bool isEmpty() const { return m_segments.empty(); }

    /// The point after another is near it: the box that served last is looked at first.
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& point) {
        Best best{point, std::numeric_limits<float>::infinity()};
        look(m_last, point, best);
        const std::size_t first = m_last;
        for (std::size_t box = 0; box < m_boxes.size() && best.distance2 > 0.0f; ++box) {
            if (box != first && distance2(m_boxes[box], point) < best.distance2) {
                look(box, point, best);
            }
        }
        return best.place;
    }

private:
    struct Best {
        glm::vec3 place;
        float distance2;
    };

    void look(std::size_t box, const glm::vec3& point, Best& best) {
        const std::size_t end = std::min(m_segments.size(), (box + 1) * kSegments);
        for (std::size_t i = box * kSegments; i < end; ++i) {
            const glm::vec3 place = nearestOn(m_segments[i][0], m_segments[i][1], point);
            const float away2 = glm::dot(point - place, point - place);
            if (away2 < best.distance2) {
                best = {place, away2};
                m_last = box;
            }
        }
    }

    std::vector<std::array<glm::vec3, 2>> m_segments;
    std::vector<Bounds> m_boxes;  ///< of kSegments each
    std::size_t m_last = 0;
};

}  // namespace

glm::dvec2 SectionView::operator()(const glm::vec3& point) const {
    const glm::dvec3 place(point);
    return {glm::dot(glm::dvec3(right.direction), place), glm::dot(glm::dvec3(up.direction), place)};
}

SectionView sectionView(const glm::vec3& towards) {
    const glm::vec3 upwards =
        std::abs(towards.y) < kUpright ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(0.0f, 0.0f, -1.0f);
    const glm::vec3 right = glm::normalize(glm::cross(upwards, towards));
    return {axisAlong(right), axisAlong(glm::normalize(glm::cross(towards, right)))};
}

SectionDepths sectionDepths(std::span<const SectionCurve> original, std::span<const SectionCurve> deformed) {
    NearestOnLines lines(original);
    SectionDepths made;
    if (lines.isEmpty()) {
        return made;
    }
    for (std::size_t curve = 0; curve < deformed.size(); ++curve) {
        std::vector<glm::vec3>& nearest = made.nearest.emplace_back();
        std::vector<float>& depths = made.depths.emplace_back();
        for (std::size_t i = 0; i < deformed[curve].points.size(); ++i) {
            const glm::vec3& point = deformed[curve].points[i];
            nearest.push_back(lines(point));
            depths.push_back(glm::distance(point, nearest.back()));
            if (!made.greatest || depths.back() > *made.greatest) {
                made.greatest = depths.back();
                made.curve = curve;
                made.point = i;
            }
        }
    }
    return made;
}

}  // namespace hitscope
