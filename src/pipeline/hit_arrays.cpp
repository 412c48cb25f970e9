// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_arrays.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <set>
#include <string>

#include "pipeline/hit_batch.h"

namespace hitscope {

namespace {

constexpr int kLeastHits = 4;
constexpr int kComponentsPerHit = 9;
constexpr int kComponentsWithForm = 10;
constexpr int kComponentsPerCurve = 16;
constexpr int kFewCurves = 16;  // rather fewer hits than fewer of these
constexpr std::size_t kPerVector = 4;
constexpr std::size_t kVectorsPerCurve = sizeof(CurveTerms) / sizeof(glm::vec4);
/// Beside two of the last, incomplete vectors of magnitudes and forms.
constexpr int kBesideForms = 2 * 3;
/// Of the last, incomplete vector of magnitudes, and the three numbers that say which hits count, each in the
/// room of four.
constexpr int kBesideHits = 3 + 3 * 4;
constexpr GLuint kBinding = 7;  // of uniform buffers; nothing else here uses any

std::size_t vectorsFor(std::size_t hits) {
    return (hits + kPerVector - 1) / kPerVector;
}

HitRoom formsIn(HitStorage storage, int components) {
    const int most = static_cast<int>(kMostArrayHits);
    const int hits =
        std::clamp((components - kFewCurves * kComponentsPerCurve) / kComponentsWithForm, kLeastHits, most);
    const int curves = (components - hits * kComponentsWithForm) / kComponentsPerCurve;
    return {storage, static_cast<std::size_t>(hits), static_cast<std::size_t>(std::clamp(curves, 1, hits))};
}

}  // namespace

bool HitArrays::hasRoom(std::span<const Hit> hits) const {
    std::set<CurveOrdinates> curves;
    for (const Hit& hit : hits) {
        if (hit.form.profile == DentProfile::Curve && !m_curvePlaces.contains(hit.form.curve)) {
            curves.insert(hit.form.curve);
        }
    }
    return m_points.size() + hits.size() <= m_room.hits && m_curves.size() + curves.size() <= m_room.curves;
}

void HitArrays::add(const Hit& hit) {
    const DentShape shape = dentShapeOf(hit);
    m_points.emplace_back(shape.point, shape.reach);
    m_directions.emplace_back(shape.direction, shape.power);
    m_magnitudes.push_back(shape.magnitude);
    std::size_t place = 0;
    if (shape.kind == DentKind::Curve) {
        const auto [at, isNew] = m_curvePlaces.try_emplace(hit.form.curve, m_curves.size());
        place = at->second;
        if (isNew) {
            m_curves.push_back(shape.curve);
        }
    }
    m_forms.push_back(formCode(shape.kind, place));
}

void HitArrays::upload(const gl::Program& program) {
    program.set("u_hitCount", static_cast<int>(m_points.size()));
    if (m_points.empty() || m_room.storage == HitStorage::UniformBlock) {
        return;
    }
    const auto count = static_cast<GLsizei>(m_points.size());
    glUniform4fv(program.location("u_hitPoints"), count, glm::value_ptr(m_points.front()));
    glUniform4fv(program.location("u_hitDirections"), count, glm::value_ptr(m_directions.front()));
    set(program, "u_hitMagnitudes", m_magnitudes);
    if (m_room.hasForms()) {
        uploadForms(program);
    }
}

/// A number of each hit.
void HitArrays::set(const gl::Program& program, std::string_view array,
                    std::span<const float> numbers) const {
    const GLint location = program.location(array);
    if (m_room.storage == HitStorage::Floats) {
        glUniform1fv(location, static_cast<GLsizei>(numbers.size()), numbers.data());
        return;
    }
    std::vector<float> whole(numbers.begin(), numbers.end());
    whole.resize(kPerVector * vectorsFor(whole.size()));
    glUniform4fv(location, static_cast<GLsizei>(whole.size() / kPerVector), whole.data());
}

void HitArrays::uploadForms(const gl::Program& program) const {
    set(program, "u_hitForms", m_forms);
    if (!m_curves.empty()) {
        glUniform4fv(program.location("u_hitCurves"),
                     static_cast<GLsizei>(kVectorsPerCurve * m_curves.size()), m_curves.front().data());
    }
}

/// As std140 has the block of hits.glsl: arrays of vectors, one after the other.
void HitArrays::fillBuffer() {
    constexpr std::size_t kVector = sizeof(glm::vec4);
    const std::size_t packed = vectorsFor(m_room.hits);
    const std::size_t formVectors = m_room.hasForms() ? packed + kVectorsPerCurve * m_room.curves : 0;
    const std::size_t bytes = (2 * m_room.hits + packed + formVectors) * kVector;
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
    if (m_room.hasForms()) {
        put(2 * m_room.hits + packed, m_forms.data(), m_forms.size() * sizeof(float));
        put(2 * (m_room.hits + packed), m_curves.data(), m_curves.size() * sizeof(CurveTerms));
    }
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
    if (room.hasForms()) {
        defines.emplace_back("HITSCOPE_FORMS", std::to_string(room.curves));
    }
    return defines;
}

std::size_t hitsInUniforms(int components) {
    const int hits = (components - kOtherUniforms - kBesideHits) / kComponentsPerHit;
    return static_cast<std::size_t>(std::clamp(hits, kLeastHits, static_cast<int>(kMostArrayHits)));
}

HitRoom formsInUniforms(HitStorage storage, int components) {
    return formsIn(storage, components - kOtherUniforms - kBesideHits - kBesideForms);
}

HitRoom formsInBlock(int bytes) {
    return formsIn(HitStorage::UniformBlock, bytes / static_cast<int>(sizeof(float)) - kBesideForms);
}

std::size_t hitsInBlock(int bytes) {
    constexpr int kFloat = sizeof(float);
    const int hits = (bytes / kFloat - 3) / kComponentsPerHit;
    return static_cast<std::size_t>(std::clamp(hits, 0, static_cast<int>(kMostArrayHits)));
}

}  // namespace hitscope
