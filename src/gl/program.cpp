// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/program.h"

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <memory>

#include "gl/shader_source.h"

namespace hitscope::gl {
namespace {

/// Owns a shader until the program that has it is linked.
class Shader {
public:
    explicit Shader(GLenum stage) : m_id(glCreateShader(stage)) {}
    ~Shader() { glDeleteShader(m_id); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    [[nodiscard]] GLuint id() const { return m_id; }

private:
    GLuint m_id;
};

std::string withoutTrailingSpace(std::string text) {
    text.erase(text.find_last_not_of(" \t\r\n\0") + 1);
    return text;
}

std::string shaderLog(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
    GLsizei written = 0;
    glGetShaderInfoLog(shader, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return withoutTrailingSpace(std::move(log));
}

std::string programLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
    GLsizei written = 0;
    glGetProgramInfoLog(program, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return withoutTrailingSpace(std::move(log));
}

Error refused(const std::string& where, const std::string& log) {
    return Error{"The graphics driver does not accept this shader:\n" + log, where,
                 "Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw in software."};
}

/// Compiles `file` into `shader` and attaches it to `program`.
Status attach(GLuint program, const Shader& shader, const std::string& file, const Defines& defines) {
    const Result<ShaderSource> source = assembleShader(file, defines);
    if (!source) {
        return source.error();
    }
    const char* text = source.value().text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        return refused(file, nameFiles(shaderLog(shader.id()), source.value().files));
    }
    glAttachShader(program, shader.id());
    return Done{};
}

Status link(GLuint program, const ProgramSource& source) {
    if (!source.captured.empty()) {
        std::vector<const char*> names;
        names.reserve(source.captured.size());
        for (const std::string& name : source.captured) {
            names.push_back(name.c_str());
        }
        glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    }
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string files = source.compute.empty() ? source.vertex : source.compute;
        if (!source.fragment.empty()) {
            files += " with " + source.fragment;
        }
        return refused(files, programLog(program));
    }
    return Done{};
}

}  // namespace

Result<Program> Program::build(const ProgramSource& source) {
    Program program;
    program.m_id = glCreateProgram();
    const std::array<std::pair<GLenum, const std::string&>, 4> stages = {
        {{GL_VERTEX_SHADER, source.vertex},
         {GL_GEOMETRY_SHADER, source.geometry},
         {GL_FRAGMENT_SHADER, source.fragment},
         {GL_COMPUTE_SHADER, source.compute}}};
    std::vector<std::unique_ptr<Shader>> shaders;  // until the program is linked
    for (const auto& [stage, file] : stages) {
        if (file.empty()) {
            continue;
        }
        shaders.push_back(std::make_unique<Shader>(stage));
        if (Status status = attach(program.m_id, *shaders.back(), file, source.defines); !status) {
            return status.error();
        }
    }
    if (Status status = link(program.m_id, source); !status) {
        return status.error();
    }
    return program;
}

Program::~Program() {
    if (m_id != 0) {
        glDeleteProgram(m_id);
    }
}

Program::Program(Program&& other) noexcept
    : m_id(std::exchange(other.m_id, 0)),
      m_locations(std::move(other.m_locations)),
      m_contentStamp(std::exchange(other.m_contentStamp, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(m_id, other.m_id);
    std::swap(m_locations, other.m_locations);
    std::swap(m_contentStamp, other.m_contentStamp);
    return *this;
}

void Program::use() const {
    glUseProgram(m_id);
}

GLint Program::location(std::string_view uniform) const {
    const auto known = m_locations.find(uniform);
    if (known != m_locations.end()) {
        return known->second;
    }
    std::string name(uniform);
    const GLint location = glGetUniformLocation(m_id, name.c_str());
    m_locations.emplace(std::move(name), location);
    return location;
}

void Program::set(std::string_view uniform, int value) const {
    glUniform1i(location(uniform), value);
}

void Program::set(std::string_view uniform, float value) const {
    glUniform1f(location(uniform), value);
}

void Program::set(std::string_view uniform, const glm::vec2& value) const {
    glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::vec3& value) const {
    glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::vec4& value) const {
    glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::mat3& value) const {
    glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(std::string_view uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace hitscope::gl
