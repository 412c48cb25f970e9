// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/dent_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hitscope {

namespace {

using Line = std::vector<ProfilePoint>;

ProfilePoint between(const ProfilePoint& a, const ProfilePoint& b, double part) {
    return {a.along + part * (b.along - a.along), a.height + part * (b.height - a.height)};
}

double squaredDistance(const ProfilePoint& a, const ProfilePoint& b) {
    const double along = a.along - b.along;
    const double height = a.height - b.height;
    return along * along + height * height;
}

/// The part of a segment that lies in the frame.
struct Part {
    double first = 0.0;  ///< 0: from its start
    double last = 1.0;   ///< 1: to its end
};

/// Liang and Barsky's; nothing: no part of it does.
std::optional<Part> within(const ProfileFrame& frame, const ProfilePoint& a, const ProfilePoint& b) {
    Part part;
    const auto clip = [&part](double from, double step, double least, double most) {
        if (step == 0.0) {
            return from >= least && from <= most;
        }
        const double one = (least - from) / step;
        const double other = (most - from) / step;
        part.first = std::max(part.first, std::min(one, other));
        part.last = std::min(part.last, std::max(one, other));
        return part.first <= part.last;
    };
    const bool isWithin = clip(a.along, b.along - a.along, -frame.along, frame.along) &&
                          clip(a.height, b.height - a.height, frame.lowest, frame.highest);
    return isWithin ? std::optional(part) : std::nullopt;
}

/// The pieces of a line that lie in the frame.
std::vector<Line> pieces(const Line& line, const ProfileFrame& frame) {
    std::vector<Line> all;
    Line piece;
    const auto finish = [&all, &piece] {
        if (piece.size() > 1) {
            all.push_back(piece);
        }
        piece.clear();
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        const std::optional<Part> part = within(frame, line[i - 1], line[i]);
        if (!part || part->first > 0.0) {
            finish();
        }
        if (!part) {
            continue;
        }
        if (piece.empty()) {
            piece.push_back(part->first > 0.0 ? between(line[i - 1], line[i], part->first) : line[i - 1]);
        }
        piece.push_back(part->last < 1.0 ? between(line[i - 1], line[i], part->last) : line[i]);
        if (part->last < 1.0) {
            finish();
        }
    }
    finish();
    return all;
}

double squaredDistance(const Line& line, const ProfilePoint& point) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const ProfilePoint& a = line[i - 1];
        const ProfilePoint& b = line[i];
        const double length = squaredDistance(a, b);
        const double along =
            (point.along - a.along) * (b.along - a.along) + (point.height - a.height) * (b.height - a.height);
        const double part = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
        least = std::min(least, squaredDistance(between(a, b, part), point));
    }
    return least;
}

}  // namespace

bool ProfileFrame::contains(const ProfilePoint& point) const {
    return std::abs(point.along) <= along && point.height >= lowest && point.height <= highest;
}

ProfileFrame profileFrame(const DentMeasures& dent, const Plane& plane,
                          std::span<const std::uint32_t> vertices, std::span<const glm::vec3> before,
                          std::span<const glm::vec3> after) {
    ProfileFrame frame;
    for (const std::uint32_t vertex : vertices) {
        for (const glm::vec3& point : {before[vertex], after[vertex]}) {
            const double height = toProfile(plane, dent, before[dent.deepest], point).height;
            frame.lowest = std::min(frame.lowest, height);
            frame.highest = std::max(frame.highest, height);
        }
    }
    constexpr double kLeast = 1.0e-6;  // a dent of one vertex has no diameter
    frame.along = std::max(0.75 * dent.rimDiameter, kLeast);
    const double margin = std::max(0.25 * dent.rimDiameter, kLeast);
    frame.lowest -= margin;
    frame.highest += margin;
    return frame;
}

std::vector<ProfilePoint> profileLine(std::span<const SectionCurve> curves, const Plane& plane,
                                      const DentMeasures& dent, const glm::vec3& deepestBefore,
                                      const ProfileFrame& frame, const glm::vec3& at) {
    const ProfilePoint wanted = toProfile(plane, dent, deepestBefore, at);
    Line nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const SectionCurve& curve : curves) {
        Line line;
        for (const glm::vec3& point : curve.points) {
            line.push_back(toProfile(plane, dent, deepestBefore, point));
        }
        if (curve.closed && !line.empty()) {
            // From a point outside, so that no piece is cut in two where the curve starts.
            const auto outside = std::find_if(line.begin(), line.end(), [&frame](const ProfilePoint& point) {
                return !frame.contains(point);
            });
            std::rotate(line.begin(), outside == line.end() ? line.begin() : outside, line.end());
            line.push_back(ProfilePoint(line.front()));
        }
        for (Line& piece : pieces(line, frame)) {
            if (const double distance = squaredDistance(piece, wanted); distance < least) {
                least = distance;
                nearest = std::move(piece);
            }
        }
    }
    return nearest;
}

}  // namespace hitscope
