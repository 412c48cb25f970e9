// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
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

private:
    std::map<std::tuple<std::string, std::string, std::string, gl::Defines>, std::unique_ptr<gl::Program>>
        m_programs;
};

}  // namespace hitscope::render
