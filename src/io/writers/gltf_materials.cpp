// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/gltf_materials.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "io/file_scope.h"
#include "io/save_image.h"

namespace hitscope {
namespace {

constexpr std::uint8_t kCutOff = 128;  // of 255; the picture shows nothing where a texture has less opacity

bool isPng(const QByteArray& bytes) {
    return bytes.startsWith("\x89PNG\r\n\x1a\n");
}
bool isJpeg(const QByteArray& bytes) {
    return bytes.startsWith("\xff\xd8\xff");
}

/// Of a Blinn-Phong highlight of that exponent: alpha^2 = 2 / (n + 2), and glTF's roughness is the root of
/// alpha (Walter et al. 2007; glTF 2.0, appendix B). Without a highlight all is rough.
double roughnessOf(const Material& material) {
    const float brightest = std::max({material.specular.x, material.specular.y, material.specular.z});
    const double exponent = std::max(static_cast<double>(material.shininess), 0.0);
    return brightest > 0.0f ? std::pow(2.0 / (exponent + 2.0), 0.25) : 1.0;
}

bool hasHoles(const Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
        if (image.pixels[i] < kCutOff) {
            return true;
        }
    }
    return false;
}

double fraction(float value) {
    return std::clamp(static_cast<double>(value), 0.0, 1.0);
}

}  // namespace

/// The file itself where glTF can have it, else its pixels as PNG.
GltfMaterials::Picture GltfMaterials::find(const std::string& name, int image) const {
    const bool isPicture =
        std::find(m_mesh.pictureFiles.begin(), m_mesh.pictureFiles.end(), name) != m_mesh.pictureFiles.end();
    const QString source = isPicture && !m_place.sourceFolder.isEmpty()
                               ? resolveTexture(m_place.sourceFolder, fileNameText(name))
                               : QString();
    QFile file(source);
    if (!source.isEmpty() && QFileInfo(source).size() <= kMaxTextureBytes && file.open(QIODevice::ReadOnly)) {
        const QByteArray bytes = file.read(kMaxTextureBytes);
        if (isPng(bytes) || isJpeg(bytes)) {
            return {bytes, isJpeg(bytes), QFileInfo(source).fileName()};
        }
    }
    if (image < 0) {
        return {};
    }
    const QString base = name.empty() ? QStringLiteral("%1_texture%2").arg(m_place.baseName).arg(image + 1)
                                      : QFileInfo(fileNameText(name)).completeBaseName();
    return {encodePng(m_mesh.images[static_cast<std::size_t>(image)]), false, base + QStringLiteral(".png")};
}

Result<int> GltfMaterials::addPicture(const Picture& picture) {
    QJsonObject image;
    if (!m_isBeside) {
        const auto view =
            m_document.addView(1, static_cast<std::size_t>(picture.bytes.size()), gltf::kNeither,
                               [bytes = picture.bytes](PieceWriter& out, std::size_t) {
                                   out.put({bytes.constData(), static_cast<std::size_t>(bytes.size())});
                               });
        image = {{QStringLiteral("bufferView"), view},
                 {QStringLiteral("mimeType"),
                  picture.isJpeg ? QStringLiteral("image/jpeg") : QStringLiteral("image/png")},
                 {QStringLiteral("name"), picture.name}};
    } else {
        const QString path = m_files.freePath(picture.name, picture.bytes);
        if (!QFileInfo::exists(path)) {
            const std::string_view bytes(picture.bytes.constData(),
                                         static_cast<std::size_t>(picture.bytes.size()));
            if (const Status added = m_staged.add(path, bytes, StagedFiles::Existing::Keep); !added) {
                return added.error();
            }
        }
        const QString name = QDir(m_place.folder).relativeFilePath(path);
        image = {{QStringLiteral("uri"), QString::fromLatin1(QUrl::toPercentEncoding(name, "/"))}};
    }
    m_images.append(image);
    return static_cast<int>(m_images.size() - 1);
}

Result<int> GltfMaterials::texture(const std::string& name, int image) {
    if (name.empty() && image < 0) {
        return -1;
    }
    const auto known = m_known.find({name, image});
    if (known != m_known.end()) {
        return known->second;
    }
    const Picture picture = find(name, image);
    int index = -1;
    if (picture.bytes.isEmpty()) {
        m_notes +=
            QStringLiteral("The picture \"%1\" cannot be read; it is left out.").arg(fileNameText(name));
    } else {
        const Result<int> source = addPicture(picture);
        if (!source) {
            return source;
        }
        m_textures.append(QJsonObject{{QStringLiteral("source"), source.value()}});
        index = static_cast<int>(m_textures.size() - 1);
    }
    m_known.emplace(std::pair(name, image), index);
    return index;
}

QString GltfMaterials::alphaMode(const Material& material) const {
    if (material.opacity < 1.0f) {
        return QStringLiteral("BLEND");
    }
    const bool isCut = material.diffuseImage >= 0 &&
                       hasHoles(m_mesh.images[static_cast<std::size_t>(material.diffuseImage)]);
    return isCut ? QStringLiteral("MASK") : QStringLiteral("OPAQUE");
}

Status GltfMaterials::convert(const Material& material) {
    const MetalRoughness& metal = material.metalRoughness;
    const bool isGiven = metal.isGiven();
    QJsonObject surface{
        {QStringLiteral("baseColorFactor"),
         QJsonArray{fraction(material.diffuse.x), fraction(material.diffuse.y), fraction(material.diffuse.z),
                    fraction(material.opacity)}},
        {QStringLiteral("metallicFactor"), isGiven ? fraction(metal.metalness) : 0.0},
        {QStringLiteral("roughnessFactor"), isGiven ? fraction(metal.roughness) : roughnessOf(material)}};
    QJsonObject result{{QStringLiteral("alphaMode"), alphaMode(material)},
                       {QStringLiteral("doubleSided"), true}};  // as the program draws it
    const auto add = [this](QJsonObject& to, const char* key, const std::string& name, int image,
                            QJsonObject more) -> Status {
        const Result<int> index = texture(name, image);
        if (!index) {
            return index.error();
        }
        if (index.value() >= 0) {
            more[QStringLiteral("index")] = index.value();
            to[QLatin1String(key)] = more;
        }
        return Done{};
    };
    Status added = add(surface, "baseColorTexture", material.diffuseTexture, material.diffuseImage, {});
    if (added && isGiven) {
        added = add(surface, "metallicRoughnessTexture", metal.texture, metal.image, {});
    }
    if (added) {
        added = add(result, "normalTexture", material.normalMap.texture, material.normalMap.image,
                    {{QStringLiteral("scale"), static_cast<double>(material.normalMap.strength)}});
    }
    result[QStringLiteral("pbrMetallicRoughness")] = surface;
    if (!material.name.empty()) {
        result[QStringLiteral("name")] = fileNameText(material.name);
    }
    m_materials.append(result);
    return added;
}

Status GltfMaterials::make(bool plain) {
    for (const Material& material : m_mesh.materials) {
        if (Status converted = convert(material); !converted) {
            return converted;
        }
    }
    // glTF's own default is a metal, which is dark wherever nothing is mirrored. Colours of vertices are
    // multiplied with it.
    Material ours;
    ours.name = "DefaultMaterial";  // as Assimp calls such: our reader takes it for none
    ours.diffuse = m_mesh.colours.empty() ? ours.diffuse : glm::vec3(1.0f);
    return plain ? convert(ours) : Status(Done{});
}

int GltfMaterials::indexOf(std::uint32_t material) const {
    return static_cast<int>(material == kNoIndex ? m_mesh.materials.size() : material);
}

void GltfMaterials::addTo(QJsonObject& root) const {
    const auto add = [&root](const char* key, const QJsonArray& list) {
        if (!list.isEmpty()) {
            root[QLatin1String(key)] = list;
        }
    };
    add("materials", m_materials);
    add("textures", m_textures);
    add("images", m_images);
}

}  // namespace hitscope
