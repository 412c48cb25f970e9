// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench_gl/paper_feedback.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace hitscope::bench {

namespace {

GLsizeiptr bytesOf(const std::vector<DynamicVertex>& vertices) {
    return static_cast<GLsizeiptr>(vertices.size() * sizeof(DynamicVertex));
}

constexpr HitRoom kOneHit{HitStorage::Floats, 1};

void describeAttribute(Attribute attribute, std::size_t offset) {
    const auto index = static_cast<GLuint>(attribute);
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(DynamicVertex),
                          reinterpret_cast<const void*>(offset));
}

}  // namespace

Result<PaperFeedback::SharedProgram> PaperFeedback::makeProgram(const gl::Defines& deformDefines) {
    gl::Defines defines = hitArrayDefines(kOneHit);
    defines.insert(defines.end(), deformDefines.begin(), deformDefines.end());
    defines.emplace_back("HITSCOPE_OWN_HITS_ONLY", "1");
    Result<gl::Program> program =
        gl::Program::build({"capture.vert", {}, std::move(defines), {"capturedPosition", "capturedNormal"}});
    if (!program) {
        return program.error();
    }
    return SharedProgram(std::make_shared<gl::Program>(std::move(program).value()));
}

Result<PaperFeedback> PaperFeedback::create(std::span<const DynamicVertex> vertices,
                                            const gl::Defines& deformDefines) {
    Result<SharedProgram> program = makeProgram(deformDefines);
    if (!program) {
        return program.error();
    }
    return PaperFeedback(std::move(program).value(), vertices, nullptr);
}

Result<std::vector<PaperFeedback>> PaperFeedback::createOn(std::span<const Drawn> targets,
                                                           const gl::Defines& deformDefines) {
    const Result<SharedProgram> program = makeProgram(deformDefines);
    if (!program) {
        return program.error();
    }
    std::vector<PaperFeedback> all;
    for (const Drawn& target : targets) {
        all.push_back(PaperFeedback(program.value(), target.vertices, target.buffers));
    }
    return all;
}

PaperFeedback::PaperFeedback(SharedProgram program, std::span<const DynamicVertex> vertices,
                             const TargetBuffers* drawn)
    : m_program(std::move(program)),
      m_hit(kOneHit),
      m_framebuffer(1, 1),
      m_captured(gl::Buffer::make()),
      m_readBack(vertices.size()) {
    if (drawn != nullptr) {
        m_buffer = drawn->dynamicBuffer();
        m_array = drawn->captureArray();
    } else {
        m_ownBuffer = gl::Buffer::make();
        m_ownArray = gl::VertexArray::make();
        m_buffer = m_ownBuffer.id();
        m_array = m_ownArray.id();
    }
    restore(vertices);
    if (drawn == nullptr) {
        glBindVertexArray(m_array);
        glBindBuffer(GL_ARRAY_BUFFER, m_buffer);
        describeAttribute(Attribute::Position, offsetof(DynamicVertex, position));
        describeAttribute(Attribute::Normal, offsetof(DynamicVertex, normal));
        glBindVertexArray(0);
    }
    glBindBuffer(GL_ARRAY_BUFFER, m_captured.id());
    glBufferData(GL_ARRAY_BUFFER, bytesOf(m_mesh), nullptr, GL_STREAM_READ);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void PaperFeedback::restore(std::span<const DynamicVertex> vertices) {
    m_mesh.assign(vertices.begin(), vertices.end());
    upload();
}

void PaperFeedback::apply(const Hit& hit) {
    capture(hit);
    glBindBuffer(GL_COPY_READ_BUFFER, m_captured.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, bytesOf(m_readBack), m_readBack.data());
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    for (std::size_t i = 0; i < m_mesh.size(); ++i) {
        if (m_readBack[i].position != m_mesh[i].position || m_readBack[i].normal != m_mesh[i].normal) {
            m_mesh[i] = m_readBack[i];
        }
    }
    upload();
}

void PaperFeedback::capture(const Hit& hit) {
    m_hit = HitArrays(kOneHit);
    m_hit.add(hit);
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.framebuffer());
    glEnable(GL_RASTERIZER_DISCARD);
    m_program->use();
    m_hit.upload(*m_program);
    m_program->set("u_firstHit", 0);
    m_program->set("u_lastHit", 1);
    glBindVertexArray(m_array);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, m_captured.id());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(m_mesh.size()));
    glEndTransformFeedback();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glBindVertexArray(0);
    glUseProgram(0);  // left in use it would be gone behind the back of whoever puts it back later
    glDisable(GL_RASTERIZER_DISCARD);
}

void PaperFeedback::upload() {
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer);
    glBufferData(GL_ARRAY_BUFFER, bytesOf(m_mesh), m_mesh.data(), GL_DYNAMIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

}  // namespace hitscope::bench
