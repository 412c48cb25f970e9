// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "gl/program.h"

namespace hitscope::render {

/// Programs by what they are made of, each built once. A context is current for every call and the
/// destructor.
class ProgramCache {
public:
    /// The program lives as long as the cache. The error is the driver's, with file names.
    [[nodiscard]] Result<const gl::Program*> get(const std::string& vertex, const std::string& fragment,
                                                 const gl::Defines& defines = {},
                                                 const std::string& geometry = {});

    /// From now on get() builds so many programs and then refuses, by an error; nothing: any number.
    void limitBuilding(std::optional<int> most) {
        m_mayBuild = most;
        m_hasRefused = false;
    }
    /// Whether it has since.
    [[nodiscard]] bool hasRefused() const { return m_hasRefused; }

private:
    std::optional<int> m_mayBuild;
    bool m_hasRefused = false;
    std::map<std::tuple<std::string, std::string, std::string, gl::Defines>, std::unique_ptr<gl::Program>>
        m_programs;
};

}  // namespace hitscope::render
