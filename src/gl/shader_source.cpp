// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/shader_source.h"

#include <QFile>
#include <algorithm>
#include <charconv>
#include <optional>

// Outside every namespace, as Q_INIT_RESOURCE demands. A resource in a static library is only found once the
// linker has been given a reason to take it.
static void initShaderResource() {
    Q_INIT_RESOURCE(hitscope_shaders);
}

namespace hitscope::gl {
namespace {

// `precise` comes with GLSL 4.0; below that, an extension has it on nearly every driver. The directive has to
// stand before all code, so it stands in every shader.
constexpr std::string_view kPrelude =
    "#ifdef GL_ARB_gpu_shader5\n"
    "#extension GL_ARB_gpu_shader5 : enable\n"
    "#endif\n";
constexpr std::string_view kDefaultVersion = "#version 330 core";

std::optional<std::string> embeddedFile(std::string_view name) {
    initShaderResource();
    QFile file(QStringLiteral(":/shaders/") + QString::fromUtf8(name));
    if (!file.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    return file.readAll().toStdString();
}

std::string_view trimmedLeft(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    return start == std::string_view::npos ? std::string_view() : line.substr(start);
}

/// The file that `line` includes, if it is an #include "file" line.
std::optional<std::string_view> includedFile(std::string_view line) {
    constexpr std::string_view kDirective = "#include";
    line = trimmedLeft(line);
    if (!line.starts_with(kDirective)) {
        return std::nullopt;
    }
    line = trimmedLeft(line.substr(kDirective.size()));
    const std::size_t end = line.find('"', 1);
    if (!line.starts_with('"') || end == std::string_view::npos) {
        return std::nullopt;
    }
    return line.substr(1, end - 1);
}

std::string lineDirective(std::size_t line, std::size_t file) {
    return "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
}

class Assembler {
public:
    Status add(std::string_view name, const std::string& includedAt) {
        const std::optional<std::string> content = embeddedFile(name);
        if (!content) {
            return Error{"The shader file \"" + std::string(name) + "\" is not part of this program.",
                         includedAt, "Reinstall Hitscope, or rebuild it if you added the file."};
        }
        const std::size_t number = source.files.size();
        source.files.emplace_back(name);
        source.text += lineDirective(1, number);
        std::string_view rest = *content;
        for (std::size_t line = 1; !rest.empty(); ++line) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            Status added = addLine(rest.substr(0, end), number, line);
            if (!added) {
                return added;
            }
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return Done{};
    }

    ShaderSource source;
    std::string version{kDefaultVersion};

private:
    Status addLine(std::string_view text, std::size_t file, std::size_t line) {
        if (trimmedLeft(text).starts_with("#version")) {
            if (file == 0) {
                version = text;  // assembleShader() puts it on top
            }
            source.text += '\n';
            return Done{};
        }
        const std::optional<std::string_view> include = includedFile(text);
        if (!include) {
            source.text.append(text).append(1, '\n');
            return Done{};
        }
        if (std::find(source.files.begin(), source.files.end(), *include) == source.files.end()) {
            Status added = add(*include, source.files[file] + ":" + std::to_string(line));
            if (!added) {
                return added;
            }
        }
        source.text += lineDirective(line + 1, file);
        return Done{};
    }
};

/// Reads digits at `at`; nothing if there are none.
std::optional<std::size_t> number(std::string_view text, std::size_t& at) {
    std::size_t value = 0;
    const char* begin = text.data() + at;
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc()) {
        return std::nullopt;
    }
    at += static_cast<std::size_t>(end - begin);
    return value;
}

std::string nameFile(std::string_view line, const std::vector<std::string>& files) {
    std::size_t start = 0;
    for (const std::string_view prefix : {"ERROR: ", "WARNING: "}) {
        if (line.starts_with(prefix)) {
            start = prefix.size();
        }
    }
    std::size_t at = start;
    const std::optional<std::size_t> file = number(line, at);
    const bool hasPlace = file && *file < files.size() && at + 1 < line.size() &&
                          (line[at] == ':' || line[at] == '(') && line[at + 1] >= '0' && line[at + 1] <= '9';
    if (!hasPlace) {
        return std::string(line);
    }
    return std::string(line.substr(0, start)) + files[*file] + std::string(line.substr(at));
}

}  // namespace

Result<ShaderSource> assembleShader(std::string_view file, const Defines& defines) {
    Assembler assembler;
    const Status added = assembler.add(file, {});
    if (!added) {
        return added.error();
    }
    std::string top = assembler.version + "\n" + std::string(kPrelude);
    for (const auto& [name, value] : defines) {
        top += "#define " + name + " " + value + "\n";
    }
    assembler.source.text.insert(0, top);
    return std::move(assembler.source);
}

std::string nameFiles(std::string_view log, const std::vector<std::string>& files) {
    std::string named;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        named += nameFile(log.substr(0, end), files);
        if (end < log.size()) {
            named += '\n';
        }
        log.remove_prefix(std::min(end + 1, log.size()));
    }
    return named;
}

Result<std::string> loadShader(std::string_view file, const Defines& defines) {
    Result<ShaderSource> source = assembleShader(file, defines);
    if (!source) {
        return source.error();
    }
    return std::move(source.value().text);
}

}  // namespace hitscope::gl
