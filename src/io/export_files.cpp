// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/export_files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <map>

#include "io/file_scope.h"
#include "io/save_image.h"

namespace hitscope {
namespace {

bool hasContent(const QString& path, const QByteArray& content) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.size() == content.size() && file.readAll() == content;
}

class TexturePlacer {
public:
    TexturePlacer(const MeshData& mesh, QString sourceFolder, QString folder, QString baseName)
        : m_mesh(mesh),
          m_sourceFolder(std::move(sourceFolder)),
          m_folder(std::move(folder)),
          m_baseName(std::move(baseName)) {}

    /// The texture of that name, or else that image; both may be none.
    Result<std::string> place(const std::string& texture, int image);

private:
    Result<std::string> placeFile(const std::string& name, const QString& source);
    Result<std::string> placeImage(int image);
    Result<std::string> placeBytes(const QString& name, const QByteArray& bytes);
    [[nodiscard]] QString findSource(const QString& name) const;

    const MeshData& m_mesh;
    QString m_sourceFolder;
    QString m_folder;
    QString m_baseName;
    std::map<int, std::string> m_placedImages;  ///< each once, whatever number of materials use it
};

QString TexturePlacer::findSource(const QString& name) const {
    if (m_sourceFolder.isEmpty() || name.isEmpty()) {
        return {};
    }
    const QString direct = resolveInside(m_sourceFolder, name);
    QString local = name;
    local.replace(QLatin1Char('\\'), QLatin1Char('/'));
    return direct.isEmpty() ? resolveInside(m_sourceFolder, QFileInfo(local).fileName()) : direct;
}

Result<std::string> TexturePlacer::placeBytes(const QString& name, const QByteArray& bytes) {
    const QString path = freePath(m_folder, name, bytes);
    if (!QFileInfo::exists(path)) {
        if (const Status written =
                writeWhole(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
            !written) {
            return written.error();
        }
    }
    return QFileInfo(path).fileName().toStdString();
}

Result<std::string> TexturePlacer::placeFile(const std::string& name, const QString& source) {
    if (resolveInside(m_folder, QString::fromStdString(name)) == source) {
        return name;  // the export goes to the mesh's own folder
    }
    QFile file(source);
    if (!file.open(QIODevice::ReadOnly)) {
        return name;
    }
    return placeBytes(QFileInfo(source).fileName(), file.readAll());
}

Result<std::string> TexturePlacer::placeImage(int image) {
    const auto known = m_placedImages.find(image);
    if (known != m_placedImages.end()) {
        return known->second;
    }
    const QString name = QStringLiteral("%1_texture%2.png").arg(m_baseName).arg(image + 1);
    Result<std::string> placed = placeBytes(name, encodePng(m_mesh.images[static_cast<std::size_t>(image)]));
    if (placed) {
        m_placedImages.emplace(image, placed.value());
    }
    return placed;
}

Result<std::string> TexturePlacer::place(const std::string& texture, int image) {
    const QString source = findSource(QString::fromStdString(texture));
    if (!source.isEmpty()) {
        return placeFile(texture, source);
    }
    return image >= 0 ? placeImage(image) : Result<std::string>(texture);
}

}  // namespace

Status writeWhole(const QString& path, std::string_view content) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) &&
        file.write(content.data(), static_cast<qint64>(content.size())) ==
            static_cast<qint64>(content.size()) &&
        file.commit()) {
        return Done{};
    }
    return Error{"The file cannot be saved: " + file.errorString().toStdString() + ".", path.toStdString(),
                 "Choose a folder that exists, that you may write to and that has room."};
}

QString freePath(const QString& folder, const QString& name, const QByteArray& content) {
    const QDir dir(folder);
    const QFileInfo info(name);
    const QString suffix = info.suffix().isEmpty() ? QString() : QLatin1Char('.') + info.suffix();
    QString path = dir.filePath(name);
    for (int n = 1; QFileInfo::exists(path) && !hasContent(path, content); ++n) {
        path = dir.filePath(QStringLiteral("%1-%2%3").arg(info.completeBaseName()).arg(n).arg(suffix));
    }
    return path;
}

Result<std::vector<PlacedTextures>> placeTextures(const MeshData& mesh, const QString& sourceFolder,
                                                  const QString& folder, const QString& baseName) {
    TexturePlacer placer(mesh, sourceFolder, folder, baseName);
    std::vector<PlacedTextures> placed;
    for (const Material& material : mesh.materials) {
        Result<std::string> diffuse = placer.place(material.diffuseTexture, material.diffuseImage);
        if (!diffuse) {
            return diffuse.error();
        }
        Result<std::string> normals = placer.place(material.normalMap.texture, material.normalMap.image);
        if (!normals) {
            return normals.error();
        }
        placed.push_back({std::move(diffuse.value()), std::move(normals.value())});
    }
    return placed;
}

}  // namespace hitscope
