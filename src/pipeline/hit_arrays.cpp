// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_arrays.h"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <string>

namespace hitscope {

namespace {
constexpr int kMostHits = 600;
constexpr int kLeastHits = 4;
constexpr int kHitsPerWord = 4;
constexpr std::size_t kBitsPerIndex = 8;
}  // namespace

HitArrays::HitArrays(std::size_t capacity) : m_capacity(capacity) {}

bool HitArrays::add(const Hit& hit) {
    if (m_points.size() >= m_capacity) {
        return false;
    }
    const auto known = std::find(m_constants.begin(), m_constants.end(), hit.constants);
    const auto index = static_cast<std::size_t>(known - m_constants.begin());
    if (known == m_constants.end()) {
        if (m_constants.size() >= kHitConstants) {
            return false;
        }
        m_constants.push_back(hit.constants);
    }
    const std::size_t place = m_points.size() % kHitsPerWord;
    if (place == 0) {
        m_constantsIndex.push_back(0);
    }
    m_constantsIndex.back() |= static_cast<GLuint>(index << (kBitsPerIndex * place));
    m_points.push_back(hit.point);
    m_directions.push_back(hit.direction);
    return true;
}

bool HitArrays::hasRoom(std::span<const Hit> hits) const {
    std::vector<DeformationConstants> palette = m_constants;
    for (const Hit& hit : hits) {
        if (std::find(palette.begin(), palette.end(), hit.constants) == palette.end()) {
            palette.push_back(hit.constants);
        }
    }
    return m_points.size() + hits.size() <= m_capacity && palette.size() <= kHitConstants;
}

void HitArrays::upload(const gl::Program& program) const {
    program.set("u_hitCount", static_cast<int>(m_points.size()));
    if (m_points.empty()) {
        return;
    }
    const auto count = static_cast<GLsizei>(m_points.size());
    glUniform3fv(program.location("u_hitPoints"), count, glm::value_ptr(m_points.front()));
    glUniform3fv(program.location("u_hitDirections"), count, glm::value_ptr(m_directions.front()));
    std::array<glm::vec3, kHitConstants> palette{};
    std::transform(
        m_constants.begin(), m_constants.end(), palette.begin(),
        [](const DeformationConstants& c) { return glm::vec3(c.maxDistance, c.power, c.maxMagnitude); });
    glUniform3fv(program.location("u_hitConstants"), static_cast<GLsizei>(m_constants.size()),
                 glm::value_ptr(palette.front()));
    glUniform1uiv(program.location("u_hitConstantsIndex"), static_cast<GLsizei>(m_constantsIndex.size()),
                  m_constantsIndex.data());
}

gl::Defines hitArrayDefines(std::size_t hits) {
    return {{"HITSCOPE_UNIFORM_HITS", std::to_string(hits)},
            {"HITSCOPE_HIT_CONSTANTS", std::to_string(kHitConstants)}};
}

std::size_t hitsThatFit(int components, UniformPacking packing) {
    const int vector = packing == UniformPacking::Tight ? 3 : 4;
    const int scalar = packing == UniformPacking::Tight ? 1 : 4;
    const int others = kOtherUniforms + static_cast<int>(kHitConstants) * vector + 3 * scalar;
    const int wordOfHits = kHitsPerWord * 2 * vector + scalar;  // point and direction, and the indices' word
    const int hits = (components - others) / wordOfHits * kHitsPerWord;
    return static_cast<std::size_t>(std::clamp(hits, kLeastHits, kMostHits));
}

}  // namespace hitscope
