// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "deform/dent_shape.h"
#include "deform/hit.h"
#include "gl/objects.h"
#include "gl/program.h"

namespace hitscope {

/// Where shaders/hits.glsl finds the arrays: nine numbers a hit, whatever its constants; with forms ten, and
/// sixteen a curve.
enum class HitStorage : std::uint8_t {
    Floats,       ///< uniforms, one number of each hit in an array of floats of its own
    Vectors,      ///< uniforms, that number four to a vector: for drivers that give a float the room of four
    UniformBlock  ///< likewise, in a uniform buffer
};

/// Arrays, and how many hits they hold.
struct HitRoom {
    HitStorage storage = HitStorage::Floats;
    std::size_t hits = 0;
    std::size_t curves = 0;  ///< different ones; 0: hits have the paper's function alone

    [[nodiscard]] bool hasForms() const { return curves > 0; }
    bool operator==(const HitRoom&) const = default;
};

/// What the pipeline keeps at most: the paper's number.
inline constexpr std::size_t kMostArrayHits = 600;

/// Hits as the arrays of shaders/hits.glsl have them. A context is current for upload() and the destructor.
class HitArrays {
public:
    explicit HitArrays(const HitRoom& room) : m_room(room) {}

    /// Appends a hit, for which there is room.
    void add(const Hit& hit);
    [[nodiscard]] std::size_t size() const { return m_points.size(); }
    /// Whether all of these may be added yet.
    [[nodiscard]] bool hasRoom(std::span<const Hit> hits) const;

    /// Sets the arrays and u_hitCount. The program is in use, built with hitArrayDefines() of the same room.
    void upload(const gl::Program& program);
    /// What is not a program's own: binds the uniform buffer, where there is one, which others may have
    /// replaced.
    void bind(const gl::Program& program);

private:
    void fillBuffer();
    void uploadForms(const gl::Program& program) const;
    void set(const gl::Program& program, std::string_view array, std::span<const float> numbers) const;

    HitRoom m_room;
    std::vector<glm::vec4> m_points;      ///< and max_distance
    std::vector<glm::vec4> m_directions;  ///< and power
    std::vector<float> m_magnitudes;      ///< max_magnitude
    std::vector<float> m_forms;           ///< formCode()
    std::vector<CurveTerms> m_curves;
    std::map<CurveOrdinates, std::size_t> m_curvePlaces;  ///< equal ones share a place in m_curves
    gl::Buffer m_buffer;                                  ///< made when first bound
};

/// What makes hits.glsl loop over arrays of that room.
[[nodiscard]] gl::Defines hitArrayDefines(const HitRoom& room);

/// Hits that fit into so many components of uniforms beside kOtherUniforms for all else; at least 4, at most
/// kMostArrayHits.
[[nodiscard]] std::size_t hitsInUniforms(int components);
/// Hits that fit into a uniform block of so many bytes; at most kMostArrayHits.
[[nodiscard]] std::size_t hitsInBlock(int bytes);

/// The same with forms: as many hits as possible beside a few curves, then as many curves as there are hits.
[[nodiscard]] HitRoom formsInUniforms(HitStorage storage, int components);
[[nodiscard]] HitRoom formsInBlock(int bytes);

/// Components left for what the programs that draw targets need besides the hits: matrices, the eye,
/// settings.
inline constexpr int kOtherUniforms = 160;
/// Hits that take up at least kOtherUniforms, so that a program that links with so many more leaves that
/// room.
inline constexpr std::size_t kOtherUniformsInHits = 18;
inline constexpr std::size_t kOtherUniformsInForms = 16;

}  // namespace hitscope
