// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_mtl.h"

#include "io/export_names.h"
#include "io/number_text.h"

namespace hitscope {
namespace {

void appendColour(std::string& text, const char* key, const glm::vec3& colour) {
    text += key;
    for (int i = 0; i < 3; ++i) {
        text += ' ';
        appendNumber(text, colour[i]);
    }
    text += '\n';
}

}  // namespace

std::string formatMtl(const MeshData& mesh, const std::vector<std::string>& textures) {
    std::string text = "# Written by Hitscope " HITSCOPE_VERSION "\n";
    const std::vector<std::string> names = materialNames(mesh);
    for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
        const Material& material = mesh.materials[m];
        text += "\nnewmtl " + names[m] + '\n';
        appendColour(text, "Ka", material.ambient);
        appendColour(text, "Kd", material.diffuse);
        appendColour(text, "Ks", material.specular);
        text += "Ns ";
        appendNumber(text, material.shininess);
        text += "\nd ";
        appendNumber(text, material.opacity);
        text += "\nillum 2\n";
        if (const std::string texture = nameOnLine(textures[m]); !texture.empty()) {
            text += "map_Kd " + texture + '\n';
        }
    }
    return text;
}

}  // namespace hitscope
