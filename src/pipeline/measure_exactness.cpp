// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/measure_exactness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <span>

#include "deform/deform.h"
#include "deform/dent_form.h"
#include "gl/objects.h"
#include "gl/program.h"
#include "mesh/render_mesh.h"
#include "pipeline/hit_batch.h"
#include "pipeline/keep_capture_state.h"
#include "pipeline/trial_random.h"

namespace hitscope {
namespace {

constexpr std::size_t kTestHits = 32;
constexpr std::size_t kVerticesPerHit = 256;
constexpr float kExtent = 2.5f;  // metres, as the paper's targets
constexpr GLsizei kCurveVectors = 4;

/// Hits, and vertices: the first kVerticesPerHit for the first hit, and so on.
struct Cases {
    std::vector<Hit> hits;
    std::vector<DynamicVertex> vertices;
};

/// Every kind but the paper's, in turn.
DentForm formOf(std::size_t index) {
    constexpr std::size_t kForms = kDentProfileKeys.size();
    DentForm form;
    if (index % kForms == 0) {
        form.direction = DentDirection::Press;
        form.radius = 0.05f + 0.1f * static_cast<float>(index);
    } else {
        form.profile = static_cast<DentProfile>(index % kForms);
        form.curve = {1.0f, 0.4f, 0.7f, 0.7f, -0.5f, -0.1f, 0.25f, 0.0f};
    }
    return form;
}

/// Makes the same cases every time, which the standard's distributions do not promise.
class CaseMaker {
public:
    /// Of the paper's function, or of the other forms.
    [[nodiscard]] Cases make(bool ofForms) {
        Cases cases;
        for (std::size_t i = 0; i < kTestHits; ++i) {
            cases.hits.push_back(hit(i));
            if (ofForms) {
                cases.hits.back().form = formOf(i);
            }
            for (std::size_t j = 0; j < kVerticesPerHit; ++j) {
                cases.vertices.push_back(vertex(cases.hits.back(), j));
            }
        }
        return cases;
    }

private:
    Hit hit(std::size_t index) {
        Hit hit;
        // Around the origin, coordinates near the hit are not rounded to those of the point.
        hit.point = index % 4 == 0 ? glm::vec3(0.0f) : m_random.direction() * (kExtent * m_random.uniform());
        hit.direction = m_random.direction();
        if (index % 2 == 1) {
            hit.constants.maxDistance = 0.1f + 4.0f * m_random.uniform();
            hit.constants.power = index % 8 == 7 ? 0.0f : m_random.uniform();
            hit.constants.maxMagnitude = m_random.uniform();
        }
        return hit;
    }

    /// In turn: at the rim (half of them), somewhere inside, where the cap begins, very near.
    DynamicVertex vertex(const Hit& hit, std::size_t index) {
        const DeformationConstants& constants = hit.constants;
        float distance = constants.maxDistance;
        if (index % 8 == 4 || index % 8 == 5) {
            distance *= m_random.uniform();
        } else if (index % 8 == 6 && constants.maxMagnitude > 0.0f) {
            distance = std::min(distance, constants.power / constants.maxMagnitude);
        } else if (index % 8 == 7) {
            distance *= std::pow(10.0f, -16.0f * m_random.uniform());
        }
        DynamicVertex vertex;
        vertex.position = hit.point + m_random.direction() * distance;
        const auto axis = static_cast<glm::length_t>(m_random.below(3));
        nudge(vertex.position[axis], static_cast<int>(m_random.below(9)) - 4);
        vertex.normal = m_random.direction();
        if (index % 16 == 5) {
            vertex.normal = -hit.direction;
        } else if (index % 16 == 13) {
            vertex.normal = glm::vec3(0.0f);
            vertex.normal[axis] = 1.0f;
        }
        return vertex;
    }

    /// By that many units in the last place.
    static void nudge(float& value, int steps) {
        const float end = std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(steps));
        for (int i = 0; i < std::abs(steps); ++i) {
            value = std::nextafter(value, end);
        }
    }

    TrialRandom m_random{20};
};

/// The cases' vertices in a buffer, and a buffer for what the shader makes of them.
class Rig {
public:
    explicit Rig(const Cases& cases)
        : m_cases(cases), m_bytes(cases.vertices.size() * sizeof(DynamicVertex)) {
        // Without a window there is no default framebuffer, and without any even a pass that draws nothing
        // fails.
        glBindRenderbuffer(GL_RENDERBUFFER, m_colour.id());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
        glBindRenderbuffer(GL_RENDERBUFFER, 0);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_framebuffer.id());
        glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_colour.id());
        glBindVertexArray(m_array.id());
        glBindBuffer(GL_ARRAY_BUFFER, m_vertices.id());
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(m_bytes), cases.vertices.data(),
                     GL_STATIC_DRAW);
        constexpr std::array<std::size_t, 2> kOffsets = {offsetof(DynamicVertex, position),
                                                         offsetof(DynamicVertex, normal)};
        for (GLuint attribute = 0; attribute < kOffsets.size(); ++attribute) {
            glEnableVertexAttribArray(attribute);
            // NOLINTNEXTLINE(performance-no-int-to-ptr): GL's way to say it
            const auto* offset = reinterpret_cast<const void*>(kOffsets[attribute]);
            glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(DynamicVertex), offset);
        }
    }

    /// The vertices as `program` deforms them.
    [[nodiscard]] std::vector<DynamicVertex> run(const gl::Program& program) const {
        std::vector<DynamicVertex> result(m_cases.vertices.size());
        glBindVertexArray(m_array.id());
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, m_captured.id());
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLsizeiptr>(m_bytes), result.data(),
                     GL_STREAM_READ);
        glEnable(GL_RASTERIZER_DISCARD);
        program.use();
        glBeginTransformFeedback(GL_POINTS);
        for (std::size_t i = 0; i < m_cases.hits.size(); ++i) {
            const DentShape dent = dentShapeOf(m_cases.hits[i]);
            program.set("u_point", dent.point);
            program.set("u_direction", dent.direction);
            program.set("u_constants", glm::vec3(dent.reach, dent.power, dent.magnitude));
            program.set("u_form", formCode(dent.kind, 0));
            glUniform4fv(program.location("u_curve"), kCurveVectors, dent.curve.data());
            glDrawArrays(GL_POINTS, static_cast<GLint>(i * kVerticesPerHit), kVerticesPerHit);
        }
        glEndTransformFeedback();
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(m_bytes), result.data());
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
        return result;
    }

private:
    const Cases& m_cases;
    std::size_t m_bytes;
    gl::Framebuffer m_framebuffer = gl::Framebuffer::make();
    gl::Renderbuffer m_colour = gl::Renderbuffer::make();
    gl::VertexArray m_array = gl::VertexArray::make();
    gl::Buffer m_vertices = gl::Buffer::make();
    gl::Buffer m_captured = gl::Buffer::make();
};

std::vector<DynamicVertex> onCpu(const Cases& cases) {
    std::vector<DynamicVertex> vertices = cases.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        deform(vertices[i].position, vertices[i].normal, cases.hits[i / kVerticesPerHit]);
    }
    return vertices;
}

/// One part of the function: what a program makes of its cases, held against the expected vertices.
class Part {
public:
    explicit Part(bool ofForms)
        : m_ofForms(ofForms),
          m_cases(CaseMaker().make(ofForms)),
          m_expected(onCpu(m_cases)),
          m_rig(m_cases) {}

    [[nodiscard]] Status measure(gl::Defines defines, VertexDifference& compared) const {
        if (m_ofForms) {
            defines.emplace_back("HITSCOPE_FORMS", "1");
        }
        const Result<gl::Program> program = gl::Program::build(
            {"selftest.vert", {}, std::move(defines), {"capturedPosition", "capturedNormal"}});
        if (!program) {
            return program.error();
        }
        compared.add(m_rig.run(program.value()), m_expected);
        return Done{};
    }

private:
    bool m_ofForms;
    Cases m_cases;
    std::vector<DynamicVertex> m_expected;
    Rig m_rig;
};

/// The defines' variant.
Result<Exactness> measure(std::span<const std::unique_ptr<Part>> parts, const gl::Defines& defines) {
    Exactness exactness;
    for (const std::unique_ptr<Part>& part : parts) {
        if (Status status = part->measure(defines, exactness.compared); !status) {
            return status.error();
        }
    }
    return exactness;
}

}  // namespace

gl::Defines definesOf(const Exactness& exactness) {
    if (!exactness.byFma) {
        return {};
    }
    return {{"HITSCOPE_EXACT_BY_FMA", "1"}};
}

Result<Exactness> measureExactness(const gl::Defines& defines) {
    const KeepCaptureState keep;
    std::array<std::unique_ptr<Part>, 2> parts;
    for (const bool ofForms : {false, true}) {
        parts[ofForms ? 1 : 0] = std::make_unique<Part>(ofForms);
    }
    Result<Exactness> native = measure(parts, defines);
    if (!native || native.value().isExact()) {
        return native;
    }
    gl::Defines withFma = defines;
    withFma.emplace_back("HITSCOPE_EXACT_BY_FMA", "1");
    Result<Exactness> corrected = measure(parts, withFma);
    if (!corrected || !corrected.value().isExact()) {
        return native;
    }
    corrected.value().byFma = true;
    return corrected;
}

}  // namespace hitscope
