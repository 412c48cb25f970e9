// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "deform/hit.h"
#include "gl/objects.h"
#include "gl/program.h"

namespace hitscope {

/// Where shaders/hits.glsl finds the arrays: nine numbers a hit, whatever its constants.
enum class HitStorage : std::uint8_t {
    Floats,       ///< uniforms, one number of each hit in an array of floats of its own
    Vectors,      ///< uniforms, that number four to a vector: for drivers that give a float the room of four
    UniformBlock  ///< likewise, in a uniform buffer
};

/// Arrays, and how many hits they hold.
struct HitRoom {
    HitStorage storage = HitStorage::Floats;
    std::size_t hits = 0;

    bool operator==(const HitRoom&) const = default;
};

/// What the pipeline keeps at most: the paper's number.
inline constexpr std::size_t kMostArrayHits = 600;

/// Hits as the arrays of shaders/hits.glsl have them. A context is current for upload() and the destructor.
class HitArrays {
public:
    explicit HitArrays(const HitRoom& room) : m_room(room) {}

    /// Appends a hit; size() < room.hits.
    void add(const Hit& hit);
    [[nodiscard]] std::size_t size() const { return m_points.size(); }
    /// Hits that may be added yet.
    [[nodiscard]] std::size_t left() const { return m_room.hits - m_points.size(); }

    /// Sets the arrays and u_hitCount. The program is in use, built with hitArrayDefines() of the same room.
    void upload(const gl::Program& program);
    /// What is not a program's own: binds the uniform buffer, where there is one, which others may have
    /// replaced.
    void bind(const gl::Program& program);

private:
    void fillBuffer();

    HitRoom m_room;
    std::vector<glm::vec4> m_points;      ///< and max_distance
    std::vector<glm::vec4> m_directions;  ///< and power
    std::vector<float> m_magnitudes;      ///< max_magnitude
    gl::Buffer m_buffer;                  ///< made when first bound
};

/// What makes hits.glsl loop over arrays of that room.
[[nodiscard]] gl::Defines hitArrayDefines(const HitRoom& room);

/// Hits that fit into so many components of uniforms beside kOtherUniforms for all else; at least 4, at most
/// kMostArrayHits.
[[nodiscard]] std::size_t hitsInUniforms(int components);
/// Hits that fit into a uniform block of so many bytes; at most kMostArrayHits.
[[nodiscard]] std::size_t hitsInBlock(int bytes);

/// Components left for what the programs that draw targets need besides the hits: matrices, the eye,
/// settings.
inline constexpr int kOtherUniforms = 160;
/// Hits that take up at least kOtherUniforms, so that a program that links with so many more leaves that
/// room.
inline constexpr std::size_t kOtherUniformsInHits = 18;

}  // namespace hitscope
