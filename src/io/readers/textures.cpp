// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/textures.h"

#include <QFile>
#include <QImage>
#include <unordered_map>
#include <unordered_set>

#include "io/decode_picture.h"
#include "io/file_scope.h"

namespace hitscope {
namespace {

constexpr std::size_t kMaxAllPixelBytes = 1ull << 30;  // of all pictures of a mesh, decoded

/// Null: `why` says why.
QImage decodeFile(const QString& path, QString& why) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        why = file.errorString();
        return {};
    }
    if (file.size() > kMaxTextureBytes) {
        why = QStringLiteral("the file is too large");
        return {};
    }
    return decodePicture(file.readAll(), why);
}

std::optional<Image> readPicture(const QString& path, QString& why) {
    const QImage decoded = decodeFile(path, why);
    return decoded.isNull() ? std::nullopt : std::optional(imageOf(decoded));
}

}  // namespace

std::optional<Image> decodeImage(const QByteArray& bytes, QString& why) {
    const QImage decoded = decodePicture(bytes, why);
    return decoded.isNull() ? std::nullopt : std::optional(imageOf(decoded));
}

namespace {

/// Reads each file once, whoever refers to it, and notes which are pictures.
class TextureReader {
public:
    TextureReader(ImportedMesh& imported, const QString& folder) : m_imported(imported), m_folder(folder) {}

    /// Of a map that is not drawn: whether its file is a picture, which only decoding it tells.
    void look(const QString& name) {
        if (m_known.contains(name.toStdString()) || !m_looked.insert(name.toStdString()).second) {
            return;
        }
        const QString path = resolveTexture(m_folder, name);
        QString why;
        if (!path.isEmpty() && !decodeFile(path, why).isNull()) {
            m_imported.mesh.pictureFiles.push_back(name.toStdString());
        }
    }

    /// Index of the image, or -1. `what`: "texture", as the note calls one that is not shown.
    int read(const std::string& texture, const QString& what) {
        const auto [at, isNew] = m_known.try_emplace(texture, -1);
        if (isNew) {
            const QString name = fileNameText(texture);
            const QString path = resolveTexture(m_folder, name);
            QString why = QStringLiteral("it is not in the mesh's folder");
            std::optional<Image> image = path.isEmpty() ? std::nullopt : readPicture(path, why);
            if (image) {
                m_imported.mesh.pictureFiles.push_back(texture);
            }
            if (image && m_pixelBytes + image->pixels.size() > kMaxAllPixelBytes) {
                why = QStringLiteral("the mesh's textures take more than a gigabyte together");
                image.reset();
            }
            if (image) {
                m_pixelBytes += image->pixels.size();
                at->second = static_cast<int>(m_imported.mesh.images.size());
                m_imported.mesh.images.push_back(std::move(*image));
            } else {
                m_imported.notes += QStringLiteral("The %1 \"%2\" is not shown: %3.").arg(what, name, why);
            }
        }
        return at->second;
    }

private:
    ImportedMesh& m_imported;
    const QString& m_folder;
    std::unordered_map<std::string, int> m_known;
    std::unordered_set<std::string> m_looked;
    std::size_t m_pixelBytes = 0;
};

/// Heights are grey; normals are bluish.
bool isGrey(const Image& image) {
    for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
        if (image.pixels[i] != image.pixels[i + 1] || image.pixels[i] != image.pixels[i + 2]) {
            return false;
        }
    }
    return true;
}

void makeOpaque(Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        image.pixels[i] = 255;
    }
}

/// Where a texture is transparent there is no surface; some have something else where others have opacity.
void makeOpaque(ImportedMesh& imported) {
    MeshData& mesh = imported.mesh;
    std::vector<bool> isOpaque(mesh.materials.size(), false);
    for (const std::size_t material : imported.opaqueMaterials) {
        if (material < isOpaque.size()) {
            isOpaque[material] = true;
        }
    }
    for (std::size_t i = 0; i < mesh.images.size(); ++i) {
        std::size_t opaque = 0;
        std::size_t others = 0;
        for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
            if (mesh.materials[m].diffuseImage == static_cast<int>(i)) {
                ++(isOpaque[m] ? opaque : others);
            }
        }
        if (opaque > 0 && others == 0) {
            makeOpaque(mesh.images[i]);
        }
    }
}

}  // namespace

void readTextures(ImportedMesh& imported, const QString& folder, const QStringList& others) {
    TextureReader reader(imported, folder);
    for (Material& material : imported.mesh.materials) {
        if (!material.diffuseTexture.empty() && material.diffuseImage < 0) {
            material.diffuseImage = reader.read(material.diffuseTexture, QStringLiteral("texture"));
        }
        if (MetalRoughness& metal = material.metalRoughness; !metal.texture.empty() && metal.image < 0) {
            metal.image = reader.read(metal.texture, QStringLiteral("map of metalness and roughness"));
        }
        NormalMap& map = material.normalMap;
        if (map.texture.empty() || map.image >= 0) {
            continue;
        }
        map.image = reader.read(map.texture, QStringLiteral("normal map"));
        if (map.image >= 0 && isGrey(imported.mesh.images[static_cast<std::size_t>(map.image)])) {
            map.image = -1;
            imported.notes +=
                QStringLiteral("The bump map \"%1\" is not shown: it holds heights, not normals.")
                    .arg(fileNameText(map.texture));
        }
    }
    makeOpaque(imported);
    for (const QString& name : others) {
        reader.look(name);
    }
}

}  // namespace hitscope
