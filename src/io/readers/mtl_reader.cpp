// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/mtl_reader.h"

#include <tiny_obj_loader.h>

#include <QFile>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <unordered_map>

#include "io/file_scope.h"
#include "io/mtl_lines.h"
#include "io/readers/text_cursor.h"

namespace hitscope {
namespace {

/// What is read here, since releases of tinyobjloader differ in it, or do not tell.
struct Given {
    std::string name;      ///< with the blanks inside it, which some cut it at
    bool diffuse = false;  // which colours there are: a missing one is read as black
    bool specular = false;
    bool ambient = false;
    bool roughness = false;
    bool metalness = false;
};

std::string_view withoutBlanksAtEnd(std::string_view text) {
    const std::size_t last = text.find_last_not_of(" \t");
    return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

std::vector<Given> givenOf(std::string_view text) {
    std::vector<Given> given;
    for (TextCursor lines(text); !lines.atEnd();) {
        TextCursor line(lines.line());
        const std::string_view keyword = line.word();
        line.skipBlanks();
        if (keyword == "newmtl" && !line.atEnd()) {
            given.push_back({std::string(withoutBlanksAtEnd(line.rest()))});
        } else if (!given.empty()) {
            given.back().diffuse = given.back().diffuse || keyword == "Kd";
            given.back().specular = given.back().specular || keyword == "Ks";
            given.back().ambient = given.back().ambient || keyword == "Ka";
            given.back().roughness = given.back().roughness || keyword == "Pr";
            given.back().metalness = given.back().metalness || keyword == "Pm";
        }
    }
    return given;
}

/// Releases of tinyobjloader take three words for numbers where fewer may be, the picture's name among them:
/// of map lines they get what they cannot mistake.
std::string withPlainMaps(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    for (TextCursor lines(text); !lines.atEnd();) {
        const std::string_view line = lines.line();
        if (const std::optional<MtlMap> map = mtlMapOf(line)) {
            plain += map->keyword;
            plain.append(map->bumps.empty() ? "" : " -bm ").append(map->bumps);
            plain.append(" ").append(map->name);
        } else {
            plain += line;
        }
        plain += '\n';
    }
    return plain;
}

glm::vec3 colour(const tinyobj::real_t* c, bool given, const glm::vec3& otherwise) {
    glm::vec3 result = otherwise;
    for (int i = 0; given && i < 3; ++i) {
        result[i] = std::isfinite(c[i]) ? std::clamp(c[i], 0.0f, 1.0f) : otherwise[i];
    }
    return result;
}

/// `norm` before `map_Bump`: who writes both means the second for programs that know no other.
NormalMap normalMapOf(const tinyobj::material_t& from) {
    NormalMap map;
    const bool isBump = from.normal_texname.empty();
    map.kind = isBump ? NormalMap::Kind::Bump : NormalMap::Kind::Normals;
    map.texture = isBump ? from.bump_texname : from.normal_texname;
    const float strength = (isBump ? from.bump_texopt : from.normal_texopt).bump_multiplier;
    map.strength = std::isfinite(strength) ? strength : 1.0f;
    return map;
}

float fraction(float value, float otherwise) {
    return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : otherwise;
}

/// The maps are grey, each of its own. Where they are one picture it is taken to be glTF's, whose colours
/// tell them apart; without metalness only the roughness of it counts. Others are not drawn.
MetalRoughness metalRoughnessOf(const tinyobj::material_t& from, const Given& given) {
    MetalRoughness metal;
    const std::string& roughnessMap = from.roughness_texname;
    const std::string& metalnessMap = from.metallic_texname;
    if (!given.roughness && !given.metalness && roughnessMap.empty() && metalnessMap.empty()) {
        return metal;
    }
    constexpr float kUsual = 0.5f;
    const bool isOne = !roughnessMap.empty() && roughnessMap == metalnessMap;
    metal.metalness = given.metalness ? fraction(from.metallic, 0.0f) : isOne ? 1.0f : 0.0f;
    const bool isMapped = isOne || (!roughnessMap.empty() && metal.metalness == 0.0f && metalnessMap.empty());
    metal.roughness = given.roughness ? fraction(from.roughness, kUsual) : isMapped ? 1.0f : kUsual;
    if (isMapped) {
        metal.texture = roughnessMap;
    }
    return metal;
}

Material convert(const tinyobj::material_t& from, const Given& given) {
    Material material;
    material.name = given.name;
    material.ambient = colour(from.ambient, given.ambient, material.ambient);
    material.diffuse = colour(from.diffuse, given.diffuse, material.diffuse);
    material.specular = colour(from.specular, given.specular, material.specular);
    material.shininess = std::isfinite(from.shininess) && from.shininess > 0.0f ? from.shininess : 1.0f;
    material.opacity = std::isfinite(from.dissolve) ? std::clamp(from.dissolve, 0.0f, 1.0f) : 1.0f;
    material.diffuseTexture = from.diffuse_texname;
    material.normalMap = normalMapOf(from);
    material.metalRoughness = metalRoughnessOf(from, given);
    return material;
}

/// Of a kind that is not drawn.
QStringList otherMaps(const tinyobj::material_t& from) {
    QStringList maps;
    for (const std::string* name :
         {&from.ambient_texname, &from.specular_texname, &from.specular_highlight_texname, &from.bump_texname,
          &from.displacement_texname, &from.alpha_texname, &from.reflection_texname, &from.roughness_texname,
          &from.metallic_texname, &from.sheen_texname, &from.emissive_texname}) {
        if (!name->empty()) {
            maps << fileNameText(*name);
        }
    }
    return maps;
}

class LibraryMerger {
public:
    explicit LibraryMerger(MeshData& mesh) : m_mesh(mesh) {
        for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
            m_index.emplace(mesh.materials[m].name, m);
        }
        m_known.resize(mesh.materials.size());
    }
    void add(const Material& material) {
        const auto [at, isNew] = m_index.try_emplace(material.name, m_mesh.materials.size());
        if (isNew) {
            m_mesh.materials.push_back(material);
            m_known.push_back(true);
        } else if (!m_known[at->second]) {  // the first definition counts
            m_mesh.materials[at->second] = material;
            m_known[at->second] = true;
        }
    }
    [[nodiscard]] QStringList missing() const {
        QStringList names;
        for (std::size_t m = 0; m < m_known.size(); ++m) {
            if (!m_known[m]) {
                names += QString::fromStdString(m_mesh.materials[m].name);
            }
        }
        return names;
    }

private:
    MeshData& m_mesh;
    std::unordered_map<std::string, std::size_t> m_index;
    std::vector<bool> m_known;
};

}  // namespace

std::vector<Material> parseMtl(const std::string& text, QStringList* others) {
    const std::string plain = mtlText(text);
    std::map<std::string, int> index;
    std::vector<tinyobj::material_t> parsed;
    std::string warning;
    std::string error;
    std::istringstream stream(withPlainMaps(plain));
    tinyobj::LoadMtl(&index, &parsed, &stream, &warning, &error);
    const std::vector<Given> given = givenOf(plain);
    std::vector<Material> materials;
    for (std::size_t m = 0; m < parsed.size(); ++m) {
        if (m < given.size()) {  // a file without newmtl gives one nameless material
            materials.push_back(convert(parsed[m], given[m]));
            if (others != nullptr) {
                *others << otherMaps(parsed[m]);
            }
        }
    }
    return materials;
}

QStringList readMaterialLibraries(ImportedMesh& imported, const QString& folder) {
    LibraryMerger merger(imported.mesh);
    QStringList names;
    QStringList others;
    for (const std::string& line : imported.mesh.materialLibraries) {
        names += librariesOnLine(folder, fileNameText(line));
    }
    names.removeDuplicates();
    for (const QString& name : names) {
        QFile file(resolveInside(folder, name));
        if (file.fileName().isEmpty() || !file.open(QIODevice::ReadOnly) || file.size() > kMaxLibraryBytes) {
            imported.notes +=
                QStringLiteral("The material file \"%1\" is not in the mesh's folder or cannot be read.")
                    .arg(name);
            continue;
        }
        QStringList otherNames;
        for (Material& material : parseMtl(file.readAll().toStdString(), &otherNames)) {
            for (std::string* texture :
                 {&material.diffuseTexture, &material.normalMap.texture, &material.metalRoughness.texture}) {
                *texture = textureOfLibrary(folder, name, *texture);
            }
            merger.add(material);
        }
        for (const QString& other : otherNames) {
            others << QString::fromStdString(textureOfLibrary(folder, name, other.toStdString()));
        }
    }
    if (const QStringList missing = merger.missing(); !missing.isEmpty()) {
        imported.notes += QStringLiteral("No definition was found for the material%1 %2; shown in grey.")
                              .arg(missing.size() == 1 ? QString() : QStringLiteral("s"),
                                   missing.mid(0, 5).join(QStringLiteral(", ")) +
                                       (missing.size() > 5 ? QStringLiteral(" and others") : QString()));
    }
    return others;
}

}  // namespace hitscope
