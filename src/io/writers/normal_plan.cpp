// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/normal_plan.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/finite.h"
#include "core/give_up.h"
#include "core/parallel.h"
#include "io/welder.h"
#include "mesh/same_bits.h"

namespace hitscope {
namespace {

constexpr std::size_t kLeastPart = 1 << 17;  // of a loop over vertices, faces or corners

// What several threads may write at once, all of them the same.
template <class Number>
void setShared(Number& what, Number value) {
    std::atomic_ref(what).store(value, std::memory_order_relaxed);
}
template <class Number>
Number readShared(Number& what) {
    return std::atomic_ref(what).load(std::memory_order_relaxed);
}

/// Vertices whose corners may have another normal now: those of faces of which a vertex moved. Empty: none.
std::vector<std::uint8_t> touchedVertices(const MeshData& mesh, std::span<const std::uint8_t> moved) {
    if (std::find(moved.begin(), moved.end(), 1) == moved.end()) {
        return {};
    }
    if (std::find(moved.begin(), moved.end(), 0) == moved.end()) {
        return {moved.begin(), moved.end()};
    }
    std::vector<std::uint8_t> touched(moved.size());
    inWatchedParts(mesh.faceCount(), kLeastPart, [&](std::size_t first, std::size_t end) {
        for (std::size_t f = first; f < end; ++f) {
            std::uint8_t isTouched = 0;
            for (const std::uint32_t vertex : mesh.face(f)) {
                isTouched |= moved[vertex];
            }
            if (isTouched != 0) {
                for (const std::uint32_t vertex : mesh.face(f)) {
                    setShared<std::uint8_t>(touched[vertex], 1);  // faces of another part may have it too
                }
            }
        }
    });
    return touched;
}

/// Of unit length, or not numbers where it has none.
glm::vec3 directionOf(const glm::vec3& normal) {
    const float length = glm::length(normal);
    return length > 0.0f && std::isfinite(length) ? normal / length
                                                  : glm::vec3(std::numeric_limits<float>::quiet_NaN());
}

bool isNear(const glm::vec3& direction, const glm::vec3& now) {
    constexpr float kRounding = 1e-6f;
    const glm::vec3 gap = direction - now;
    // glm::abs() branches by the sign, which cannot be foretold.
    return std::abs(gap.x) <= kRounding && std::abs(gap.y) <= kRounding && std::abs(gap.z) <= kRounding;
}

class Planner {
public:
    Planner(const MeshData& mesh, const CornerNormalView& normals) : m_mesh(mesh), m_normals(normals) {}

    NormalPlan plan(std::vector<std::uint8_t> touched, bool all);

private:
    [[nodiscard]] std::uint32_t inFile(std::size_t corner) const {
        return m_mesh.cornerNormals.empty() ? kNoIndex : m_mesh.cornerNormals[corner];
    }
    [[nodiscard]] bool isTouched(std::size_t corner) const {
        return !m_touched.empty() && m_touched[m_mesh.cornerVertices[corner]] != 0;
    }
    [[nodiscard]] bool isOther(std::uint32_t normal, std::size_t slot) const {
        return !isSameDirection(m_mesh.normals[normal], m_normals.values[slot]);
    }
    void findWanted();
    void replace();
    void findDirections();
    void findCorners(bool all);
    [[nodiscard]] std::uint64_t cornersOfWord(std::size_t word, bool all);
    void number();

    const MeshData& m_mesh;
    const CornerNormalView& m_normals;
    std::vector<std::uint8_t> m_touched;   // of vertices
    std::vector<std::uint32_t> m_wanted;   // for each of the file's normals, a slot that differs
    std::vector<std::uint8_t> m_isKept;    // by one of its corners
    std::vector<std::uint8_t> m_isShared;  // its corners want different ones
    std::vector<glm::vec3> m_directions;   // of those, made unit length
    std::vector<std::uint8_t> m_isUsed;    // slots of m_normals that corners are to have instead
    NormalPlan m_plan;
};

/// Which of the file's normals no corner keeps, and which their corners want to become different ones.
void Planner::findWanted() {
    inWatchedParts(m_mesh.cornerNormals.size(), kLeastPart, [this](std::size_t first, std::size_t end) {
        for (std::size_t c = first; c < end; ++c) {
            const std::uint32_t normal = inFile(c);
            if (normal == kNoIndex || readShared(m_isShared[normal]) != 0) {
                continue;
            }
            const auto slot = static_cast<std::uint32_t>(m_normals.slot(c));
            if (!isTouched(c) || !isOther(normal, slot)) {
                if (readShared(m_isKept[normal]) == 0) {  // writing needlessly would slow the other threads
                    setShared<std::uint8_t>(m_isKept[normal], 1);
                }
                continue;
            }
            const std::atomic_ref wanted(m_wanted[normal]);
            std::uint32_t other = kNoIndex;
            if (!wanted.compare_exchange_strong(other, slot, std::memory_order_relaxed) && other != slot &&
                !sameBits(m_normals.values[slot], m_normals.values[other])) {
                setShared<std::uint8_t>(m_isShared[normal], 1);
            }
        }
    });
    for (std::size_t n = 0; n < m_wanted.size(); ++n) {
        if (m_wanted[n] != kNoIndex && m_isKept[n] != 0) {
            m_isShared[n] = 1;
        }
    }
}

void Planner::replace() {
    for (std::size_t n = 0; n < m_wanted.size(); ++n) {
        mayGiveUp(n);
        if (m_wanted[n] != kNoIndex && m_isShared[n] == 0) {
            m_plan.replaced.push_back(static_cast<std::uint32_t>(n));
        }
    }
    m_plan.values.resize(m_plan.replaced.size());
    inWatchedParts(m_plan.values.size(), kLeastPart, [this](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const glm::vec3& value = m_normals.values[m_wanted[m_plan.replaced[i]]];
            m_plan.values[i] = isFinite(value) ? value : glm::vec3(0.0f);
        }
    });
}

std::uint64_t Planner::cornersOfWord(std::size_t word, bool all) {
    std::uint64_t bits = 0;
    const std::size_t first = word * CornerSet::kBits;
    const std::size_t end = std::min(first + CornerSet::kBits, m_mesh.cornerVertices.size());
    for (std::size_t c = first; c < end; ++c) {
        const std::uint32_t normal = inFile(c);
        const bool changes = normal == kNoIndex ? all
                                                : m_isShared[normal] != 0 && isTouched(c) &&
                                                      !isNear(m_directions[normal], m_normals[c]) &&
                                                      !sameBits(m_mesh.normals[normal], m_normals[c]);
        if (changes) {
            bits |= std::uint64_t{1} << (c - first);
            setShared<std::uint8_t>(m_isUsed[m_normals.slot(c)], 1);
        }
    }
    return bits;
}

void Planner::findDirections() {
    m_directions.resize(m_isShared.size());
    inWatchedParts(m_isShared.size(), kLeastPart, [this](std::size_t first, std::size_t end) {
        for (std::size_t n = first; n < end; ++n) {
            if (m_isShared[n] != 0) {
                m_directions[n] = directionOf(m_mesh.normals[n]);
            }
        }
    });
}

void Planner::findCorners(bool all) {
    std::vector<std::uint64_t>& words = m_plan.corners.words();
    words.resize((m_mesh.cornerVertices.size() + CornerSet::kBits - 1) / CornerSet::kBits);
    m_isUsed.resize(m_normals.values.size());
    inWatchedParts(words.size(), kLeastPart / CornerSet::kBits, [&](std::size_t first, std::size_t end) {
        for (std::size_t word = first; word < end; ++word) {
            words[word] = cornersOfWord(word, all);
        }
    });
}

/// Each value once, in the order of the slots.
void Planner::number() {
    m_plan.numbers.resize(m_isUsed.size());
    Welder added(m_plan.added);
    const auto before = static_cast<std::uint32_t>(m_mesh.normals.size());
    for (std::size_t slot = 0; slot < m_isUsed.size(); ++slot) {
        mayGiveUp(slot);
        if (m_isUsed[slot] != 0) {
            const glm::vec3& normal = m_normals.values[slot];
            m_plan.numbers[slot] = before + added.index(isFinite(normal) ? normal : glm::vec3(0.0f));
        }
    }
}

NormalPlan Planner::plan(std::vector<std::uint8_t> touched, bool all) {
    m_plan.normals = m_normals;
    m_touched = std::move(touched);
    m_wanted.assign(m_mesh.normals.size(), kNoIndex);
    m_isKept.assign(m_mesh.normals.size(), 0);
    m_isShared.assign(m_mesh.normals.size(), 0);
    if (!m_touched.empty()) {
        findWanted();
        replace();
    }
    if (all || std::find(m_isShared.begin(), m_isShared.end(), 1) != m_isShared.end()) {
        findDirections();
        findCorners(all);
        number();
        const std::vector<std::uint32_t>& corners = m_mesh.cornerNormals;
        m_plan.hasDangling =
            !m_plan.added.empty() && std::find(corners.begin(), corners.end(), kNoIndex) != corners.end();
    }
    return std::move(m_plan);
}

}  // namespace

bool CornerSet::hasBetween(std::size_t first, std::size_t end) const {
    if (empty() || first >= end) {
        return false;
    }
    const std::size_t last = (end - 1) / kBits;
    std::size_t word = first / kBits;
    std::uint64_t bits = m_words[word] & (~std::uint64_t{0} << first % kBits);
    while (word < last && bits == 0) {
        bits = m_words[++word];
    }
    return (word < last ? bits : bits & (~std::uint64_t{0} >> (kBits - 1 - (end - 1) % kBits))) != 0;
}

bool isSameDirection(const glm::vec3& original, const glm::vec3& now) {
    return sameBits(original, now) || isNear(directionOf(original), now);
}

std::vector<std::uint8_t> movedVertices(const MeshData& mesh, std::span<const glm::vec3> positions) {
    std::vector<std::uint8_t> moved(positions.size());
    inWatchedParts(positions.size(), kLeastPart, [&](std::size_t first, std::size_t end) {
        for (std::size_t v = first; v < end; ++v) {
            moved[v] = sameBits(positions[v], mesh.positions[v]) ? 0 : 1;
        }
    });
    return moved;
}

NormalPlan planNormals(const MeshData& mesh, std::span<const std::uint8_t> moved,
                       const CornerNormalView& normals, bool all) {
    const bool concerns = !normals.empty() && (all || !mesh.cornerNormals.empty());
    return concerns ? Planner(mesh, normals).plan(touchedVertices(mesh, moved), all) : NormalPlan();
}

}  // namespace hitscope
