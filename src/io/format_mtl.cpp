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

void appendNormalMap(std::string& text, const NormalMap& map, const std::string& name) {
    if (name.empty()) {
        return;
    }
    text += map.kind == NormalMap::Kind::Bump ? "map_Bump " : "norm ";
    if (map.strength != 1.0f) {
        text += "-bm ";
        appendNumber(text, map.strength);
        text += ' ';
    }
    text += name + '\n';
}

void appendMetalRoughness(std::string& text, const MetalRoughness& metal, const std::string& name) {
    if (!metal.isGiven()) {
        return;
    }
    text += "Pr ";
    appendNumber(text, metal.roughness);
    text += "\nPm ";
    appendNumber(text, metal.metalness);
    text += '\n';
    if (!name.empty()) {
        text += "map_Pr " + name + "\nmap_Pm " + name + '\n';
    }
}

}  // namespace

std::string formatMtl(const MeshData& mesh, const std::vector<PlacedTextures>& textures) {
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
        if (const std::string texture = nameOnLine(textures[m].diffuse); !texture.empty()) {
            text += "map_Kd " + texture + '\n';
        }
        appendNormalMap(text, material.normalMap, nameOnLine(textures[m].normals));
        appendMetalRoughness(text, material.metalRoughness, nameOnLine(textures[m].metalRoughness));
    }
    return text;
}

}  // namespace hitscope
