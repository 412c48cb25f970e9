// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/export_names.h"

#include <algorithm>
#include <unordered_set>

namespace hitscope {

std::string nameOnLine(std::string_view name) {
    std::string result(name);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; },
        ' ');
    const std::size_t first = result.find_first_not_of(' ');
    if (first == std::string::npos) {
        return {};
    }
    result.erase(result.find_last_not_of(' ') + 1);
    result.erase(0, first);
    if (result.back() == '\\') {  // would join the next line to this one
        result.back() = '/';
    }
    return result;
}

std::vector<std::string> materialNames(const MeshData& mesh) {
    std::vector<std::string> names;
    std::unordered_set<std::string> taken;
    for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
        std::string name = nameOnLine(mesh.materials[m].name);
        if (name.empty()) {
            name = "material_" + std::to_string(m + 1);
        }
        const std::string base = name;
        for (int n = 2; !taken.insert(name).second; ++n) {
            name = base + "_" + std::to_string(n);
        }
        names.push_back(name);
    }
    return names;
}

}  // namespace hitscope
