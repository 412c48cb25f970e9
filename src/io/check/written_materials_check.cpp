// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/check/written_materials_check.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "io/export_files.h"
#include "io/export_names.h"
#include "io/file_scope.h"
#include "io/mtl_lines.h"
#include "io/staged_files.h"

namespace hitscope {
namespace {

using Unlikeness = std::optional<std::string>;  ///< what differs; none: nothing

QString sourceFolderOf(const MeshExport& what) {
    return what.sourcePath.isEmpty() ? what.sourceFolder : QFileInfo(what.sourcePath).absolutePath();
}

/// The MTL files that a mesh names and that are there.
std::vector<QString> librariesOf(const MeshData& mesh, const QString& folder) {
    std::vector<QString> paths;
    for (const std::string& line : mesh.materialLibraries) {
        for (const QString& name : librariesOnLine(folder, fileNameText(line))) {
            QString path = resolveInside(folder, name);
            if (!path.isEmpty() && QFileInfo(path).size() <= kMaxLibraryBytes) {
                paths.push_back(std::move(path));
            }
        }
    }
    return paths;
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::string_view viewOf(const QByteArray& bytes) {
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

/// But for the names of pictures.
bool isCopy(const QByteArray& copy, const QByteArray& source) {
    const char end = mtlLineEnd(viewOf(source));
    const QList<QByteArray> is = copy.split(end);
    const QList<QByteArray> meant = source.split(end);
    return std::equal(is.begin(), is.end(), meant.begin(), meant.end(),
                      [](const QByteArray& a, const QByteArray& b) {
                          if (a == b) {
                              return true;
                          }
                          const std::optional<MtlMap> map = mtlMapOf(viewOf(a));
                          const std::optional<MtlMap> other = mtlMapOf(viewOf(b));
                          return map && other && map->keyword == other->keyword;
                      });
}

Unlikeness libraryDifference(const MeshData& read, const MeshData& meant, const QString& sourceFolder,
                             const QString& folder) {
    const std::vector<QString> copies = librariesOf(read, folder);
    for (const QString& source : librariesOf(meant, sourceFolder)) {
        if (std::find(copies.begin(), copies.end(), source) != copies.end()) {
            continue;  // it is referred to
        }
        const QByteArray content = contentOf(source);
        const bool isThere = !definesMaterials(viewOf(content)) ||
                             std::any_of(copies.begin(), copies.end(), [&content](const QString& copy) {
                                 return isCopy(contentOf(copy), content);
                             });
        if (!isThere) {
            return "the material file \"" + QFileInfo(source).fileName().toStdString() +
                   "\" is not there as it is in the mesh's folder";
        }
    }
    return std::nullopt;
}

/// As far as the last digits of an MTL's numbers, which its readers round in their own ways.
bool isNear(float is, float meant) {
    constexpr float kRounding = 4.0e-7f;
    return std::abs(is - meant) <= kRounding * std::max(1.0f, std::abs(meant));
}

bool isNear(const glm::vec3& is, const glm::vec3& meant) {
    return isNear(is.x, meant.x) && isNear(is.y, meant.y) && isNear(is.z, meant.z);
}

Unlikeness numberDifference(const Material& is, const Material& meant) {
    if (!isNear(is.ambient, meant.ambient) || !isNear(is.diffuse, meant.diffuse) ||
        !isNear(is.specular, meant.specular)) {
        return "has another colour";
    }
    if (!isNear(is.shininess, meant.shininess)) {
        return "has another shininess";
    }
    if (!isNear(is.opacity, meant.opacity)) {
        return "has another opacity";
    }
    const MetalRoughness& metal = meant.metalRoughness;
    if (is.metalRoughness.isGiven() != metal.isGiven() ||
        (metal.isGiven() && !(isNear(is.metalRoughness.metalness, metal.metalness) &&
                              isNear(is.metalRoughness.roughness, metal.roughness)))) {
        return "has another metalness or roughness";
    }
    const bool hasMap = !is.normalMap.texture.empty() && meant.normalMap.image >= 0;
    return hasMap && !isNear(is.normalMap.strength, meant.normalMap.strength)
               ? Unlikeness("has another strength of its normal map")
               : std::nullopt;
}

/// A picture of a material, in the mesh and in its file.
struct Picture {
    const std::string& name;
    int image;
};

class PictureComparison {
public:
    PictureComparison(const MeshData& read, const MeshData& meant, const QString& sourceFolder,
                      const QString& folder)
        : m_read(read), m_meant(meant), m_sourceFolder(sourceFolder), m_folder(folder) {}

    [[nodiscard]] Unlikeness ofTexture(const Material& is, const Material& meant) const {
        return areSame({is.diffuseTexture, is.diffuseImage}, {meant.diffuseTexture, meant.diffuseImage})
                   ? std::nullopt
                   : Unlikeness("has another texture");
    }
    [[nodiscard]] Unlikeness of(const Material& is, const Material& meant) const {
        const auto differ = [this](const Picture& one, const Picture& other) { return !areSame(one, other); };
        if (Unlikeness difference = ofTexture(is, meant)) {
            return difference;
        }
        if (differ({is.normalMap.texture, is.normalMap.image},
                   {meant.normalMap.texture, meant.normalMap.image})) {
            return "has another normal map";
        }
        return differ({is.metalRoughness.texture, is.metalRoughness.image},
                      {meant.metalRoughness.texture, meant.metalRoughness.image})
                   ? Unlikeness("has another map of metalness and roughness")
                   : std::nullopt;
    }

private:
    /// What is not shown may be anything. A file may have changed since it was opened, and is copied as it
    /// is.
    [[nodiscard]] bool areSame(const Picture& is, const Picture& meant) const {
        if (meant.image < 0) {
            return true;
        }
        if (is.image < 0) {
            return false;
        }
        const Image& now = m_read.images[static_cast<std::size_t>(is.image)];
        const Image& then = m_meant.images[static_cast<std::size_t>(meant.image)];
        if (now.width == then.width && now.height == then.height && now.pixels == then.pixels) {
            return true;
        }
        const QString copy = resolveTexture(m_folder, fileNameText(is.name));
        const QString source =
            m_sourceFolder.isEmpty() ? QString() : resolveTexture(m_sourceFolder, fileNameText(meant.name));
        return !copy.isEmpty() && !source.isEmpty() && haveSameContent(copy, source);
    }

    const MeshData& m_read;
    const MeshData& m_meant;
    const QString& m_sourceFolder;
    const QString& m_folder;
};

}  // namespace

std::optional<std::string> materialDifference(const MeshData& read, const MeshExport& what,
                                              const QString& path) {
    const MeshData& mesh = *what.mesh;
    const QString sourceFolder = sourceFolderOf(what);
    const QString folder = QFileInfo(path).absolutePath();
    const bool areCopied = !sourceFolder.isEmpty() && !mesh.materialLibraries.empty();
    if (areCopied) {
        if (Unlikeness difference = libraryDifference(read, mesh, sourceFolder, folder)) {
            return difference;
        }
    }
    const PictureComparison pictures(read, mesh, sourceFolder, folder);
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    for (std::size_t f = 0; f < mesh.faceMaterials.size() && f < read.faceMaterials.size(); ++f) {
        const std::uint32_t is = read.faceMaterials[f];
        const std::uint32_t meant = mesh.faceMaterials[f];
        const bool isNew = is != kNoIndex && meant != kNoIndex && known.emplace(is, meant).second;
        if (!isNew) {
            continue;
        }
        const Material& now = read.materials[is];
        Unlikeness difference = areCopied ? std::nullopt : numberDifference(now, mesh.materials[meant]);
        difference = difference ? difference : pictures.of(now, mesh.materials[meant]);
        if (difference) {
            return "the material \"" + now.name + "\" " + *difference;
        }
    }
    return std::nullopt;
}

std::optional<std::string> textureDifference(const MeshData& read, const MeshExport& what,
                                             const QString& path) {
    const MeshData& meant = *what.mesh;
    const auto textureOf = [](const MeshData& mesh) {
        return mesh.materials.size() == 1 ? nameOnLine(mesh.materials.front().diffuseTexture) : std::string();
    };
    const std::string is = textureOf(read);
    const std::string wanted = textureOf(meant);
    // Without texture coordinates none need be named.
    if (is == wanted || (is.empty() && meant.cornerTexcoords.empty())) {
        return std::nullopt;
    }
    const bool isPicture = meant.materials.size() == 1 && meant.materials.front().diffuseImage >= 0;
    if (isPicture && read.materials.size() == 1) {  // which may have got another name
        const QString sourceFolder = sourceFolderOf(what);
        const QString folder = QFileInfo(path).absolutePath();
        const Unlikeness difference = PictureComparison(read, meant, sourceFolder, folder)
                                          .ofTexture(read.materials.front(), meant.materials.front());
        return difference ? "the file " + *difference : difference;
    }
    return "it names the texture \"" + is + "\" and should name \"" + wanted + '"';
}

}  // namespace hitscope
