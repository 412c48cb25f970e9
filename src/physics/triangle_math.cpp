// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/triangle_math.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope::physics {
namespace {

using glm::dot;
using glm::dvec3;

// A ray along the edge between two triangles must not slip between them.
constexpr double kEdgeSlack = 1.0e-9;

/// The smaller root of a t^2 + 2 h t + c = 0: where a distance that shrinks first reaches its limit.
std::optional<double> firstRoot(double a, double h, double c) {
    const double discriminant = h * h - a * c;
    if (h >= 0.0 || !(a > 0.0) || discriminant < 0.0) {
        return std::nullopt;
    }
    // c / (-h + root) instead of (-h - root) / a: no digits cancel.
    const double t = c / (-h + std::sqrt(discriminant));
    return t >= 0.0 && t <= 1.0 ? std::optional(t) : std::nullopt;
}

void keepFirst(std::optional<double>& first, const std::optional<double>& other) {
    if (other && (!first || *other < *first)) {
        first = other;
    }
}

std::optional<double> castAtPoint(const dvec3& point, const dvec3& start, const dvec3& motion,
                                  double radius) {
    const dvec3 from = start - point;
    return firstRoot(dot(motion, motion), dot(from, motion), dot(from, from) - radius * radius);
}

/// Against the cylinder around an edge, between its ends.
std::optional<double> castAtEdge(const dvec3& p, const dvec3& q, const dvec3& start, const dvec3& motion,
                                 double radius) {
    const dvec3 edge = q - p;
    const dvec3 from = start - p;
    const double length2 = dot(edge, edge);
    const double alongMotion = dot(edge, motion) / length2;
    const double alongFrom = dot(edge, from) / length2;
    const dvec3 across = motion - edge * alongMotion;
    const dvec3 away = from - edge * alongFrom;
    const auto t = firstRoot(dot(across, across), dot(away, across), dot(away, away) - radius * radius);
    if (!t) {
        return std::nullopt;
    }
    const double where = alongFrom + alongMotion * *t;
    return where >= 0.0 && where <= 1.0 ? t : std::nullopt;
}

bool isInside(const Triangle& triangle, const dvec3& normal, const dvec3& p) {
    const auto side = [&](const dvec3& from, const dvec3& to) {
        return dot(glm::cross(to - from, p - from), normal);
    };
    return side(triangle.a, triangle.b) >= 0.0 && side(triangle.b, triangle.c) >= 0.0 &&
           side(triangle.c, triangle.a) >= 0.0;
}

}  // namespace

bool Triangle::hasArea() const {
    const dvec3 ab = b - a;
    const dvec3 ac = c - a;
    const double longest = std::max({dot(ab, ab), dot(ac, ac), dot(c - b, c - b)});
    const dvec3 across = glm::cross(ab, ac);
    // A corner that is not finite makes both sides NaN or infinite, and the comparison false.
    return dot(across, across) > 1.0e-12 * longest * longest && std::isfinite(longest);
}

dvec3 Triangle::normal() const {
    return glm::normalize(glm::cross(b - a, c - a));
}

// Ericson, Real-Time Collision Detection, 5.1.5: the Voronoi region of the triangle that `p` lies in.
dvec3 nearestPoint(const Triangle& triangle, const dvec3& p) {
    const auto& [a, b, c] = triangle;
    const dvec3 ab = b - a;
    const dvec3 ac = c - a;
    const double d1 = dot(ab, p - a);
    const double d2 = dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return a;
    }
    const double d3 = dot(ab, p - b);
    const double d4 = dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) {
        return b;
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return a + ab * (d1 / (d1 - d3));
    }
    const double d5 = dot(ab, p - c);
    const double d6 = dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) {
        return c;
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return a + ac * (d2 / (d2 - d6));
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    const double scale = 1.0 / (va + vb + vc);
    return a + ab * (vb * scale) + ac * (vc * scale);
}

// Möller and Trumbore, 1997, both sides.
std::optional<double> castPoint(const Triangle& triangle, const dvec3& start, const dvec3& motion) {
    const dvec3 ab = triangle.b - triangle.a;
    const dvec3 ac = triangle.c - triangle.a;
    const dvec3 across = glm::cross(motion, ac);
    const double determinant = dot(ab, across);
    if (determinant == 0.0) {
        return std::nullopt;
    }
    const dvec3 from = start - triangle.a;
    const double u = dot(from, across) / determinant;
    const dvec3 turned = glm::cross(from, ab);
    const double v = dot(motion, turned) / determinant;
    const double t = dot(ac, turned) / determinant;
    const bool inside = u >= -kEdgeSlack && v >= -kEdgeSlack && u + v <= 1.0 + kEdgeSlack;
    return inside && t >= 0.0 && t <= 1.0 ? std::optional(t) : std::nullopt;
}

std::optional<double> castSphere(const Triangle& triangle, const dvec3& start, const dvec3& motion,
                                 double radius) {
    const dvec3 normal = triangle.normal();
    const double height = dot(normal, start - triangle.a);
    const double towards = height < 0.0 ? dot(normal, motion) : -dot(normal, motion);
    const double distance = std::abs(height);
    if (distance > radius) {
        // Its plane must come within the radius first, and where that happens inside, it is the contact.
        if (towards <= 0.0 || distance - towards > radius) {
            return std::nullopt;
        }
        const double t = (distance - radius) / towards;
        const dvec3 touching = start + motion * t;
        if (isInside(triangle, normal, touching - normal * dot(normal, touching - triangle.a))) {
            return t;
        }
    } else {
        const dvec3 away = start - nearestPoint(triangle, start);
        if (dot(away, away) <= radius * radius) {
            const bool deeper = distance == 0.0 ? towards != 0.0 : dot(away, motion) < 0.0;
            return deeper ? std::optional(0.0) : std::nullopt;
        }
    }
    const auto& [a, b, c] = triangle;
    std::optional<double> first = castAtEdge(a, b, start, motion, radius);
    keepFirst(first, castAtEdge(b, c, start, motion, radius));
    keepFirst(first, castAtEdge(c, a, start, motion, radius));
    keepFirst(first, castAtPoint(a, start, motion, radius));
    keepFirst(first, castAtPoint(b, start, motion, radius));
    keepFirst(first, castAtPoint(c, start, motion, radius));
    return first;
}

std::optional<double> castAtBall(const dvec3& centre, double ballRadius, const dvec3& start,
                                 const dvec3& motion, double radius) {
    const dvec3 from = start - centre;
    const double reach = ballRadius + radius;
    if (dot(from, from) <= reach * reach) {
        return dot(from, motion) < 0.0 ? std::optional(0.0) : std::nullopt;
    }
    return castAtPoint(centre, start, motion, reach);
}

}  // namespace hitscope::physics
