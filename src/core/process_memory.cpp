// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process_memory.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace hitscope {

namespace {

constexpr double kKilobyte = 1024.0;

std::string folderOf(std::int64_t process) {
    return "/proc/" + std::to_string(process) + "/";
}

/// Of a line "NAME:   123 kB", bytes; 0: there is none.
double sizeIn(const std::string& path, const std::string& name) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        if (line.starts_with(name)) {
            return kKilobyte * std::strtod(line.c_str() + name.size(), nullptr);
        }
    }
    return 0.0;
}

}  // namespace

ProcessMemory memoryOf(std::int64_t process) {
    const std::string folder = folderOf(process);
    return {sizeIn(folder + "smaps_rollup", "Pss:"), sizeIn(folder + "status", "VmRSS:"),
            sizeIn(folder + "status", "VmHWM:")};
}

std::vector<std::int64_t> childrenOf(std::int64_t process) {
    std::vector<std::int64_t> children;
    std::error_code failed;
    for (std::filesystem::directory_iterator thread(folderOf(process) + "task", failed), end;
         !failed && thread != end; thread.increment(failed)) {
        std::ifstream file(thread->path() / "children");
        for (std::int64_t child = 0; file >> child;) {
            children.push_back(child);
        }
    }
    return children;
}

double memoryOfAll(std::int64_t process) {
    double bytes = memoryOf(process).share;
    for (const std::int64_t child : childrenOf(process)) {
        bytes += memoryOfAll(child);
    }
    return bytes;
}

}  // namespace hitscope
