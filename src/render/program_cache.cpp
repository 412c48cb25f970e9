// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/program_cache.h"

#include <utility>

namespace hitscope::render {

Result<const gl::Program*> ProgramCache::get(const std::string& vertex, const std::string& fragment,
                                             const gl::Defines& defines, const std::string& geometry) {
    auto key = std::make_tuple(vertex, geometry, fragment, defines);
    const auto known = m_programs.find(key);
    if (known != m_programs.end()) {
        return static_cast<const gl::Program*>(known->second.get());
    }
    if (m_mayBuild && (*m_mayBuild)-- <= 0) {
        m_hasRefused = true;
        return Error{"Another program is built later.", vertex, ""};
    }
    Result<gl::Program> built = gl::Program::build(
        {.vertex = vertex, .fragment = fragment, .defines = defines, .geometry = geometry});
    if (!built) {
        return built.error();
    }
    auto program = std::make_unique<gl::Program>(std::move(built).value());
    const gl::Program* result = program.get();
    m_programs.emplace(std::move(key), std::move(program));
    return result;
}

}  // namespace hitscope::render
