// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_arrays.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <string>

namespace hitscope {

namespace {

constexpr int kLeastHits = 4;
constexpr int kComponentsPerHit = 9;
constexpr std::size_t kPerVector = 4;
/// Of the last, incomplete vector of magnitudes, and the three numbers that say which hits count, each in the
/// room of four.
constexpr int kBesideHits = 3 + 3 * 4;
constexpr GLuint kBinding = 7;  // of uniform buffers; nothing else here uses any

std::size_t vectorsFor(std::size_t hits) {
    return (hits + kPerVector - 1) / kPerVector;
}

}  // namespace

void HitArrays::add(const Hit& hit) {
    m_points.emplace_back(hit.point, hit.constants.maxDistance);
    m_directions.emplace_back(hit.direction, hit.constants.power);
    m_magnitudes.push_back(hit.constants.maxMagnitude);
}

void HitArrays::upload(const gl::Program& program) {
    program.set("u_hitCount", static_cast<int>(m_points.size()));
    if (m_points.empty() || m_room.storage == HitStorage::UniformBlock) {
        return;
    }
    const auto count = static_cast<GLsizei>(m_points.size());
    glUniform4fv(program.location("u_hitPoints"), count, glm::value_ptr(m_points.front()));
    glUniform4fv(program.location("u_hitDirections"), count, glm::value_ptr(m_directions.front()));
    const GLint magnitudes = program.location("u_hitMagnitudes");
    if (m_room.storage == HitStorage::Floats) {
        glUniform1fv(magnitudes, count, m_magnitudes.data());
        return;
    }
    std::vector<float> whole = m_magnitudes;
    whole.resize(kPerVector * vectorsFor(whole.size()));
    glUniform4fv(magnitudes, static_cast<GLsizei>(whole.size() / kPerVector), whole.data());
}

/// As std140 has the block of hits.glsl: arrays of vectors, one after the other.
void HitArrays::fillBuffer() {
    constexpr std::size_t kVector = sizeof(glm::vec4);
    const std::size_t bytes = (2 * m_room.hits + vectorsFor(m_room.hits)) * kVector;
    m_buffer = gl::Buffer::make();
    glBindBuffer(GL_UNIFORM_BUFFER, m_buffer.id());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
    const auto put = [](std::size_t firstVector, const void* numbers, std::size_t size) {
        glBufferSubData(GL_UNIFORM_BUFFER, static_cast<GLintptr>(firstVector * kVector),
                        static_cast<GLsizeiptr>(size), numbers);
    };
    put(0, m_points.data(), m_points.size() * kVector);
    put(m_room.hits, m_directions.data(), m_directions.size() * kVector);
    put(2 * m_room.hits, m_magnitudes.data(), m_magnitudes.size() * sizeof(float));
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
}

void HitArrays::bind(const gl::Program& program) {
    if (m_room.storage != HitStorage::UniformBlock) {
        return;
    }
    if (!m_buffer) {
        fillBuffer();
    }
    const GLuint block = glGetUniformBlockIndex(program.id(), "HitArrays");
    if (block != GL_INVALID_INDEX) {
        glUniformBlockBinding(program.id(), block, kBinding);
        glBindBufferBase(GL_UNIFORM_BUFFER, kBinding, m_buffer.id());
    }
}

gl::Defines hitArrayDefines(const HitRoom& room) {
    gl::Defines defines{{"HITSCOPE_UNIFORM_HITS", std::to_string(room.hits)}};
    if (room.storage != HitStorage::Floats) {
        defines.emplace_back("HITSCOPE_PACKED_MAGNITUDES", "1");
    }
    if (room.storage == HitStorage::UniformBlock) {
        defines.emplace_back("HITSCOPE_HITS_IN_BLOCK", "1");
    }
    return defines;
}

std::size_t hitsInUniforms(int components) {
    const int hits = (components - kOtherUniforms - kBesideHits) / kComponentsPerHit;
    return static_cast<std::size_t>(std::clamp(hits, kLeastHits, static_cast<int>(kMostArrayHits)));
}

std::size_t hitsInBlock(int bytes) {
    constexpr int kFloat = sizeof(float);
    const int hits = (bytes / kFloat - 3) / kComponentsPerHit;
    return static_cast<std::size_t>(std::clamp(hits, 0, static_cast<int>(kMostArrayHits)));
}

}  // namespace hitscope
