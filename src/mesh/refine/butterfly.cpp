// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/refine/butterfly.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hitscope {

namespace {

constexpr std::uint32_t kSeveral = kNoIndex - 1;  // sides that run the same way
constexpr std::size_t kMostRing = 1000;           // a ring of more is taken for none

std::uint64_t sideKey(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t{from} << 32U | to;
}

/// Of the j-th of n places around one, and of that itself (j = n); n >= 3. Zorin et al., section 3.2.
double weight(std::size_t n, std::size_t j) {
    if (n == 3) {
        return j == 3 ? 0.75 : j == 0 ? 5.0 / 12.0 : -1.0 / 12.0;
    }
    if (n == 4) {
        return j == 4 ? 0.75 : j == 0 ? 0.375 : j == 2 ? -0.125 : 0.0;
    }
    if (j == n) {
        double rest = 1.0;
        for (std::size_t i = 0; i < n; ++i) {
            rest -= weight(n, i);
        }
        return rest;
    }
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    return (0.25 + std::cos(angle) + 0.5 * std::cos(2.0 * angle)) / static_cast<double>(n);
}

}  // namespace

Butterfly::Butterfly(const RefineWork& work) : m_work(work) {
    for (const RefineWork::Face& face : work.faces()) {
        const std::span<const RefineCorner> corners = work.cornersOf(face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t from = work.placeOf(corners[i]);
            const std::uint32_t to = work.placeOf(corners[(i + 1) % corners.size()]);
            const std::uint32_t third = work.placeOf(corners[(i + 2) % corners.size()]);
            if (!face.inRegion) {
                m_atBorder.insert(from);
            }
            const auto [known, isNew] =
                m_across.try_emplace(sideKey(from, to), corners.size() == 3 ? third : kSeveral);
            if (!isNew) {
                known->second = kSeveral;
            }
        }
    }
}

std::uint32_t Butterfly::across(std::uint32_t a, std::uint32_t b) const {
    const auto found = m_across.find(sideKey(a, b));
    return found == m_across.end() ? kNoIndex : found->second;
}

/// One or two triangles have the edge, and they run along it in both directions.
bool Butterfly::isClear(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t one = across(a, b);
    const std::uint32_t other = across(b, a);
    return one != kSeveral && other != kSeveral && (one != kNoIndex || other != kNoIndex);
}

std::vector<std::uint32_t> Butterfly::ring(std::uint32_t place, std::uint32_t first) const {
    std::vector<std::uint32_t> places;
    std::uint32_t next = first;
    do {
        places.push_back(next);
        next = across(next, place);
        if (next >= kSeveral || places.size() > kMostRing) {
            return {};
        }
    } while (next != first);
    return places;
}

glm::vec3 Butterfly::position(std::uint32_t a, std::uint32_t b) const {
    if (a > b) {
        std::swap(a, b);
    }
    if (m_atBorder.contains(a) || m_atBorder.contains(b) || !isClear(a, b)) {
        return glm::vec3(middle(a, b));
    }
    if (across(a, b) == kNoIndex || across(b, a) == kNoIndex) {
        return glm::vec3(onBoundary(a, b));
    }
    const std::vector<std::uint32_t> aroundA = ring(a, b);
    const std::vector<std::uint32_t> aroundB = ring(b, a);
    const auto isIrregular = [](const std::vector<std::uint32_t>& ring) {
        return ring.size() >= 3 && ring.size() != 6;
    };
    if (!isIrregular(aroundA) && !isIrregular(aroundB)) {
        return glm::vec3(fromEight(a, b));
    }
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (const auto& [place, around] : {std::pair(a, &aroundA), std::pair(b, &aroundB)}) {
        if (isIrregular(*around)) {
            sum += fromRing(place, *around);
            count += 1.0;
        }
    }
    return glm::vec3(sum / count);
}

glm::dvec3 Butterfly::fromRing(std::uint32_t place, const std::vector<std::uint32_t>& ring) const {
    glm::dvec3 sum = weight(ring.size(), ring.size()) * at(place);
    for (std::size_t j = 0; j < ring.size(); ++j) {
        sum += weight(ring.size(), j) * at(ring[j]);
    }
    return sum;
}

/// Halves of a and b, eighths of the two beside them, less sixteenths of the four beyond.
glm::dvec3 Butterfly::fromEight(std::uint32_t a, std::uint32_t b) const {
    glm::dvec3 sum = 0.5 * (at(a) + at(b));
    for (const std::uint32_t beside : {across(a, b), across(b, a)}) {
        sum += 0.125 * at(beside);
        for (const auto& [near, far] : {std::pair(a, b), std::pair(b, a)}) {
            // One of the two directions is in the triangle of a and b, the other in the one beyond.
            const std::uint32_t one = across(near, beside);
            const std::uint32_t other = across(beside, near);
            const std::uint32_t beyond = one == far ? other : one;
            sum -= 0.0625 * (beyond < kSeveral ? at(beyond) : at(near) + at(beside) - at(far));
        }
    }
    return sum;
}

/// The four-point scheme along the boundary.
glm::dvec3 Butterfly::onBoundary(std::uint32_t a, std::uint32_t b) const {
    if (across(a, b) == kNoIndex) {
        std::swap(a, b);
    }
    const std::uint32_t before = alongBoundary(a, b, false);
    const std::uint32_t after = alongBoundary(b, a, true);
    if (before >= kSeveral || after >= kSeveral) {
        return middle(a, b);
    }
    return 9.0 / 16.0 * (at(a) + at(b)) - 1.0 / 16.0 * (at(before) + at(after));
}

/// The next place along the boundary from `place`, where the triangles around it end; they begin at the
/// boundary edge to `from`.
std::uint32_t Butterfly::alongBoundary(std::uint32_t place, std::uint32_t from, bool isForward) const {
    std::uint32_t last = from;
    for (std::size_t steps = 0; steps <= kMostRing; ++steps) {
        const std::uint32_t next = isForward ? across(last, place) : across(place, last);
        if (next == kSeveral) {
            return kSeveral;
        }
        if (next == kNoIndex) {
            return last == from ? kSeveral : last;
        }
        last = next;
    }
    return kSeveral;
}

}  // namespace hitscope
