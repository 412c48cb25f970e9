// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/edge_choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hitscope {

namespace {

using Face = RefineWork::Face;

// Halves of an edge of twice the wanted length may be longer by a rounding.
constexpr double kTolerance = 1.0 + 1.0e-5;

bool isTooLong(const RefineWork& work, std::uint32_t a, std::uint32_t b, double length) {
    if (work.squaredLength(a, b) <= length * length * kTolerance) {
        return false;
    }
    const glm::vec3& from = work.position(a);
    const glm::vec3& to = work.position(b);
    const auto middle = glm::vec3(0.5 * (glm::dvec3(from) + glm::dvec3(to)));
    return middle != from && middle != to;
}

std::uint64_t keyOf(const RefineWork& work, std::uint32_t a, std::uint32_t b) {
    return edgeKey(work.placeOf(a), work.placeOf(b));
}

/// Side i of a face.
std::uint64_t sideOf(const RefineWork& work, const Face& face, std::size_t i) {
    const std::span<const RefineCorner> corners = work.cornersOf(face);
    return edgeKey(work.placeOf(corners[i % corners.size()]),
                   work.placeOf(corners[(i + 1) % corners.size()]));
}

/// From each edge that is cut to the one across a quad.
void goAlongStrips(const RefineWork& work, CutEdges& edges) {
    std::unordered_multimap<std::uint64_t, std::uint64_t, EdgeHash> across;
    for (const Face& face : work.faces()) {
        if (face.inRegion && face.count == 4) {
            for (std::size_t i = 0; i < 4; ++i) {
                across.emplace(sideOf(work, face, i), sideOf(work, face, i + 2));
            }
        }
    }
    std::vector<std::uint64_t> open;
    open.reserve(edges.size());
    for (const auto& [key, edge] : edges) {
        open.push_back(key);
    }
    while (!open.empty()) {
        const std::uint64_t key = open.back();
        open.pop_back();
        const auto [begin, end] = across.equal_range(key);
        for (auto next = begin; next != end; ++next) {
            if (edges.try_emplace(next->second).second) {
                open.push_back(next->second);
            }
        }
    }
}

}  // namespace

CutEdges longEdges(const RefineWork& work, double length, bool keepsQuads) {
    CutEdges edges;
    for (const Face& face : work.faces()) {
        if (face.inRegion) {
            work.forSides(face, [&](std::uint32_t a, std::uint32_t b) {
                if (isTooLong(work, a, b, length)) {
                    edges.try_emplace(keyOf(work, a, b));
                }
            });
        }
    }
    if (keepsQuads) {
        goAlongStrips(work, edges);
    }
    return edges;
}

CutEdges everyEdge(const RefineWork& work, double length) {
    CutEdges edges;
    bool isAnyTooLong = false;
    for (const Face& face : work.faces()) {
        if (face.inRegion) {
            work.forSides(face, [&](std::uint32_t a, std::uint32_t b) {
                isAnyTooLong = isAnyTooLong || isTooLong(work, a, b, length);
                if (work.placeOf(a) != work.placeOf(b)) {
                    edges.try_emplace(keyOf(work, a, b));
                }
            });
        }
    }
    return isAnyTooLong ? edges : CutEdges();
}

CutEdges longestEdges(const RefineWork& work, double length) {
    const CutEdges candidates = longEdges(work, length, false);
    struct Votes {
        std::uint32_t faces = 0;
        std::uint32_t longest = 0;
    };
    std::unordered_map<std::uint64_t, Votes, EdgeHash> votes;
    std::vector<std::uint64_t> ofFace;
    for (const Face& face : work.faces()) {
        std::optional<std::tuple<double, std::uint64_t, std::uint64_t>> longest;
        ofFace.clear();
        work.forSides(face, [&](std::uint32_t a, std::uint32_t b) {
            const std::uint64_t key = keyOf(work, a, b);
            // Two sides of a triangle with two corners at one place are one edge, and the face has one vote.
            const bool isNew = std::find(ofFace.begin(), ofFace.end(), key) == ofFace.end();
            if (isNew && candidates.contains(key)) {
                ofFace.push_back(key);
                ++votes[key].faces;
                const auto rank = std::tuple(work.squaredLength(a, b), mixed(key), key);
                longest = longest ? std::max(*longest, rank) : rank;
            }
        });
        if (longest) {
            ++votes[std::get<2>(*longest)].longest;
        }
    }
    CutEdges edges;
    for (const auto& [key, count] : votes) {
        if (count.faces == count.longest) {
            edges.try_emplace(key);
        }
    }
    return edges;
}

bool hasLongDiagonal(const RefineWork& work, const Face& face, double length) {
    const std::span<const RefineCorner> corners = work.cornersOf(face);
    if (!face.inRegion || corners.size() == 3) {
        return false;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < std::min(corners.size(), i + 3); ++j) {
            if (isTooLong(work, corners[i].vertex, corners[j].vertex, length)) {
                return true;
            }
        }
    }
    // However a larger polygon is cut: some diagonal is about as long as it is wide.
    Bounds box;
    for (const RefineCorner& corner : corners) {
        box.add(work.position(corner.vertex));
    }
    return corners.size() > 4 && static_cast<double>(box.diagonal()) > length;
}

double longestLength(const RefineWork& work) {
    double longest = 0.0;
    for (const Face& face : work.faces()) {
        if (face.inRegion) {
            work.forSides(face, [&](std::uint32_t a, std::uint32_t b) {
                longest = std::max(longest, work.squaredLength(a, b));
            });
        }
    }
    return std::sqrt(longest);
}

}  // namespace hitscope
