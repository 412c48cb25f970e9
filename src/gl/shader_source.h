// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "gl/program.h"

namespace hitscope::gl {

/// A shader's text, ready for the compiler, and the files it was put together from: file number i of its
/// #line directives is files[i].
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;
};

/// Puts the embedded file and what it includes together. A file comes in once, however often it is included.
[[nodiscard]] Result<ShaderSource> assembleShader(std::string_view file, const Defines& defines);

/// The driver's log with the file numbers at the start of its lines replaced by names; knows the styles of
/// Mesa, "0:12(5): error", of NVIDIA, "0(12) : error", and of AMD and Apple, "ERROR: 0:12: ".
[[nodiscard]] std::string nameFiles(std::string_view log, const std::vector<std::string>& files);

}  // namespace hitscope::gl
