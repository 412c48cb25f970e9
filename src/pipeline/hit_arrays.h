// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "deform/hit.h"
#include "gl/program.h"

namespace hitscope {

/// Different deformation constants that the uniform arrays of hits.glsl hold.
inline constexpr std::size_t kHitConstants = 16;

/// Hits as the uniform arrays of shaders/hits.glsl have them.
class HitArrays {
public:
    /// capacity > 0: hits the arrays hold.
    explicit HitArrays(std::size_t capacity);

    /// Appends a hit; false, and nothing done, when there is no room for it or its constants. Empty arrays
    /// have room.
    [[nodiscard]] bool add(const Hit& hit);
    /// Whether add() takes them all.
    [[nodiscard]] bool hasRoom(std::span<const Hit> hits) const;
    [[nodiscard]] std::size_t size() const { return m_points.size(); }

    /// Sets the arrays and u_hitCount. The program is in use, built with hitArrayDefines(n), n >= size().
    void upload(const gl::Program& program) const;

private:
    std::size_t m_capacity;
    std::vector<glm::vec3> m_points;
    std::vector<glm::vec3> m_directions;
    std::vector<DeformationConstants> m_constants;  ///< the palette
    std::vector<GLuint> m_constantsIndex;           ///< four 8-bit palette indices a word
};

/// What makes hits.glsl loop over arrays of that many hits.
[[nodiscard]] gl::Defines hitArrayDefines(std::size_t hits);

/// How a driver counts a vec3 in an array against GL_MAX_VERTEX_UNIFORM_COMPONENTS: as the three numbers it
/// is, or as a whole register of four, and then a uint as well.
enum class UniformPacking : std::uint8_t { Tight, Registers };

/// Hits whose arrays fit into that many components, beside kOtherUniforms for all else; at least 4, at most
/// 600 (the paper's number).
[[nodiscard]] std::size_t hitsThatFit(int components, UniformPacking packing);

/// Components left for what the programs that draw targets need besides the hits: matrices, the eye,
/// settings.
inline constexpr int kOtherUniforms = 160;
/// Hits that take up at least kOtherUniforms, so that a program that links with so many more leaves that
/// room.
inline constexpr std::size_t kOtherUniformsInHits = 28;

}  // namespace hitscope
