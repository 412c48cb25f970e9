// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/result.h"

namespace hitscope::gl {

/// Preprocessor definitions put below #version: name and value.
using Defines = std::vector<std::pair<std::string, std::string>>;

/// What a program is made of. File names are those in shaders/, embedded under :/shaders/.
struct ProgramSource {
    std::string vertex;
    std::string fragment;  ///< empty: none (rasterizer discard)
    Defines defines;
    std::vector<std::string> captured;  ///< varyings for interleaved transform feedback, in order
};

/// The text of an embedded shader with its #include "file" lines replaced and #line kept, so that a driver's
/// message names the file and line. The error names a missing file. No context needed.
[[nodiscard]] Result<std::string> loadShader(std::string_view file, const Defines& defines = {});

/// A linked program and its uniform locations. Setting a uniform the program does not use is not an error.
class Program {
public:
    /// Compiles and links; the error carries the driver's log with file names. A context is current.
    [[nodiscard]] static Result<Program> build(const ProgramSource& source);
    Program() = default;
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;

    [[nodiscard]] GLuint id() const { return m_id; }
    void use() const;
    [[nodiscard]] GLint location(std::string_view uniform) const;  ///< -1: not in the program

    // The program is in use.
    void set(std::string_view uniform, int value) const;
    void set(std::string_view uniform, float value) const;
    void set(std::string_view uniform, const glm::vec2& value) const;
    void set(std::string_view uniform, const glm::vec3& value) const;
    void set(std::string_view uniform, const glm::vec4& value) const;
    void set(std::string_view uniform, const glm::mat3& value) const;
    void set(std::string_view uniform, const glm::mat4& value) const;

private:
    GLuint m_id = 0;
    mutable std::unordered_map<std::string, GLint> m_locations;
};

}  // namespace hitscope::gl
