// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <functional>
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
    std::string vertex = {};
    std::string fragment = {};  ///< empty: none (rasterizer discard)
    Defines defines = {};
    std::vector<std::string> captured = {};  ///< varyings for interleaved transform feedback, in order
    std::string compute = {};                ///< alone: no other stage is given
    std::string geometry = {};
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

    /// A mark that whoever fills large uniform arrays leaves, to see before the next draw whether the arrays
    /// are still as they left them: uniforms belong to the program, and its name is reused once it is gone.
    /// 0: nobody has.
    [[nodiscard]] std::uint64_t contentStamp() const { return m_contentStamp; }
    void setContentStamp(std::uint64_t stamp) const { m_contentStamp = stamp; }

private:
    /// Lets a string_view be looked up without making a string of it.
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const noexcept {
            return std::hash<std::string_view>()(text);
        }
    };
    GLuint m_id = 0;
    mutable std::unordered_map<std::string, GLint, Hash, std::equal_to<>> m_locations;
    mutable std::uint64_t m_contentStamp = 0;
};

}  // namespace hitscope::gl
